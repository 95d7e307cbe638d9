#include "core/duration.hpp"

#include "core/entry.hpp"

#include <gtest/gtest.h>

namespace steplab {
namespace {

TEST(Duration, has_three_digits_in_the_unit_that_suits_it) {
    EXPECT_EQ(duration_text(4.2e-7), "420 ns");
    EXPECT_EQ(duration_text(6.25e-5), "62.5 µs");
    EXPECT_EQ(duration_text(1.2345e-2), "12.3 ms");
    EXPECT_EQ(duration_text(0.5), "500 ms");
    EXPECT_EQ(duration_text(12), "12 s");
    EXPECT_EQ(duration_text(545), "9 min 05 s");
    EXPECT_EQ(duration_text(9900), "2 h 45 min");
}

// 999.7 µs to three digits are 1 ms, and 59.7 s a minute: no "1e+03 µs", no "60 s".
TEST(Duration, goes_to_the_next_unit_where_rounding_leads_there) {
    EXPECT_EQ(duration_text(9.994e-4), "999 µs");
    EXPECT_EQ(duration_text(9.997e-4), "1 ms");
    EXPECT_EQ(duration_text(59.4), "59.4 s");
    EXPECT_EQ(duration_text(59.7), "1 min 00 s");
    EXPECT_EQ(duration_text(3599.6), "1 h 00 min");
}

TEST(Duration, is_readable_for_zero_tiny_and_infinite_values) {
    EXPECT_EQ(duration_text(0), "0 s");
    EXPECT_EQ(duration_text(1e-12), "0.001 ns");
    EXPECT_EQ(duration_text(infinity), "days");
    EXPECT_EQ(duration_text(-infinity), "0 s");
    EXPECT_EQ(duration_text(infinity - infinity), "days");
}

TEST(Bytes, have_three_digits_in_the_unit_that_suits_them) {
    EXPECT_EQ(bytes_text(0), "0 bytes");
    EXPECT_EQ(bytes_text(512), "512 bytes");
    EXPECT_EQ(bytes_text(999.6), "1 kB");
    EXPECT_EQ(bytes_text(1536e3), "1.54 MB");
    EXPECT_EQ(bytes_text(4.73e11), "473 GB");
    EXPECT_EQ(bytes_text(9.99e17), "999 PB");
    EXPECT_EQ(bytes_text(1e20), "1e20 bytes");
}

}  // namespace
}  // namespace steplab
