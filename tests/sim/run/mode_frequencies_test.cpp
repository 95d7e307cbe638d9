#include "sim/run/mode_frequencies.hpp"

#include "sim/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
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

TEST(mode_frequencies, do_not_depend_on_the_start) {
    const auto kicked = mode_frequencies(scene("chain", {{"n", 5}, {"v0", 1}}), 64);
    ASSERT_TRUE(kicked);
    EXPECT_EQ(*kicked, *mode_frequencies(scene("chain", {{"n", 5}, {"v0", 3}}), 64));
    EXPECT_NE(*kicked, *mode_frequencies(scene("chain", {{"n", 5}, {"k", 7}}), 64));
}

TEST(mode_frequencies, are_not_computed_of_many_particles) {
    EXPECT_FALSE(mode_frequencies(scene("chain", {{"n", 65}}), 64));
    EXPECT_TRUE(mode_frequencies(scene("chain", {{"n", 64}}), 64));
}

}  // namespace
}  // namespace steplab::test
