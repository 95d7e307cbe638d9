#include "core/known.hpp"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>

namespace steplab {
namespace {

constexpr std::array<ParameterInfo, 1> infos{{{.name = "k", .default_value = 1}}};

/// How often something is found for these values, one after the other.
template <std::size_t most>
int found_for(std::initializer_list<double> all) {
    Known<double, most> known;
    int found = 0;
    for (const double value : all) {
        ParameterValues values(infos);
        values.set("k", value);
        EXPECT_EQ(known.of(values, [&] { return ++found, 2 * value; }), 2 * value);
    }
    return found;
}

TEST(Known, finds_what_is_asked_for_again_once) {
    EXPECT_EQ(found_for<1>({1, 1, 1}), 1);
    EXPECT_EQ(found_for<3>({1, 2, 3, 1, 2, 3, 3, 2, 1}), 3);
}

TEST(Known, forgets_what_was_not_asked_for_for_the_longest_time) {
    EXPECT_EQ(found_for<1>({1, 2, 1}), 3);
    EXPECT_EQ(found_for<2>({1, 2, 1, 3, 1}), 3) << "2 was forgotten";
    EXPECT_EQ(found_for<2>({1, 2, 1, 3, 2}), 4);
}

}  // namespace
}  // namespace steplab
