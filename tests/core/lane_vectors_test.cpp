#include "core/lane_vectors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <type_traits>

namespace steplab::test {
namespace {

template <class T>
class LaneVectors : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(LaneVectors, Numbers);

/// Vectors of four numbers; each number encodes its vector and its place in it.
template <class T>
struct Vectors {
    alignas(64) std::array<T, 64> numbers{};
    Vectors() {
        for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<T>(10 * (k / 4) + k % 4);
    }
    /// In another order than that of memory.
    static std::size_t vector(std::size_t j) { return j * 5 % 16; }
    const T* address(std::size_t j) const { return numbers.data() + 4 * vector(j); }
};

template <class T, std::size_t Count>
void expect_vectors_four_times() {
    const Vectors<T> vectors;
    const auto v = repeated_vectors<T, Count>([&](std::size_t j) { return vectors.address(j); });
    for (std::size_t lane = 0; lane < Count; ++lane) {
        const auto first = static_cast<T>(10 * Vectors<T>::vector(lane / 4));
        EXPECT_EQ(v.x[lane], first) << lane;
        EXPECT_EQ(v.y[lane], first + 1) << lane;
        EXPECT_EQ(v.z[lane], first + 2) << lane;
    }
}

TYPED_TEST(LaneVectors, come_from_memory_each_in_four_lanes) {
    expect_vectors_four_times<TypeParam, 4>();
    expect_vectors_four_times<TypeParam, 8>();
    expect_vectors_four_times<TypeParam, 16>();
}

template <class T, std::size_t Count>
void expect_vectors_in_lanes() {
    const Vectors<T> vectors;
    const auto v = gathered_vectors<T, Count>([&](std::size_t j) { return vectors.address(j); });
    for (std::size_t lane = 0; lane < Count; ++lane) {
        const auto first = static_cast<T>(10 * Vectors<T>::vector(lane));
        EXPECT_EQ(v.x[lane], first) << lane;
        EXPECT_EQ(v.y[lane], first + 1) << lane;
        EXPECT_EQ(v.z[lane], first + 2) << lane;
    }
    std::size_t seen = 0;
    each_vector(v, [&](std::size_t j, const RegisterLanes<T, 4>& vector) {
        EXPECT_EQ(j, seen++);
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_EQ(vector[axis], static_cast<T>(10 * Vectors<T>::vector(j) + axis)) << j;
    });
    EXPECT_EQ(seen, Count);
}

TYPED_TEST(LaneVectors, come_from_memory_each_in_a_lane_and_go_back) {
    if constexpr (std::is_same_v<TypeParam, double>) expect_vectors_in_lanes<double, 2>();
    expect_vectors_in_lanes<TypeParam, 4>();
    expect_vectors_in_lanes<TypeParam, 8>();
    expect_vectors_in_lanes<TypeParam, 16>();
}

/// Numbers whose sum depends on the order: (big + 1) - big + 1 is not (big - big) + (1 + 1).
template <class T, std::size_t Count>
void expect_sums_in_their_order() {
    using N = RegisterLanes<T, Count>;
    const T big = T(2) / std::numeric_limits<T>::epsilon();
    const auto along = [=](T scale) {
        return N::each([=](std::size_t lane) {
            const std::array<T, 4> four{big, T(1), -big, T(1)};
            return scale * four[lane % 4] * static_cast<T>(lane / 4 + 1);
        });
    };
    std::size_t seen = 0;
    each_sum_of_four(Vector<N>{along(1), along(2), along(-4)}, [&](std::size_t j, const RegisterLanes<T, 4>& sum) {
        EXPECT_EQ(j, seen++);
        const auto times = static_cast<T>(j + 1);
        const T expected = (times * big + times) + (-times * big + times);
        EXPECT_EQ(sum[0], expected) << j;
        EXPECT_EQ(sum[1], 2 * expected) << j;
        EXPECT_EQ(sum[2], -4 * expected) << j;
    });
    EXPECT_EQ(seen, Count / 4);
}

TYPED_TEST(LaneVectors, are_summed_by_fours_in_one_order) {
    expect_sums_in_their_order<TypeParam, 4>();
    expect_sums_in_their_order<TypeParam, 8>();
    expect_sums_in_their_order<TypeParam, 16>();
}

TYPED_TEST(LaneVectors, are_added_in_halves) {
    const auto lanes =
        RegisterLanes<TypeParam, 16>::each([](std::size_t lane) { return static_cast<TypeParam>(lane); });
    const auto sums = halves_added(lanes);
    for (std::size_t lane = 0; lane < 8; ++lane) EXPECT_EQ(sums[lane], static_cast<TypeParam>(2 * lane + 8));
}

}  // namespace
}  // namespace steplab::test
