#include "sim/run/known_motion.hpp"

#include "models/scene/planner.hpp"
#include "models/scene/scene.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace steplab::test {
namespace {

std::shared_ptr<const ExactSolution> motion_of(const Scene& scene) { return known_motion(planned(scene)); }

/// Two masses between walls, beating.
Scene between_walls() {
    Scene scene;
    scene.particles = {{.group = "row", .mass = 2, .arrangement = LineArrangement{4, {1, 0, 0}}}};
    scene.fixes = {{.particles = {"row[0]", "row[-1]"}, .fixed = true},
                   {.particles = {"row[1]"}, .displacement = WrittenVector{0.2, 0, 0}}};
    scene.springs = {{.pairs = {{"row[0]", "row[1]"}, {"row[2]", "row[3]"}}, .k = 8},
                     {.pairs = {{"row[1]", "row[2]"}}, .k = 1}};
    return scene;
}

TEST(KnownMotion, of_two_masses_between_walls_beats) {
    const auto motion = motion_of(between_walls());
    ASSERT_TRUE(motion);
    const double slow = std::sqrt(8.0 / 2), fast = std::sqrt((8.0 + 2) / 2);
    for (const double t : {0.0, 0.3, 7.0, 1000.0}) {
        const double together = 0.1 * std::cos(slow * t), against = 0.1 * std::cos(fast * t);
        EXPECT_NEAR(motion->displacement(1, t).x, together + against, 1e-15 + 4e-16 * t)
            << t;  // of the phase in double
        EXPECT_NEAR(motion->displacement(2, t).x, together - against, 1e-15 + 4e-16 * t) << t;
        EXPECT_EQ(motion->displacement(3, t), (Vec3{}));
    }
}

TEST(KnownMotion, of_a_chain_is_that_of_the_model) {
    const RunDescription run =
        run_of("chain", "rk4", Precision::double_, 0.1, {{"n", 8}, {"k", 3}, {"m", 0.5}, {"c", 0.1}});
    const Model& chain = model_of(run);
    const auto known = known_motion(chain.plan(run.scene)), exact = chain.exact(run.scene);
    ASSERT_TRUE(known && exact);
    for (const double t : {0.0, 0.5, 20.0}) {
        for (std::size_t i = 0; i < 8; ++i) {
            const double rounding = 1e-15 * (1 + t);  // of both, in long double and rounded
            EXPECT_NEAR(known->displacement(i, t).x, exact->displacement(i, t).x, rounding);
            EXPECT_NEAR(known->velocity(i, t).x, exact->velocity(i, t).x, 4 * rounding);
        }
    }
}

// Half a length of the spring more than at rest, so that it is stretched in its equilibrium.
TEST(KnownMotion, counts_from_the_equilibrium_of_stretched_springs) {
    Scene scene = between_walls();
    for (SpringTerm& term : scene.springs) term.length = WrittenNumber(0.5);
    const auto motion = motion_of(scene);
    ASSERT_TRUE(motion);
    const double rest = (8 - 1) * 0.5 / (8 + 2.0);  // where each mass rests, towards its wall by symmetry
    const double slow = std::sqrt(8.0 / 2), fast = std::sqrt((8.0 + 2) / 2), t = 1.7;
    const double together = 0.1 * std::cos(slow * t), against = (0.1 + rest) * std::cos(fast * t) - rest;
    EXPECT_NEAR(motion->displacement(1, t).x, together + against, 1e-15);
    EXPECT_NEAR(motion->displacement(2, t).x, together - against, 1e-15);
}

TEST(KnownMotion, of_two_free_masses_keeps_their_centre) {
    Scene scene;
    scene.particles = {{.group = "a", .velocity = {1, 0, 0}},
                       {.group = "b", .position = {2, 0, 0}, .mass = 3, .displacement = WrittenVector{0.5, 0, 0}}};
    scene.springs = {{.pairs = {{"a", "b"}}, .k = 6}};
    const auto motion = motion_of(scene);
    ASSERT_TRUE(motion);
    const double omega = std::sqrt(6 * (1 + 1 / 3.0)), t = 2.5;
    const double apart = 0.5 * std::cos(omega * t) - std::sin(omega * t) / omega, centre = 0.375 + 0.25 * t;
    EXPECT_NEAR(motion->displacement(0, t).x, centre - 0.75 * apart, 2e-15);
    EXPECT_NEAR(motion->displacement(1, t).x, centre + 0.25 * apart, 2e-15);
    EXPECT_NEAR(motion->velocity(0, t).x, 0.25 + 0.75 * (0.5 * omega * std::sin(omega * t) + std::cos(omega * t)),
                4e-15);
}

TEST(KnownMotion, is_none_where_particles_may_pass_or_leave_the_line) {
    Scene scene = between_walls();
    scene.fixes[1].velocity = WrittenVector{5, 0, 0};
    EXPECT_FALSE(motion_of(scene)) << "into the other";
    scene.fixes[1].velocity.reset();
    scene.fixes[1].displacement = WrittenVector{0, 0.1, 0};
    EXPECT_FALSE(motion_of(scene)) << "across";
    scene = between_walls();
    scene.springs[0].cubic = 1;
    EXPECT_FALSE(motion_of(scene));
    scene = between_walls();
    scene.fields = {{.gravity = WrittenVector{0, -1, 0}}};
    EXPECT_FALSE(motion_of(scene));
}

/// Semi-major axis 1, at its nearest point.
Scene pair(double e, double first_mass = 3, double second_mass = 1) {
    const double total = first_mass + second_mass, speed = std::sqrt(total * (1 + e) / (1 - e));
    Scene scene;
    scene.particles = {{.group = "sun", .mass = first_mass},
                       {.group = "planet", .position = {1 - e, 0, 0}, .velocity = {0, speed, 0}, .mass = second_mass}};
    scene.pairs = {{.potential = "gravity", .values = {{"G", 1.0}}}};
    return scene;
}

TEST(KnownMotion, of_a_pair_is_an_ellipse_of_Kepler) {
    for (const double e : {0.0, 0.3, 0.9, 0.99}) {
        const auto motion = motion_of(pair(e));
        ASSERT_TRUE(motion);
        const auto apart = [&](double t) { return motion->displacement(1, t) - motion->displacement(0, t); };
        const double period = std::numbers::pi;  // 2 pi / sqrt(4)
        // the start's speed is rounded to 1e-16, by which axis and period differ as its square and third power
        const double fastest = std::sqrt(4 * (1 + e) / (1 - e)), rounding = 1e-15 * (1 + fastest * fastest * fastest);
        EXPECT_LT(length(apart(period) - apart(0)), rounding) << e;
        EXPECT_NEAR(apart(period / 2).x, -(1 + e), rounding);
        EXPECT_NEAR(apart(period / 2).y, 0, rounding);
        EXPECT_NEAR(motion->velocity(1, 100 * period).y - motion->velocity(0, 100 * period).y, fastest, 1e-11);
        for (double t = 0; t < 3.2; t += 0.1) {
            const double r = length(apart(t));
            const Vec3 v = motion->velocity(1, t) - motion->velocity(0, t);
            EXPECT_NEAR(dot(v, v) / 2 - 4 / r, -2, 1e-13 * (1 + 4 / r)) << "energy at " << t << ", e = " << e;
        }
    }
}

TEST(KnownMotion, of_a_pair_is_what_a_precise_run_computes) {
    Scene scene = pair(0.5);
    scene.particles[0].fixed = true;
    scene.particles[1].velocity = {0.2, 1.5, 0.3};
    scene.pairs[0].values["G"] = 1.7;
    const Plan plan = planned(scene);
    const auto motion = known_motion(plan);
    ASSERT_TRUE(motion);
    ParameterValues tight(method("taylor").info.parameters);
    tight.set("tolerance", 1e-13);
    const auto stepper = method("taylor").make({plan, plan.start, tight, Precision::double_, 0.5});
    stepper->advance(6);
    State<double> state;
    stepper->synchronised(state);
    EXPECT_LT(length(state.displacement.at(1) - motion->displacement(1, 3)), 1e-9);  // of ten steps
    EXPECT_LT(length(state.velocity.at(1) - motion->velocity(1, 3)), 1e-8);
    EXPECT_EQ(motion->displacement(0, 3), (Vec3{}));
}

TEST(KnownMotion, is_none_of_other_pairs) {
    Scene scene = pair(0.5);
    scene.particles[1].velocity = {0, 10, 0};
    EXPECT_FALSE(motion_of(scene)) << "a hyperbola";
    scene = pair(0.5);
    scene.pairs[0].values["softening"] = 0.1;
    EXPECT_FALSE(motion_of(scene));
    scene = pair(0.5);
    scene.particles.push_back({.group = "moon", .position = {3, 0, 0}});
    EXPECT_FALSE(motion_of(scene));
    scene = pair(0.5);
    scene.pairs[0] = {.potential = "coulomb", .values = {{"K", 1.0}}};
    EXPECT_FALSE(motion_of(scene)) << "without charges";
    scene.particles[0].charge = 3;
    scene.particles[1].charge = -1;
    EXPECT_TRUE(motion_of(scene));
}

TEST(KnownFrequency, is_that_of_the_models_where_a_scene_is_one) {
    for (const char* const id : {"chain", "oscillator", "rope", "mesh"}) {
        const RunDescription run = describe(id);
        const Model& model = model_of(run);
        const auto known = known_frequency(planned(model.scene(run.scene)), model.shape(run.scene));
        ASSERT_TRUE(known) << id;
        EXPECT_NEAR(known->omega, *model.omega_max(run.scene), 1e-15 * known->omega) << id;
    }
    const RunDescription run = describe("morse");
    EXPECT_FALSE(known_frequency(model_of(run).plan(run.scene), model_of(run).shape(run.scene)));
}

TEST(KnownFrequency, of_springs_in_any_order_is_found_or_bounded) {
    const Scene two = between_walls();
    const auto exact = known_frequency(planned(two), shape_of(two));
    ASSERT_TRUE(exact);
    EXPECT_NEAR(exact->omega, std::sqrt(5.0), 1e-14);
    EXPECT_FALSE(exact->is_bound);
    Scene many = between_walls();  // a line between walls, too many for its modes
    many.particles[0].arrangement = LineArrangement{500, {1, 0, 0}};
    many.springs = {{.between = "row", .k = 8}};
    const auto bound = known_frequency(planned(many), shape_of(many));
    ASSERT_TRUE(bound);
    EXPECT_TRUE(bound->is_bound);
    EXPECT_GE(bound->omega, 4 * std::sin(std::numbers::pi / 2 * 498 / 499));  // 2 sqrt(k / m), the highest mode
    EXPECT_LE(bound->omega, 4.000001);
}

// A typed field acts besides the springs: their frequency alone would be none of the scene's, and no bound.
TEST(KnownFrequency, of_springs_in_a_typed_field_is_not_known) {
    Scene trapped = between_walls();
    FieldTerm trap;
    trap.potential = "50*x^2";
    trapped.fields = {trap};
    EXPECT_FALSE(known_frequency(planned(trapped), shape_of(trapped)));
}

}  // namespace
}  // namespace steplab::test
