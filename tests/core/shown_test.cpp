#include "core/shown.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>
#include <string>

namespace steplab {
namespace {

TEST(Shown, leaves_text_as_it_is) {
    for (const std::string text : {"", "a b", "chain.csv", "n='20'", "\\x1b", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x99\x82"})
        EXPECT_EQ(shown(text), text);
}

TEST(Shown, escapes_what_terminals_obey_and_what_is_no_text) {
    EXPECT_EQ(shown("a\x1b[31mb\n\r\t\x7f"), "a\\x1b[31mb\\x0a\\x0d\\x09\\x7f");
    EXPECT_EQ(shown(std::string("\0", 1)), "\\x00");
    EXPECT_EQ(shown("\xc2\x9b"), "\\xc2\\x9b");           // a control character of two bytes
    EXPECT_EQ(shown("\xe2\x80\xae"), "\\xe2\\x80\\xae");  // turns the direction of writing
    EXPECT_EQ(shown("\xff\xc3"), "\\xff\\xc3");           // no UTF-8, and cut
    EXPECT_EQ(shown("\xc0\xaf"), "\\xc0\\xaf");           // "/" in more bytes than it needs
    EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
    EXPECT_EQ(shown("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(Shown, leaves_the_middle_of_a_long_text_out) {
    const std::string text = shown("begin" + std::string(5000, 'x') + "end");
    EXPECT_EQ(text.size(), 203u);
    EXPECT_TRUE(text.starts_with("beginxxx"));
    EXPECT_TRUE(text.ends_with("xxxend"));
    EXPECT_NE(text.find("x...x"), std::string::npos);
    EXPECT_EQ(shown(std::string(200, 'x')), std::string(200, 'x'));
    std::string umlauts;
    for (int i = 0; i < 300; ++i) umlauts += "\xc3\xa4";
    EXPECT_EQ(shown(umlauts).find('\\'), std::string::npos);  // none is cut in two
}

TEST(Shown, lets_no_control_character_through_whatever_the_bytes) {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        std::string text(random() % 12, '\0');
        for (char& c : text) c = static_cast<char>(random());
        for (const std::string& safe : {shown(text), safe_message(text)}) {
            const bool control = std::any_of(safe.begin(), safe.end(), [](unsigned char c) {
                return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f;
            });
            ASSERT_FALSE(control);
            ASSERT_EQ(safe_message(safe), safe);
        }
        ASSERT_EQ(shown(text).find('\n'), std::string::npos);
    }
}

TEST(SafeMessage, keeps_lines) { EXPECT_EQ(safe_message("a\n\tb\x1b"), "a\n\tb\\x1b"); }

/// What write_safely() makes of texts.
std::string written_safely(std::initializer_list<std::string_view> texts) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
    write_safely(file.get(), texts);
    std::string text(static_cast<std::size_t>(std::ftell(file.get())), '\0');
    std::rewind(file.get());
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file.get()), text.size());
    return text;
}

TEST(WriteSafely, writes_what_safe_message_makes_of_all_texts) {
    EXPECT_EQ(written_safely({"steplab", ": ", "a\x1b\n", "\xc3\xa4"}), "steplab: a\\x1b\n\xc3\xa4");
    std::mt19937 random(1);
    for (const std::size_t length : {0U, 1U, 1000U, 4095U, 4096U, 4097U, 20000U}) {
        std::string text(length, '\0');
        for (char& c : text) c = static_cast<char>(random());
        EXPECT_EQ(written_safely({text, "\n", text}), safe_message(text) + "\n" + safe_message(text)) << length;
    }
}

}  // namespace
}  // namespace steplab
