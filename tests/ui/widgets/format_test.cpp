#include "ui/widgets/format.hpp"

#include "ui/rate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

TEST(format, values_that_are_set_are_short) {
    EXPECT_EQ(number(2), "2.0");
    EXPECT_EQ(number(0.25), "0.25");
    EXPECT_EQ(number(9.81), "9.81");
    EXPECT_EQ(number(1.9e6, 2), "1.9e6");
    EXPECT_EQ(number(1.5e-5), "1.5e-5");
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(-3), "-3.0");
    EXPECT_EQ(number(INFINITY), "∞");
    EXPECT_EQ(number(NAN), "not a number");
    EXPECT_EQ(number(1e300), "1.0e300");
}

TEST(format, readings_keep_their_width) {
    EXPECT_EQ(reading(0.5), "0.500");
    EXPECT_EQ(reading(0.2134), "0.213");
    EXPECT_EQ(reading(12.34), "12.3");
    EXPECT_EQ(reading(123.4), "123");
    EXPECT_EQ(reading(1e-7), "1.00e-7");
}

TEST(format, errors_have_two_digits) {
    EXPECT_EQ(scientific(2.14e-7), "2.1e-7");
    EXPECT_EQ(scientific(-0.314), "-0.31");
    EXPECT_EQ(scientific(4.44), "4.4");
    EXPECT_EQ(scientific(123456), "1.2e5");
    EXPECT_EQ(scientific(0), "0");
}

TEST(format, rounding_noise_of_a_vector_is_zero) {
    EXPECT_EQ(vector({0, 0.11, 0}), "(0, 0.11, 0)");
    EXPECT_EQ(vector({1e-17, 2, -1}), "(0, 2, -1)");
    EXPECT_EQ(vector({1e-17, 2e-17, 0}), "(1e-17, 2e-17, 0)");
}

TEST(format, time_shows_what_a_step_changes) {
    EXPECT_EQ(time_text(12.3, 0.1), "12.300");
    EXPECT_EQ(time_text(12.3, 0.0001), "12.300000");
    EXPECT_EQ(time_text(300, 5), "300.00");
}

TEST(format, digits_right_are_those_of_the_scene) {
    EXPECT_NEAR(digits_right(1e-5, 2).value(), 5.30, 0.005);
    EXPECT_EQ(digits_right(3, 1), 0);
    EXPECT_FALSE(digits_right(0, 1).has_value());
    EXPECT_FALSE(digits_right(1, 0).has_value());
    EXPECT_FALSE(digits_right(NAN, 1).has_value());
}

TEST(format, dragged_values_are_short_to_write) {
    EXPECT_EQ(rounded_for_slider(0.123456, 1e-4, 10, true), 0.123);
    EXPECT_EQ(rounded_for_slider(1234.5, 1e-4, 1e4, true), 1230);
    EXPECT_EQ(rounded_for_slider(3.14159, 0, 10, false), 3.1);
    EXPECT_EQ(rounded_for_slider(0, 0, 10, false), 0);
}

TEST(rate, keys_go_through_1_2_5) {
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

TEST(rate, beyond_the_fastest_comes_no_limit_and_back) {
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

TEST(rate, a_speed_between_goes_to_the_next) {
    EXPECT_EQ(faster({false, 3}).seconds_per_second, 5);
    EXPECT_EQ(slower({false, 3}).seconds_per_second, 2);
}

}  // namespace
}  // namespace steplab::ui
