#include "render/motion.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace steplab::render {
namespace {

Frame frame_at(double time, Vec3 position, Vec3 velocity) {
    Frame frame;
    frame.time = time;
    frame.positions = {position};
    frame.velocities = {velocity};
    return frame;
}

// y = 1 + 2 t - 4 t^2 + t^3 and its derivative: a cubic is its own Hermite curve.
Frame on_a_cubic(double t) {
    return frame_at(t, {t, 1 + 2 * t - 4 * t * t + t * t * t, 0}, {1, 2 - 8 * t + 3 * t * t, 0});
}

TEST(Motion, begins_and_ends_at_the_frames) {
    const Frame a = on_a_cubic(1), b = on_a_cubic(1.5);
    Frame shown;
    between(a, b, 0, shown);
    EXPECT_EQ(shown.positions, a.positions);
    between(a, b, 1, shown);
    EXPECT_EQ(shown.positions, b.positions);
}

TEST(Motion, keeps_what_a_file_says_of_its_particles) {
    Frame a = on_a_cubic(1), b = on_a_cubic(1.5), shown;
    b.values = std::make_shared<const std::vector<ParticleValues>>(std::vector<ParticleValues>{{"q", {1}}});
    b.magnified = 7;
    b.cell = Cell{{Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 0, 1}}};
    between(a, b, 0.5, shown);
    EXPECT_EQ(shown.values, b.values);
    EXPECT_EQ(shown.cell, b.cell);
    EXPECT_EQ(shown.magnified, 7);
    between(b, a, 0.5, shown);
    EXPECT_EQ(shown.values, nullptr);
    EXPECT_FALSE(shown.cell);
}

TEST(Motion, has_the_arrows_of_the_later_frame) {
    Frame a = on_a_cubic(1), b = on_a_cubic(1.5), shown;
    b.forces = {{1, 2, 3}};
    b.oscillation = {{0, 1, 0}};
    between(a, b, 0.5, shown);
    EXPECT_EQ(shown.velocities, b.velocities);
    EXPECT_EQ(shown.forces, b.forces);
    EXPECT_EQ(shown.oscillation, b.oscillation);
    between(b, a, 0.5, shown);
    EXPECT_TRUE(shown.forces.empty());
    EXPECT_TRUE(shown.oscillation.empty());
}

TEST(Motion, follows_a_cubic_exactly) {
    const Frame a = on_a_cubic(1), b = on_a_cubic(3);
    for (const double fraction : {0.1, 0.25, 0.5, 0.9}) {
        Frame shown;
        between(a, b, fraction, shown);
        const Frame right = on_a_cubic(1 + 2 * fraction);
        EXPECT_NEAR(shown.positions[0].x, right.positions[0].x, 1e-14);  // some roundings of numbers below 10
        EXPECT_NEAR(shown.positions[0].y, right.positions[0].y, 1e-14);
        EXPECT_NEAR(shown.time, right.time, 1e-15);
    }
}

TEST(Motion, moves_the_ensemble_with_the_run) {
    Frame a = on_a_cubic(1), b = on_a_cubic(3), shown;
    a.ensemble = {a.positions[0], a.positions[0] + Vec3{1, 0, 0}};
    b.ensemble = {b.positions[0], b.positions[0] + Vec3{3, 0, 0}};
    for (const double fraction : {0.0, 0.25, 0.7, 1.0}) {
        between(a, b, fraction, shown);
        ASSERT_EQ(shown.ensemble.size(), 2u);
        EXPECT_EQ(shown.ensemble[0], shown.positions[0]) << "what is hidden in a particle stays in it";
        EXPECT_NEAR(length(shown.ensemble[1] - shown.positions[0]), 1 + 2 * fraction, 1e-14);  // some roundings
    }
    a.ensemble.clear();
    between(a, b, 0.5, shown);
    EXPECT_NEAR(length(shown.ensemble[1] - shown.positions[0]), 3, 1e-14) << "an ensemble that was not there before";
    between(b, a, 0.5, shown);
    EXPECT_TRUE(shown.ensemble.empty());
}

}  // namespace
}  // namespace steplab::render
