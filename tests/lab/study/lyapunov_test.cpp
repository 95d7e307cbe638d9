#include "lab/study/lyapunov.hpp"

#include "core/dual.hpp"
#include "core/error.hpp"
#include "lab/study/advice.hpp"
#include "models/forces/layouts.hpp"
#include "sim/run/linearised.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <variant>

namespace steplab::test {
namespace {

LyapunovExponent exponent_of(const RunDescription& run, double time) {
    return lyapunov_exponent(model_of(run).plan(run.scene), model_of(run).shape(run.scene), time);
}

/// In equilibrium at its start to the last bit also for dual numbers, whose exponential is computed differently from
/// that of doubles.
Plan balanced_for_duals(Plan scene) {
    using Number = Dual<double>;
    PairForces& pairs = std::get<PairForces>(scene.forces);
    Field<Number> a(pairs.count);
    engine<Number>(pairs).accelerations(converted<Number>(scene.start.state().displacement), a);
    auto balance = std::make_shared<Field<double>>(pairs.count);
    for (std::size_t k = 0; k < a.flat().size(); ++k) balance->flat()[k] = a.flat()[k].value;
    pairs.balance = balance;
    return scene;
}

/// A Morse cube, balanced at its start, from where it departs as e^(rate t): its rate by the eigenvalues of the
/// linearised scene, and as measured by neighbouring runs.
std::pair<double, double> departure(double stretched) {
    const RunDescription run = scene_with("morse", {{"edge", 2}, {"spacing", 2.5 * stretched}, {"k", 8}, {"v0", 0}});
    const Shape shape = model("morse").shape(run.scene);
    const Plan scene = balanced_for_duals(model("morse").plan(run.scene));
    const double least = modes(LinearisedScene(scene, shape)).values[0];
    return {std::sqrt(std::max(0.0, -least)), lyapunov_exponent(scene, shape, 400).exponent};
}

// The tangent has turned into the fastest direction long before the first quarter of the time is over.
TEST(Lyapunov, exponent_of_a_linear_departure_is_the_rate_of_its_eigenvalue) {
    const auto [rate, measured] = departure(1);
    EXPECT_GT(rate, 0.05);
    EXPECT_NEAR(measured / rate, 1, 1e-3);
    EXPECT_GT(std::abs(departure(1.02).second / rate - 1), 1e-2);  // the partner: a scene 2 % wider
}

// Distances in a regular motion grow at most linearly in time.
TEST(Lyapunov, exponent_of_regular_motion_is_zero) {
    EXPECT_NEAR(exponent_of(scene_with("oscillator"), 1000).exponent, 0, 1e-12);
    EXPECT_LT(exponent_of(scene_with("free"), 1000).exponent, 1e-2);
    EXPECT_FALSE(exponent_of(scene_with("free"), 1000).chaotic());
    EXPECT_FALSE(exponent_of(scene_with("mesh"), 20).chaotic());
}

// With drag c / m = 1 the motion dies out as e^(-t/2).
TEST(Lyapunov, exponent_of_damped_motion_is_negative) {
    EXPECT_NEAR(exponent_of(scene_with("oscillator", {{"c", 1}}), 100).exponent, -0.5, 1e-2);
    EXPECT_LT(exponent_of(scene_with("rope"), 20).exponent, 0);
}

// The same rope with and without drag. Between intervals of 2 s the exponent varies by about 1.
TEST(Lyapunov, exponent_of_a_whipping_rope_is_significantly_positive) {
    const LyapunovExponent whip = exponent_of(scene_with("rope", {{"c", 0}}), 20),
                           damped = exponent_of(scene_with("rope"), 20);
    EXPECT_TRUE(whip.chaotic());
    EXPECT_NEAR(whip.exponent, 2.7, 3 * whip.spread);
    EXPECT_FALSE(damped.chaotic());
}

TEST(Chaos, is_reported_where_the_reference_is_lost_and_nowhere_else) {
    const ReferenceEffort effort{.most_particle_evaluations = 3e5};
    const RunDescription whip = scene_with("rope", {{"c", 0}}), calm = scene_with("rope");
    const auto note = [&](const RunDescription& scene, double time) {
        return chaos_note(scene, time, reference(scene, std::vector<double>{time}, effort).moments.back().error);
    };
    EXPECT_THAT(note(whip, 20), testing::HasSubstr("its Lyapunov exponent is "));
    EXPECT_EQ(note(calm, 20), "");
    EXPECT_EQ(note(whip, 2), "");
    // the partner: a reference that is inaccurate only for lack of effort
    EXPECT_EQ(chaos_note(calm, 5, 1), "");
}

TEST(Chaos, is_reported_with_advice) {
    StudyPlan plan;
    plan.scene = scene_with("rope", {{"c", 0}});
    plan.time = 20;
    const Reference lost = reference(plan.scene, std::vector<double>{plan.time}, {.most_particle_evaluations = 3e5});
    try {
        advise(plan, 1e-6, lost, [](double) {});
        ADD_FAILURE();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("The motion is chaotic"));
    }
}

}  // namespace
}  // namespace steplab::test
