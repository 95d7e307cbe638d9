#include "lab/report/readable_number.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
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
TEST(ReadableNumber, has_a_power_of_ten_elsewhere) {
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

TEST(ReadableNumber, has_groups_of_three_digits_for_counts) {
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(12345678), "12\u202f345\u202f678");
}

}  // namespace
}  // namespace steplab::test
