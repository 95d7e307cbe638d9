#include "lab/study/reference.hpp"

#include "models/head_on.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace steplab::test {
namespace {

double distance(const Field<double>& a, const Field<double>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.count(); ++i) largest = std::max(largest, length(a.at(i) - b.at(i)));
    return largest;
}

/// A run and the closed form of one scene.
struct Pair {
    Reference run, exact;
};

Pair both(const RunDescription& scene, const std::vector<double>& times, const ReferenceEffort& effort = {}) {
    return {reference_run(scene, times, effort), reference(scene, times)};
}

/// The true error is at most 10 times the estimates plus the rounding of the closed form.
void expect_honest(const Pair& pair) {
    ASSERT_TRUE(pair.exact.exact);
    ASSERT_FALSE(pair.run.exact);
    for (std::size_t i = 0; i < pair.run.moments.size(); ++i) {
        const ReferenceMoment &run = pair.run.moments[i], &exact = pair.exact.moments[i];
        EXPECT_EQ(run.time, exact.time);
        EXPECT_LE(distance(run.state.displacement, exact.state.displacement), 10 * (run.error + exact.error))
            << run.time;
    }
}

const std::vector<double> times{0, 0.1, 3, 20.5, 68.1};

TEST(Reference, estimates_its_error_correctly_where_the_solution_is_known) {
    for (const auto& scene : {scene_with("free"), scene_with("oscillator"), scene_with("oscillator", {{"c", 0.7}}),
                              scene_with("oscillator", {{"c", 9}, {"k", 3}}), scene_with("chain"),
                              scene_with("chain", {{"fixed", 0}}), scene_with("chain", {{"c", 0.2}, {"n", 5}})}) {
        SCOPED_TRACE(command_line(scene));
        expect_honest(both(scene, times));
    }
}

// Displacements of 2: a few roundings of a double; with absolute positions near 18 they would be ten times as large.
TEST(Reference, of_the_chain_is_accurate_to_rounding) {
    const Pair pair = both(scene_with("chain"), {68.1});
    EXPECT_LT(pair.exact.moments[0].error, 2e-15);
    EXPECT_LT(pair.run.moments[0].error, 2e-15);
    EXPECT_LT(distance(pair.run.moments[0].state.displacement, pair.exact.moments[0].state.displacement), 1e-15);
    EXPECT_LT(distance(pair.run.moments[0].state.velocity, pair.exact.moments[0].state.velocity), 3e-15);
}

// The partner: steps far too long, with an estimate that says so.
TEST(Reference, of_too_coarse_steps_has_a_large_estimate) {
    const Pair pair = both(scene_with("oscillator"), {68.1}, {.error = 0, .first_phase = 8, .most_refinements = 0});
    const double error = distance(pair.run.moments[0].state.displacement, pair.exact.moments[0].state.displacement);
    EXPECT_GT(error, 1e-9);
    EXPECT_GT(pair.run.moments[0].error, error / 10);
    EXPECT_EQ(error_against(pair.run.moments[0], pair.run.moments[0].state.displacement), pair.run.moments[0].error);
}

TEST(Reference, keeps_to_the_allowed_cost) {
    const Reference cheap =
        reference_run(scene_with("mesh"), std::vector<double>{20}, {.most_particle_evaluations = 1});
    const Reference fine = reference_run(scene_with("mesh"), std::vector<double>{20});
    EXPECT_GT(cheap.moments[0].error, 100 * fine.moments[0].error);
    EXPECT_LT(fine.moments[0].error, 1e-13);
    EXPECT_LE(distance(cheap.moments[0].state.displacement, fine.moments[0].state.displacement),
              10 * cheap.moments[0].error);
}

// No distance is below 0.163 with this spacing up to t = 2; a run of another family agrees.
TEST(Reference, of_the_morse_cube_agrees_with_a_fine_run_of_another_family) {
    RunDescription run = run_of("morse", "kahan-li-8", Precision::double_, 1.0 / 256, {{"spacing", 0.3}});
    run.method_parameters.set("compensated", 1);
    const Reference right = reference(run, std::vector<double>{2});
    EXPECT_LT(right.moments[0].error, 1e-13);
    Simulation simulation(run);
    simulation.advance(512);
    const Frame frame = simulation.frame();
    for (std::size_t i = 0; i < frame.positions.size(); ++i)  // positions up to 8: 100 roundings of an ulp of 8
        EXPECT_LT(length(frame.positions[i] - right.moments[0].state.displacement.at(i)), 1e-12) << i;
}

// Where particles pass through each other the force jumps, and steps that do not locate collisions lose their order.
// The reference crosses collisions: three methods of other families agree with it within its own estimate.
TEST(Reference, crosses_collisions) {
    const RunDescription scene = scene_with("morse", {{"spacing", 0.5}, {"v0", 1.5}});
    const Reference right = reference(scene, std::vector<double>{1}, {.most_particle_evaluations = 1});
    EXPECT_LT(right.moments[0].error, 1e-9);
    EXPECT_NE(right.how.find("2 collisions"), std::string::npos) << right.how;
    for (const char* id : {"rkn-12-10", "gauss-16", "taylor"}) {
        RunDescription run = with_method(scene, id);
        run.dt = 1;
        run.method_parameters.set("tolerance", 1e-14);
        const Frame frame = frame_after(run, 1);
        for (std::size_t i = 0; i < frame.positions.size(); ++i)
            EXPECT_LT(length(frame.positions[i] - right.moments[0].state.displacement.at(i)), 1e-10) << id << " " << i;
    }
    const Frame blind = frame_after(scene_with("morse", {{"spacing", 0.5}, {"v0", 1.5}}), 10);  // rk4
    EXPECT_GT(length(blind.positions[6] - right.moments[0].state.displacement.at(6)), 1e-6);
}

TEST(Reference, of_a_float_run_is_that_of_its_parameters) {
    RunDescription run = scene_with("oscillator", {{"k", 1.1}});
    run.precision = Precision::float_;
    const Reference in_float = reference(run, std::vector<double>{10});
    run.precision = Precision::double_;
    run.scene.set("k", static_cast<double>(1.1f));
    EXPECT_EQ(distance(in_float.moments[0].state.displacement,
                       reference(run, std::vector<double>{10}).moments[0].state.displacement),
              0);
}

TEST(RestingReference, is_that_of_the_published_rope) {
    const auto rest = resting_reference(scene_with("rope"));
    ASSERT_TRUE(rest.has_value());
    EXPECT_NEAR(rest->state.displacement.y()[9], -6.70725, 1e-14);
    EXPECT_NEAR(rest->state.displacement.x()[9], -4.5, 1e-14);
    EXPECT_FALSE(resting_reference(scene_with("rope", {{"c", 0}})).has_value());
    EXPECT_FALSE(resting_reference(scene_with("chain")).has_value());
    // with strong drag a run of 200 s ends there: the slowest motion has decayed by e^-100
    const Reference late = reference_run(scene_with("rope", {{"c", 1}}), std::vector<double>{200}, {.error = 1e-12});
    EXPECT_LT(error_against(*rest, late.moments[0].state.displacement), 1e-12 + 10 * late.moments[0].error);
}

/// Two particles, head on. Deep and hard cores do not touch; soft ones do.
struct HeadOn {
    const char* what;
    double depth, k, r0, v0, until;
};

class HeadOnMotion : public testing::TestWithParam<HeadOn> {};

TEST_P(HeadOnMotion, is_that_of_a_fine_run) {
    const HeadOn& c = GetParam();
    const RunDescription scene =
        scene_with("morse", {{"edge", 1}, {"D", c.depth}, {"k", c.k}, {"r0", c.r0}, {"v0", c.v0}});
    const auto exact = model("morse").exact(scene.scene);
    ASSERT_TRUE(exact);
    ASSERT_GT(exact->valid_until(), c.until);
    const Pair pair = both(scene, {c.until / 3, c.until});
    expect_honest(pair);
    EXPECT_LT(pair.run.moments[1].error, 1e-12);
    EXPECT_LT(distance(pair.run.moments[1].state.velocity, pair.exact.moments[1].state.velocity), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, HeadOnMotion,
    testing::Values(HeadOn{"published_until_they_touch", 1, 0.5, 0.5, 1, 6.5},
                    HeadOn{"hard_core_scatters", 1, 50, 2, 1, 20},
                    HeadOn{"hard_core_scatters_from_a_thousand_times_the_depth", 1, 50, 2, 60, 0.3},
                    HeadOn{"hard_core_bound", 1, 0.5, 4, 0, 60}, HeadOn{"escapes", 1, 0.5, 0.5, -3, 20}),
    [](const auto& test) { return std::string(test.param.what); });

TEST(HeadOn, touches_where_the_distance_reaches_zero) {
    const auto exact = model("morse").exact(scene_with("morse", {{"edge", 1}}).scene);
    const double touch = exact->valid_until();
    EXPECT_NEAR(exact->displacement(0, touch).x, exact->displacement(1, touch).x, 1e-13);
    EXPECT_GT(exact->displacement(0, 0.999 * touch).x, exact->displacement(1, 0.999 * touch).x);
    EXPECT_EQ(exact->displacement(0, 0).x, 0);
    EXPECT_NEAR(exact->displacement(1, 0).x, -10, 1e-15);
    EXPECT_EQ(model("morse").exact(scene_with("morse", {{"edge", 1}, {"v0", -3}}).scene)->valid_until(), infinity);
    EXPECT_FALSE(model("morse").exact(scene_with("morse", {{"edge", 1}, {"cutoff", 3}}).scene));
    EXPECT_FALSE(model("morse").exact(scene_with("morse").scene));
}

// At the exact threshold of escape the energy is 0 and the general solution divides 0 by 0: its limit is taken.
TEST(HeadOn, is_smooth_at_the_threshold_of_escape) {
    const PairForces pair{.count = 2, .mass = 1, .depth = 1, .k = 0.5, .r0 = 4};
    const double e = std::exp(-0.5 * 6), threshold = std::sqrt(4 * e * (2 - e));
    const auto at = [&](double factor) {
        return head_on_solution(pair, -10, factor * threshold)->displacement(1, 30).x;
    };
    EXPECT_NEAR(at(1 - 1e-9), at(1), 1e-6);
    EXPECT_NEAR(at(1 + 1e-9), at(1), 1e-6);
}

// In a run the error is given until they touch, and not after.
TEST(HeadOn, is_no_measure_after_they_touched) {
    Simulation simulation(run_of("morse", "kahan-li-8", Precision::double_, 0.01, {{"edge", 1}}));
    const double touch = model("morse").exact(simulation.description().scene)->valid_until();
    while (simulation.time() + 0.02 < touch) simulation.advance(1);
    ASSERT_TRUE(simulation.diagnostics().error.has_value());
    EXPECT_LT(*simulation.diagnostics().error, 1e-11);
    EXPECT_TRUE(simulation.exact_position(1, simulation.time()).has_value());
    simulation.advance(5);
    EXPECT_FALSE(simulation.diagnostics().error.has_value());
    EXPECT_FALSE(simulation.exact_position(1, simulation.time()).has_value());
}

// The partner: a run whose spring constant is 1e-6 off is no reference.
TEST(ReferenceOfAWrongScene, is_refused) {
    const Reference wrong = reference(scene_with("chain", {{"k", 1.000001}}), std::vector<double>{68.1});
    const Reference right = reference_run(scene_with("chain"), std::vector<double>{68.1});
    EXPECT_GT(distance(wrong.moments[0].state.displacement, right.moments[0].state.displacement),
              1e6 * (right.moments[0].error + wrong.moments[0].error));
}

}  // namespace
}  // namespace steplab::test
