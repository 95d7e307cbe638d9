#include "ui/widgets/format.hpp"

#include "ui/rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

TEST(format, rounding_noise_of_a_vector_is_zero) {
    EXPECT_EQ(vector({0, 0.11, 0}), "(0, 0.11, 0)");
    EXPECT_EQ(vector({1e-17, 2, -1}), "(0, 2, -1)");
    EXPECT_EQ(vector({123.4, 0.5, 2e-5}), "(123, 0.5, 2e-5)");
    EXPECT_EQ(vector({1e-17, 2e-17, 0}), "(1e-17, 2e-17, 0)");
}

TEST(format, time_shows_what_a_step_changes) {
    EXPECT_EQ(time_text(12.3, 0.1), "12.300");
    EXPECT_EQ(time_text(12.3, 0.0001), "12.300000");
    EXPECT_EQ(time_text(300, 5), "300.00");
}

TEST(format, correct_digits_are_those_of_the_scene) {
    EXPECT_NEAR(correct_digits(1e-5, 2, Precision::double_).value(), 5.30, 0.005);
    EXPECT_EQ(correct_digits(3, 1, Precision::double_), 0);
    EXPECT_FALSE(correct_digits(-1, 1, Precision::double_).has_value());
    EXPECT_FALSE(correct_digits(1, 0, Precision::double_).has_value());
    EXPECT_FALSE(correct_digits(NAN, 1, Precision::double_).has_value());
}

// Half a unit in the last place is 2^-24 and 2^-53 of a number: 7.22 and 15.95 digits.
TEST(format, correct_digits_end_where_those_of_the_precision_do) {
    for (const double error : {0.0, 1e-300, 1e-18}) {
        EXPECT_EQ(correct_digits(error, 3.4, Precision::float_), 7.2) << error;
        EXPECT_EQ(correct_digits(error, 3.4, Precision::double_), 15.9) << error;
    }
    EXPECT_EQ(digits_text(correct_digits(3e-18, 0.5, Precision::double_).value()), "15.9 correct digits so far");
}

TEST(format, less_than_one_correct_digit_is_wrong) {
    EXPECT_EQ(digits_text(correct_digits(3.4, 4.3, Precision::double_).value()), "wrong: not one correct digit");
    EXPECT_EQ(digits_text(1), "1.0 correct digits so far");
}

TEST(format, dragged_values_are_short_to_write) {
    EXPECT_EQ(rounded_for_slider(0.123456, 1e-4, 10, true), 0.123);
    EXPECT_EQ(rounded_for_slider(1234.5, 1e-4, 1e4, true), 1230);
    EXPECT_EQ(rounded_for_slider(3.14159, 0, 10, false), 3.1);
    EXPECT_EQ(rounded_for_slider(0, 0, 10, false), 0);
}

TEST(format, counts_are_shown_in_full_up_to_a_million) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(1104), "1104");
    EXPECT_EQ(count_text(999'999), "999999");
    EXPECT_EQ(count_text(999'999.7), "1.0e6");
    EXPECT_EQ(count_text(1'234'567), "1.23e6");
}

TEST(format, frequencies_have_two_digits_and_large_ones_are_counts) {
    EXPECT_EQ(frequency_text(0.123), "0.12");
    EXPECT_EQ(frequency_text(31.85), "32");
    EXPECT_EQ(frequency_text(99.6), "100");
    EXPECT_EQ(frequency_text(3185.05), "3185");
    EXPECT_EQ(frequency_text(1'234'567), "1.23e6");
}

TEST(format, errors_have_two_significant_digits) {
    EXPECT_EQ(error_text(0.1), "0.10");
    EXPECT_EQ(error_text(0.31), "0.31");
    EXPECT_EQ(error_text(5), "5.0");
    EXPECT_EQ(error_text(-0.2), "-0.20");
    EXPECT_EQ(error_text(0.0996), "0.10");
    EXPECT_EQ(error_text(9.96), "10");
    EXPECT_EQ(error_text(2.1e-7), "2.1e-7");
    EXPECT_EQ(error_text(1e-3), "1.0e-3");
    EXPECT_EQ(error_text(0), "0");
    EXPECT_EQ(error_text(NAN), "not a number");
}

TEST(rate, keys_step_through_nice_numbers) {
    Rate rate;
    std::vector<double> up;
    for (int i = 0; i < 4; ++i) {
        rate = faster(rate);
        up.push_back(rate.seconds_per_second);
    }
    EXPECT_EQ(up, (std::vector<double>{2, 5, 10, 20}));
    for (int i = 0; i < 5; ++i) rate = slower(rate);
    EXPECT_DOUBLE_EQ(rate.seconds_per_second, 0.5);
}

TEST(rate, above_the_fastest_is_unlimited_and_back) {
    Rate rate{false, fastest};
    rate = faster(rate);
    EXPECT_TRUE(rate.as_fast_as_possible);
    EXPECT_TRUE(faster(rate).as_fast_as_possible);
    rate = slower(rate);
    EXPECT_FALSE(rate.as_fast_as_possible);
    EXPECT_EQ(rate.seconds_per_second, fastest);
    for (int i = 0; i < 100; ++i) rate = slower(rate);
    EXPECT_EQ(rate.seconds_per_second, slowest);
}

TEST(rate, is_written_as_a_multiple_of_real_time) {
    EXPECT_EQ(rate_text(1), "1.0x real time");
    EXPECT_EQ(rate_text(0.02), "0.02x real time");
    EXPECT_EQ(rate_text(fastest), "1000x real time");
}

TEST(rate, a_speed_in_between_moves_to_the_next) {
    EXPECT_EQ(faster({false, 3}).seconds_per_second, 5);
    EXPECT_EQ(slower({false, 3}).seconds_per_second, 2);
}

}  // namespace
}  // namespace steplab::ui
