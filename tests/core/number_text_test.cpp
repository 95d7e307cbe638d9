#include "core/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab {
namespace {

TEST(ReadableNumber, is_a_decimal_where_that_is_short) {
    EXPECT_EQ(readable(0), "0");
    EXPECT_EQ(readable(0.2123), "0.21");
    EXPECT_EQ(readable(3.1), "3.1");
    EXPECT_EQ(readable(0.001), "0.001");
    EXPECT_EQ(readable(68.1, 4), "68.1");
    EXPECT_EQ(readable(1234), "1234");
    EXPECT_EQ(readable(-0.05), "-0.05");
}

// No "1e-06" and no "1.0·10⁻⁶": a power of ten is that alone.
// The sign of what is no number means nothing, and differs between machines.
TEST(NumberText, has_no_sign_of_what_is_no_number) {
    const double none = std::nan("");
    for (const double value : {none, -none}) {
        EXPECT_EQ(number_text(value), "nan");
        EXPECT_EQ(number_text(static_cast<float>(value)), "nan");
        EXPECT_EQ(typed(value), "nan");
        EXPECT_EQ(readable(value), "not a number");
        EXPECT_EQ(short_number(value), "not a number");
    }
    EXPECT_EQ(short_number(HUGE_VAL), "∞");
    EXPECT_EQ(typed(-HUGE_VAL), "-inf");
}

TEST(ReadableNumber, has_raised_digits_elsewhere) {
    EXPECT_EQ(readable(1e-6), "10⁻⁶");
    EXPECT_EQ(readable(2.34e-7), "2.3·10⁻⁷");
    EXPECT_EQ(readable(9.97e-7), "10⁻⁶");
    EXPECT_EQ(readable(9.9999e-4), "0.001");
    EXPECT_EQ(readable(3e12), "3·10¹²");
}

TEST(ReadableNumber, can_be_typed) {
    EXPECT_EQ(typed(1e-6), "1e-6");
    EXPECT_EQ(typed(2.34e-17), "2.3e-17");
    EXPECT_EQ(typed(0.89605, 3), "0.896");
    EXPECT_EQ(typed(0.01), "0.01");
}

TEST(ReadableNumber, of_a_sentence_has_as_many_digits_as_asked_for) {
    EXPECT_EQ(significant(1.43377, 4), "1.434");
    EXPECT_EQ(significant(0.1, 4), "0.1");
    EXPECT_EQ(significant(120000, 6), "120000");
    EXPECT_EQ(significant(-1.25e-7, 4), "-1.25e-7");
    EXPECT_EQ(significant(4.73e11, 3), "4.73e11");
    EXPECT_EQ(significant(1e-300, 3), "1e-300");
}

// Every number that a person reads: none has an exponent with a sign or zeros in front.
TEST(ReadableNumber, exponents_are_plain) {
    for (int exponent = -307; exponent <= 307; ++exponent) {
        const double value = 1.2345678 * std::pow(10.0, exponent);
        for (const std::string& text : {exact_text(value), significant(value, 3), typed(value), setting_text(value),
                                        reading_text(value), rounded_text(value), short_number(value)}) {
            EXPECT_EQ(text.find("e+"), text.npos) << text;
            EXPECT_EQ(text.find("e0"), text.npos) << text;
            EXPECT_EQ(text.find("e-0"), text.npos) << text;
        }
        EXPECT_EQ(parse_number(exact_text(value)), value) << "exact_text() loses nothing";
    }
}

TEST(ReadableNumber, counts_in_groups_of_three) {
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(12345678), "12\u202f345\u202f678");
}

TEST(SettingText, is_short) {
    EXPECT_EQ(setting_text(2), "2.0");
    EXPECT_EQ(setting_text(0.25), "0.25");
    EXPECT_EQ(setting_text(9.81), "9.81");
    EXPECT_EQ(setting_text(1.9e6, 2), "1.9e6");
    EXPECT_EQ(setting_text(1.5e-5), "1.5e-5");
    EXPECT_EQ(setting_text(0), "0");
    EXPECT_EQ(setting_text(-3), "-3.0");
    EXPECT_EQ(setting_text(INFINITY), "∞");
    EXPECT_EQ(setting_text(NAN), "not a number");
    EXPECT_EQ(setting_text(1e300), "1.0e300");
}

TEST(ReadingText, keeps_its_width) {
    EXPECT_EQ(reading_text(0.5), "0.500");
    EXPECT_EQ(reading_text(0.2134), "0.213");
    EXPECT_EQ(reading_text(12.34), "12.3");
    EXPECT_EQ(reading_text(123.4), "123");
    EXPECT_EQ(reading_text(1e-7), "1.00e-7");
    EXPECT_EQ(reading_text(0), "0");
}

TEST(RoundedText, has_two_digits) {
    EXPECT_EQ(rounded_text(2.14e-7), "2.1e-7");
    EXPECT_EQ(rounded_text(-0.314), "-0.31");
    EXPECT_EQ(rounded_text(4.44), "4.4");
    EXPECT_EQ(rounded_text(123), "123");
    EXPECT_EQ(rounded_text(123456), "1.2e5");
    EXPECT_EQ(rounded_text(0), "0");
    EXPECT_EQ(rounded_text(INFINITY), "∞");
}

}  // namespace
}  // namespace steplab
