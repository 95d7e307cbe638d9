#include "sim/run/mode_frequencies.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>

namespace steplab::test {
namespace {

RunDescription scene(std::string_view model, std::initializer_list<std::pair<std::string_view, double>> values) {
    RunDescription description = describe(model);
    for (const auto& [name, value] : values) description.scene.set(name, value);
    return description;
}

// A spring of length 0 pulls in the same way along all three axes.
TEST(mode_frequencies, of_an_oscillator_are_the_root_of_k_over_m) {
    const auto found = mode_frequencies(scene("oscillator", {{"k", 3}, {"m", 0.7}}), 64);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 3u);
    for (const double frequency : *found) EXPECT_NEAR(frequency, std::sqrt(3 / 0.7), 1e-12);
}

// A line fixed at one end: omega_j = 2 sqrt(k / m) sin((2 j - 1) pi / (2 (2 n + 1))) for n moving particles. Motion
// across the line does not vibrate.
TEST(mode_frequencies, of_a_chain_are_those_of_the_formula_in_order) {
    const RunDescription chain = scene("chain", {{"n", 8}, {"k", 2}});
    const auto found = mode_frequencies(chain, 64);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 7u);
    for (std::size_t j = 1; j <= found->size(); ++j) {
        const double phase = (2 * static_cast<double>(j) - 1) * std::numbers::pi / (2 * (2 * 7 + 1));
        EXPECT_NEAR((*found)[j - 1], 2 * std::sqrt(2 / chain.scene["m"]) * std::sin(phase), 1e-10) << j;
    }
}

// Two masses m at a distance d: omega^2 = 2 V''(d) / m along the line that joins them.
TEST(mode_frequencies, of_a_pair_is_that_of_the_curvature_of_its_potential) {
    const RunDescription pair = scene("morse", {{"edge", 1}, {"r0", 10}, {"k", 3}, {"D", 2}});
    const auto rest = model_of(pair).shape(pair.scene).rest;
    const double b = std::sqrt(3 / (2 * 2.0)), e = std::exp(-b * (length(rest[1] - rest[0]) - 10));
    const auto found = mode_frequencies(pair, 64);
    ASSERT_TRUE(found && !found->empty());
    EXPECT_NEAR(found->back(), std::sqrt(2 * 2 * 2 * b * b * e * (2 * e - 1) / pair.scene["m"]), 1e-9);
}

// A Morse pair that starts elsewhere has another Jacobian there.
TEST(mode_frequencies, are_those_about_the_rest_positions_wherever_the_scene_starts) {
    const RunDescription pair = scene("morse", {{"edge", 1}, {"r0", 10}, {"k", 3}});
    RunDescription moved = pair;
    auto values = std::make_shared<StartingValues>();
    values->positions = model_of(pair).shape(pair.scene).rest;
    values->positions[0].x += 0.05;
    values->velocities.resize(2);
    moved.start.from = values;
    ASSERT_NE(plan_of(moved).start[0].displacement.x, plan_of(pair).start[0].displacement.x);
    ASSERT_FALSE(mode_frequencies(pair, 64)->empty());
    EXPECT_EQ(*mode_frequencies(moved, 64), *mode_frequencies(pair, 64));
    EXPECT_NE(*mode_frequencies(scene("morse", {{"edge", 1}, {"r0", 10}, {"k", 2}}), 64), *mode_frequencies(pair, 64));
}

TEST(mode_frequencies, are_not_computed_of_many_particles) {
    EXPECT_FALSE(mode_frequencies(scene("chain", {{"n", 65}}), 64));
    EXPECT_TRUE(mode_frequencies(scene("chain", {{"n", 64}}), 64));
}

}  // namespace
}  // namespace steplab::test
