#include "lab/study/speed.hpp"

#include "core/error.hpp"
#include "core/team.hpp"
#include "sim/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
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

/// A step or two of each run. How long they take is the machine's: what is said of it is that they were timed.
constexpr MeasuringTime at_once{.batch = 0, .run = 0};

bool was_timed(double seconds) { return std::isfinite(seconds) && seconds > 0; }

TEST(MachineSpeed, is_that_of_every_model_in_both_precisions) {
    std::vector<double> parts;
    const MachineSpeed speed = measure_machine(
        "rk4", [&](double part) { parts.push_back(part); }, at_once);
    std::set<std::pair<std::string, Precision>> found, expected;
    for (std::size_t i = 0; i < speed.scenes.size(); ++i) {
        const Speed& scene = speed.scenes[i];
        EXPECT_EQ(scene.run.method, "rk4");
        EXPECT_EQ(static_cast<double>(scene.particles), model_of(scene.run).particles(scene.run.scene));
        EXPECT_TRUE(was_timed(scene.seconds)) << scene.run.model;
        if (!found.emplace(scene.run.model, scene.run.precision).second) {
            EXPECT_GT(scene.particles, speed.scenes[i - 1].particles) << "small ones first";
        }
    }
    for (const Model& model : models()) {
        for (const Precision precision : {Precision::float_, Precision::double_})
            expected.emplace(model.info.id, precision);
    }
    EXPECT_EQ(found, expected);
    ASSERT_EQ(parts.size(), speed.scenes.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        EXPECT_DOUBLE_EQ(parts[i], static_cast<double>(i) / static_cast<double>(parts.size()));
}

/// What a comparison compares. All of it was timed.
std::vector<std::string> ways(const Comparison& comparison) {
    std::vector<std::string> names;
    for (const auto& [way, seconds] : comparison.seconds) {
        EXPECT_TRUE(was_timed(seconds)) << way;
        names.push_back(way);
    }
    return names;
}

TEST(MachineSpeed, compares_instruction_sets_and_threads) {
    const MachineSpeed speed = measure_machine(
        "velocity-verlet", [](double) {}, at_once);
    std::vector<std::string> sets;
    for (const Instructions instructions : instructions_here()) sets.emplace_back(id(instructions));
    EXPECT_EQ(ways(speed.instructions), sets);
    const std::vector<std::string> threads = ways(speed.threads);
    ASSERT_FALSE(threads.empty());
    EXPECT_EQ(threads.front(), "1 thread");
    EXPECT_EQ(threads.size(), 1 + static_cast<std::size_t>(std::log2(processors())));
    EXPECT_EQ(speed.instructions.run.method, "velocity-verlet");
    EXPECT_GT(speed.threads.particles, speed.instructions.particles);
}

TEST(MachineSpeed, of_no_method_is_refused) {
    EXPECT_THROW(measure_machine(
                     "rk5", [](double) {}, at_once),
                 UsageError);
}

}  // namespace
}  // namespace steplab
