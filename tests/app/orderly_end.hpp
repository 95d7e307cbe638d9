// How a program has to end where memory is limited.
#pragma once

#include "app/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace steplab {

/// The least memory at which the program gets as far as its own first line: what the system and the loader say below it
/// is not ours.
inline unsigned long least_megabytes() {
    unsigned long megabytes = 4;
    while (run_program({"--version"}, {.most_memory = megabytes << 20}).code != 0) ++megabytes;
    return megabytes;
}

/// One line, a code of the contract.
inline void expect_orderly_end(const Outcome& outcome, const std::string& where) {
    EXPECT_EQ(outcome.signal, 0) << where << ": " << outcome.err;
    EXPECT_TRUE((std::set{0, 2, 3}.count(outcome.code) == 1)) << where << ": code " << outcome.code;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), outcome.code == 0 ? 0 : 1) << outcome.err;
}

}  // namespace steplab
