#include "core/compressed_lanes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>

namespace steplab::test {
namespace {

template <class T>
class CompressedLanes : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(CompressedLanes, Numbers);

/// The number in each lane is its index plus 1.
template <class T, std::size_t Count>
RegisterLanes<T, Count> numbered() {
    return RegisterLanes<T, Count>::each([](std::size_t lane) { return static_cast<T>(lane + 1); });
}

bool holds(LaneSet set, std::size_t lane) { return (set >> lane & 1) != 0; }

template <class T, std::size_t Count>
void expect_set_below() {
    constexpr T infinite = std::numeric_limits<T>::infinity(), none = std::numeric_limits<T>::quiet_NaN();
    constexpr std::array<T, 7> numbers{T(3), none, T(2), -infinite, T(1), infinite, T(-0.0)};
    const auto a = RegisterLanes<T, Count>::each([&](std::size_t lane) { return numbers[lane % numbers.size()]; });
    for (const T bound : {T(0), T(2), infinite, none}) {
        const LaneSet set = lanes_below(a, RegisterLanes<T, Count>(bound));
        EXPECT_EQ(set >> (Count - 1) >> 1, 0U) << bound;
        for (std::size_t lane = 0; lane < Count; ++lane) EXPECT_EQ(holds(set, lane), a[lane] < bound) << lane;
    }
}

TYPED_TEST(CompressedLanes, are_those_below_a_bound) {
    expect_set_below<TypeParam, 4>();
    expect_set_below<TypeParam, 8>();
    expect_set_below<TypeParam, 16>();
}

/// Every set of lanes and its complement, stored one behind the other.
template <class T, std::size_t Count>
void expect_back_in_their_places() {
    constexpr T untouched = T(-1);
    const auto lanes = numbered<T, Count>();
    for (LaneSet set = 0; set < LaneSet{1} << Count; ++set) {
        std::array<T, 4 * Count> memory;
        memory.fill(untouched);
        T* end = store_compressed(set, lanes, memory.data());
        end = store_compressed(~set & ((LaneSet{1} << Count) - 1), lanes, end);
        ASSERT_LE(end, memory.data() + 2 * Count);
        ASSERT_EQ(memory[3 * Count], untouched) << set;
        const T* from = memory.data();
        const auto first = load_expanded<RegisterLanes<T, Count>>(set, from);
        const auto second = load_expanded<RegisterLanes<T, Count>>(~set & ((LaneSet{1} << Count) - 1), from);
        ASSERT_EQ(from, end) << set;
        for (std::size_t lane = 0; lane < Count; ++lane) {
            const T number = lanes[lane];
            ASSERT_EQ(holds(set, lane) ? first[lane] : second[lane], number) << set << " " << lane;
            const T other = holds(set, lane) ? second[lane] : first[lane];
            ASSERT_TRUE(other == T(0) || other == number) << set << " " << lane;
        }
    }
}

TYPED_TEST(CompressedLanes, come_back_into_their_places) {
    constexpr std::size_t cache_line = 64 / sizeof(TypeParam);
    expect_back_in_their_places<TypeParam, cache_line>();
}

TYPED_TEST(CompressedLanes, of_an_empty_set_take_no_memory) {
    std::array<TypeParam, 64> memory{};
    const auto lanes = numbered<TypeParam, 64 / sizeof(TypeParam)>();
    EXPECT_EQ(store_compressed(0, lanes, memory.data()), memory.data());
}

}  // namespace
}  // namespace steplab::test
