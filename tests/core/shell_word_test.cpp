#include "core/shell_word.hpp"

#include "core/shown.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <random>
#include <string>

namespace steplab {
namespace {

/// What a shell makes of the word.
std::string read_by_a_shell(const std::string& word) {
    std::string command = "bash -c 'printf %s ";
    for (const char c : word) command += c == '\'' ? std::string("'\\''") : std::string(1, c);
    command += "'";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string text;
    std::array<char, 256> piece;
    for (std::size_t got; (got = std::fread(piece.data(), 1, piece.size(), pipe.get())) > 0;)
        text.append(piece.data(), got);
    return text;
}

TEST(ShellWord, is_plain_where_a_shell_takes_it) {
    EXPECT_EQ(shell_word("a/b-1.toml"), "a/b-1.toml");
    EXPECT_EQ(shell_word("two words"), "'two words'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word("a\\b"), "'a\\b'");
}

TEST(ShellWord, holds_nothing_that_a_terminal_obeys_and_is_read_as_it_was) {
    EXPECT_EQ(shell_word("a\x1b[2J"), "$'a\\x1b[2J'");
    EXPECT_EQ(shell_word("a\n'b\\"), "$'a\\x0a\\'b\\\\'");
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        std::string text(1 + random() % 12, ' ');
        for (char& c : text) c = static_cast<char>(1 + random() % 255);
        const std::string word = shell_word(text);
        EXPECT_EQ(safe_message(word), word);
        EXPECT_EQ(word.find('\n'), std::string::npos);
        EXPECT_EQ(read_by_a_shell(word), text) << word;
    }
}

}  // namespace
}  // namespace steplab
