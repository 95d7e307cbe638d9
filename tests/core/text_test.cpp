#include "core/text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {
namespace {

TEST(Text, numbers_are_written_in_the_shortest_form_that_reads_back) {
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(0.1f), "0.1");
    EXPECT_EQ(number_text(static_cast<double>(0.1f)), "0.10000000149011612");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(-0.0), "-0");
}

TEST(Text, any_number_reads_back_as_the_same_bits) {
    std::mt19937_64 bits(2008);
    for (int finite = 0; finite < 20000;) {
        const double value = __builtin_bit_cast(double, bits());
        if (!std::isfinite(value)) continue;
        ++finite;
        const auto back = parse_number(number_text(value));
        ASSERT_TRUE(back.has_value());
        ASSERT_EQ(__builtin_bit_cast(std::uint64_t, *back), __builtin_bit_cast(std::uint64_t, value));
    }
}

TEST(Text, only_whole_decimal_numbers_are_numbers) {
    for (const char* text : {"1", "+1", "-1.5", "1e-3", ".5", "5."})
        EXPECT_TRUE(parse_number(text).has_value()) << text;
    for (const char* text : {"", " 1", "1 ", "1,5", "1.0x", "0x10", "+-1", "--1", "one", "1e", "1e999"}) {
        EXPECT_FALSE(parse_number(text).has_value()) << text;
    }
}

TEST(Text, an_unknown_word_is_answered_with_the_nearest_and_all_known_ones) {
    const std::string_view known[] = {"chain", "mesh", "rope"};
    EXPECT_EQ(unknown_word("model", "chian", known),
              "unknown model 'chian' (did you mean 'chain'?); known: chain, mesh, rope");
    EXPECT_EQ(unknown_word("model", "pendulum", known), "unknown model 'pendulum'; known: chain, mesh, rope");
    EXPECT_EQ(unknown_word("model", "", known), "unknown model ''; known: chain, mesh, rope");
    EXPECT_EQ(unknown_word("parameter", "r", {}), "unknown parameter 'r'; there is none");
}

TEST(Text, an_unknown_word_among_very_many_is_answered_with_some_of_them) {
    std::vector<std::string> names(100000);
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = "group" + std::to_string(i);
    const std::string text =
        unknown_word("group", "group99999x", std::vector<std::string_view>(names.begin(), names.end()));
    EXPECT_LT(text.size(), 1000U);
    EXPECT_TRUE(text.ends_with("group59 ... (100000 in all)")) << text;
    EXPECT_NE(text.find("did you mean 'group99999'?"), std::string::npos);
}

}  // namespace
}  // namespace steplab
