#include "sim/run/known_fall.hpp"

#include "models/scene/planner.hpp"
#include "models/scene/scene.hpp"
#include "sim/run/known_motion.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

/// A throw, a ball that drops beside it, and a fixed one; the drags may differ.
Scene thrown(double drag_of_throw, double drag_of_ball) {
    Scene scene;
    scene.particles = {{.group = "throw", .position = {1, 2, 0}, .velocity = {3, 4, -1}, .mass = 2},
                       {.group = "ball", .position = {0, 5, 0}},
                       {.group = "peg", .fixed = true}};
    scene.fields = {{.gravity = WrittenVector{0, -9.81, 0}},
                    {.particles = {"throw"}, .drag = drag_of_throw},
                    {.particles = {"ball"}, .drag = drag_of_ball}};
    return scene;
}

/// How far a particle has come since the start.
Vec3 way(const ExactSolution& motion, std::size_t particle, double t) {
    return motion.displacement(particle, t) - motion.displacement(particle, 0);
}

TEST(KnownFall, is_a_parabola_without_drag) {
    const auto motion = known_motion(planned(thrown(0, 0)));
    ASSERT_TRUE(motion);
    for (const double t : {0.0, 0.7, 100.0}) {
        const double rounding = 4e-16 * 9.81 * (1 + t * t);  // of both formulas in double
        const Vec3 there = way(*motion, 0, t), rate = motion->velocity(0, t);
        EXPECT_NEAR(there.x, 3 * t, rounding);
        EXPECT_NEAR(there.y, 4 * t - 9.81 / 2 * t * t, rounding);
        EXPECT_NEAR(there.z, -t, rounding);
        EXPECT_NEAR(rate.y, 4 - 9.81 * t, rounding);
        EXPECT_EQ(way(*motion, 2, t), (Vec3{}));
        EXPECT_EQ(motion->velocity(2, t), (Vec3{}));
    }
}

// From drag that hardly acts in this time to some that ends all else than the fall at once, in the closed form
// v = a / gamma + (v0 - a / gamma) e^(-gamma t): its difference loses digits as 1 / (gamma t)^2.
TEST(KnownFall, with_drag_is_the_closed_form) {
    const double mass = 2, g = -9.81, t = 3;
    for (const double c : {1e-2, 0.1, 0.6, 0.66, 0.7, 2.0, 60.0, 1e4}) {
        const auto motion = known_motion(planned(thrown(c, 0.5)));
        ASSERT_TRUE(motion);
        const double gamma = c / mass, decay = std::exp(-gamma * t), final = g / gamma;
        const double lost = 1e-15 * (1 + 1 / (gamma * t * gamma * t));
        EXPECT_NEAR(motion->velocity(0, t).y, final + (4 - final) * decay, 40 * lost) << c;
        EXPECT_NEAR(way(*motion, 0, t).y, final * t + (4 - final) * (1 - decay) / gamma, 100 * lost) << c;
        EXPECT_NEAR(way(*motion, 0, t).x, 3 * (1 - decay) / gamma, 10 * lost) << c;
        EXPECT_NEAR(motion->velocity(1, t).y, g / 0.5 * (1 - std::exp(-0.5 * t)), 1e-13) << c;
    }
}

// The smallest drag changes the fall without drag by its own size.
TEST(KnownFall, goes_over_into_that_without_drag) {
    const auto free = known_motion(planned(thrown(0, 0)));
    for (const double c : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const auto dragged = known_motion(planned(thrown(c, c)));
        const double less = 9.81 * 0.5 * c * 27 / 6;  // a gamma t^3 / 6 in first order, and that of the velocity
        const double change = dragged->displacement(0, 3).y - free->displacement(0, 3).y;
        EXPECT_NEAR(change, less - 4 * 0.5 * c * 9 / 2, 1e-14 + 100 * c * c) << c;
    }
}

TEST(KnownFall, of_the_file_of_free_particles_is_that_of_the_model) {
    const RunDescription run = describe("free");
    const Model& free = model_of(run);
    const auto known = known_fall(planned(free.scene(run.scene))), exact = free.exact(run.scene);
    ASSERT_TRUE(known && exact);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_NEAR(known->displacement(i, 7).y, exact->displacement(i, 7).y, 1e-14);
        EXPECT_NEAR(known->velocity(i, 7).y, exact->velocity(i, 7).y, 1e-14);
    }
}

TEST(KnownFall, is_none_where_particles_act_on_each_other_or_forces_change) {
    Scene scene = thrown(0.1, 0.2);
    scene.springs = {{.pairs = {{"throw", "ball"}}, .k = 1}};
    EXPECT_FALSE(known_fall(planned(scene)));
    scene = thrown(0.1, 0.2);
    scene.pairs = {{.potential = "gravity", .values = {{"G", 1.0}}}};
    EXPECT_FALSE(known_fall(planned(scene)));
    scene = thrown(0.1, 0.2);
    FieldTerm trap;
    trap.potential = "x^2";
    scene.fields.push_back(trap);
    EXPECT_FALSE(known_fall(planned(scene)));
}

}  // namespace
}  // namespace steplab::test
