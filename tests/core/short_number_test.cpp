#include "core/number_text.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

TEST(ShortNumber, has_four_digits_or_its_integer_part) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(0.7000000000000001), "0.7");
    EXPECT_EQ(short_number(68.1), "68.1");
    EXPECT_EQ(short_number(-3.14159), "-3.142");
    EXPECT_EQ(short_number(12345.678), "12346");
    EXPECT_EQ(short_number(1234567.8), "1234568");
    EXPECT_EQ(short_number(1.23456e-7), "1.235e-7");
    EXPECT_EQ(short_number(4.73e11), "4.73e11");
}

}  // namespace
}  // namespace steplab
