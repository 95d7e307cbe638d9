// Names of files that a terminal would obey, and what the programs may print of them.
#pragma once

#include "app/program.hpp"
#include "core/shown.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace steplab {

/// Clears a screen, sets a title, begins a line of its own, and holds bytes that are no UTF-8.
inline std::string hostile_name(const std::string& ending) {
    return "a\x1b[2J\x1b]0;t\a\n~own line\x7f\x9b\xff" + ending;
}

/// Text for people: every character as a terminal may be given it, and the name in the middle of its line.
inline bool is_safe(const std::string& text) {
    return safe_message(text) == text && text.find('\t') == std::string::npos && !text.starts_with('~') &&
           text.find("\n~") == std::string::npos;
}

/// The program did its work, and neither of its streams holds anything that a terminal would obey.
inline void expect_safe_success(const std::vector<std::string>& words, const Surroundings& surroundings) {
    const Outcome outcome = run_program(words, surroundings);
    EXPECT_EQ(outcome.code, 0) << testing::PrintToString(words) << safe_message(outcome.err);
    const bool data = std::find_if(words.begin(), words.end(), [](const std::string& word) {
                          return word == "-" || word == "--json";
                      }) != words.end();  // may hold what its format allows
    EXPECT_TRUE(data || is_safe(outcome.out)) << words[0] << ": " << safe_message(outcome.out);
    EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos) << words[0];
    EXPECT_TRUE(is_safe(outcome.err)) << words[0] << ": " << safe_message(outcome.err);
}

}  // namespace steplab
