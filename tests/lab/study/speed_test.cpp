#include "lab/study/speed.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace steplab {
namespace {

struct Measured {
    std::size_t particles;
    double seconds_a_particle;
};

/// The bounds of these sizes on a processor with 1 MB of cache per core.
std::vector<Bound> bounds_of(const std::vector<Measured>& sizes, Precision precision = Precision::double_) {
    std::vector<Speed> speeds;
    for (const auto& [particles, seconds] : sizes) {
        speeds.push_back({.run = {}, .particles = particles, .seconds = seconds * static_cast<double>(particles)});
        speeds.back().run.precision = precision;
    }
    find_bounds(speeds, 1000000);
    std::vector<Bound> bounds;
    for (const Speed& speed : speeds) bounds.push_back(speed.bound);
    return bounds;
}

using Bounds = std::vector<Bound>;

TEST(Bounds, of_few_particles_are_latency_where_many_are_faster) {
    EXPECT_EQ(bounds_of({{10, 2}, {1000, 0.5}}), (Bounds{Bound::latency, Bound::arithmetic}));
    EXPECT_EQ(bounds_of({{100, 2}, {10000, 1.9}}), (Bounds{Bound::arithmetic, Bound::arithmetic}));
    EXPECT_EQ(bounds_of({{1000, 2}, {10000, 1}}), (Bounds{Bound::arithmetic, Bound::arithmetic}));
}

// The larger size that shows it need not be the next one.
TEST(Bounds, of_few_particles_consider_every_larger_size) {
    EXPECT_EQ(bounds_of({{10, 2}, {50, 1.9}, {1000, 0.5}}),
              (Bounds{Bound::latency, Bound::latency, Bound::arithmetic}));
}

TEST(Bounds, of_a_model_with_one_small_size_is_latency) {
    EXPECT_EQ(bounds_of({{2, 8}}), Bounds{Bound::latency});
    EXPECT_EQ(bounds_of({{2000, 8}}), Bounds{Bound::arithmetic});
}

TEST(Bounds, are_memory_where_numbers_beyond_the_cache_take_longer) {
    EXPECT_EQ(bounds_of({{1000, 1}, {1000000, 2}}), (Bounds{Bound::arithmetic, Bound::memory}));
    EXPECT_EQ(bounds_of({{1000, 1}, {1000000, 1.2}}), (Bounds{Bound::arithmetic, Bound::arithmetic}));
}

// Only a little slower from size to size, but clearly slower than the fastest one.
TEST(Bounds, are_memory_compared_with_the_fastest_smaller_size) {
    EXPECT_EQ(bounds_of({{1000, 1}, {100000, 1.2}, {1000000, 1.4}}),
              (Bounds{Bound::arithmetic, Bound::arithmetic, Bound::memory}));
}

// Without a cut-off the time per particle grows with the number of particles; this is not due to memory.
TEST(Bounds, within_the_cache_are_arithmetic_however_slow) {
    EXPECT_EQ(bounds_of({{100, 1}, {1000, 10}}), (Bounds{Bound::arithmetic, Bound::arithmetic}));
}

// 30 000 particles take 1.44 MB in double and 0.72 MB in float.
TEST(Bounds, know_the_size_of_a_number) {
    EXPECT_EQ(bounds_of({{1000, 1}, {30000, 2}}), (Bounds{Bound::arithmetic, Bound::memory}));
    EXPECT_EQ(bounds_of({{1000, 1}, {30000, 2}}, Precision::float_), (Bounds{Bound::arithmetic, Bound::arithmetic}));
}

}  // namespace
}  // namespace steplab
