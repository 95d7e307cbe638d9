#include "methods/taylor.hpp"

#include "core/error.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "support/circling_ball.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace steplab::test {
namespace {

/// The chain with its exact solution, in any number type, to one frame at `time`.
template <class T>
State<T> chain_at(double tolerance, T time, std::uint64_t* evaluations = nullptr) {
    System<T, Line<T>> system(Line<T>({.count = 10, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 2}), T(0),
                              time);
    State<T> state{Field<T>(10), Field<T>(10)};
    state.velocity.x()[9] = T(2);
    ParameterValues values(Taylor::parameters);
    values.set("tolerance", tolerance);
    Taylor::Integrator<T> integrator(values);
    integrator.start(system, state);
    integrator.step(system);
    integrator.synchronised(system, state);
    if (evaluations) *evaluations = system.evaluations();
    return state;
}

RunDescription chain(double tolerance, double dt = 0.1) {
    RunDescription description = run_of("chain", "taylor", Precision::double_, dt);
    description.method_parameters.set("tolerance", tolerance);
    return description;
}

/// Largest distance from the exact solution.
double chain_error(const RunDescription& description, std::uint64_t steps) {
    Simulation simulation(description);
    simulation.advance(steps);
    const auto exact = model("chain").exact(description.scene);
    State<double> state{Field<double>(10), Field<double>(10)};
    const Plan scene = model("chain").plan(description.scene);
    const Frame frame = simulation.frame();
    double worst = 0;
    for (std::size_t i = 0; i < 10; ++i) {
        const Vec3 u = frame.positions[i] - scene.reference.at(i);
        worst =
            std::max(worst, steplab::length(u - exact->displacement(i, static_cast<double>(steps) * description.dt)));
    }
    return worst;
}

// The error at the end in proportion to the tolerance: the factor between them the same within 30.
TEST(Taylor, errors_are_in_proportion_to_the_tolerance) {
    double least = infinity, most = 0;
    for (double tolerance = 1e-3; tolerance > 0.5e-12; tolerance /= 10) {
        // positions near 18 have an ulp of 3.6e-15: far below
        const double factor = chain_error(chain(tolerance), 681) / tolerance;
        least = std::min(least, factor);
        most = std::max(most, factor);
    }
    EXPECT_LT(most, 30 * least);
    EXPECT_LT(most, 30);
}

TEST(Taylor, reaches_1e_14_on_the_chain) {
    const State<double> state = chain_at<double>(1e-16, 68.1);
    const State<long double> right = chain_at<long double>(1e-19, 68.1);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_NEAR(state.displacement.x()[i], static_cast<double>(right.displacement.x()[i]), 1e-14) << i;
        EXPECT_NEAR(state.velocity.x()[i], static_cast<double>(right.velocity.x()[i]), 1e-14) << i;
    }
    const auto exact = model("chain").exact(describe("chain").scene);
    for (std::size_t i = 0; i < 10; ++i)
        EXPECT_NEAR(static_cast<double>(right.displacement.x()[i]), exact->displacement(i, 68.1).x, 1e-14) << i;
    const State<double> coarse = chain_at<double>(1e-10, 68.1);  // the partner
    EXPECT_GT(std::abs(coarse.displacement.x()[9] - static_cast<double>(right.displacement.x()[9])), 1e-14);
}

// Orders 1 to 19 of the oscillator x = sin t, seen through the sum at many times between the ends of one long step.
TEST(Taylor, follows_sine_and_cosine_between_its_steps) {
    System<double, Line<double>> system(
        Line<double>({.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 0}), 0, 0.01);
    State<double> state{Field<double>(2), Field<double>(2)};
    state.velocity.x()[1] = 1;
    ParameterValues values(Taylor::parameters);
    values.set("tolerance", 1e-15);
    Taylor::Integrator<double> integrator(values);
    integrator.start(system, state);
    for (int frame = 1; frame <= 1000; ++frame) {
        integrator.step(system);
        integrator.synchronised(system, state);
        ASSERT_NEAR(state.displacement.x()[1], std::sin(0.01 * frame), 5e-15) << frame;
        ASSERT_NEAR(state.velocity.x()[1], std::cos(0.01 * frame), 5e-15) << frame;
    }
    EXPECT_LT(system.evaluations(), 400u);  // 1000 frames, not a step more than the motion asks for
}

/// A ball on a spring in mid-swing, after a time inside the first series.
State<Real> swing_after(Real time, double tolerance, Real drag) {
    System<Real, Line<Real>> system(Line<Real>({.count = 2, .first_fixed = true, .mass = 1, .k = 2, .rest_length = 1}),
                                    drag, time);
    State<Real> state{Field<Real>(2), Field<Real>(2)};
    state.displacement.set(1, {0.5, -0.25, 0});
    state.velocity.set(1, {0.25, 0.5, 0});
    ParameterValues values(Taylor::parameters);
    values.set("tolerance", tolerance);
    Taylor::Integrator<Real> integrator(values);
    integrator.start(system, state);
    integrator.step(system);
    integrator.synchronised(system, state);
    return state;
}

/// The exponents with which the errors of position and velocity fall; a series of 26 orders is right there.
std::pair<double, double> exponents_inside(double tolerance, Real drag) {
    constexpr Real late = 0.5L, early = 0.35L;
    const auto errors = [&](Real time) {
        const State<Real> state = swing_after(time, tolerance, drag), right = swing_after(time, 1e-20, drag);
        const auto off = [](const Field<Real>& a, const Field<Real>& b) {
            return std::hypot(a.x()[1] - b.x()[1], a.y()[1] - b.y()[1]);
        };
        return std::pair(off(state.displacement, right.displacement), off(state.velocity, right.velocity));
    };
    const auto [x_late, v_late] = errors(late);
    const auto [x_early, v_early] = errors(early);
    return {exponent(x_late, x_early, late / early), exponent(v_late, v_early, late / early)};
}

// At the default tolerance the series of positions ends with t^20 and leaves t^21, that of velocities t^20; at 1e-3,
// the partner, with t^16.
TEST(Taylor, has_its_order_inside_a_step) {
    for (const Real drag : {0.0L, 0.3L}) {
        const auto [x, v] = exponents_inside(1e-9, drag);
        EXPECT_NEAR(x, 21, 0.3) << drag;
        EXPECT_NEAR(v, 20, 0.3) << drag;
        EXPECT_NEAR(exponents_inside(1e-3, drag).second, 16, 0.3) << drag;
    }
}

TEST(Taylor, dense_frames_cost_nothing_and_show_the_same_motion) {
    Simulation rare(chain(1e-9, 0.1)), dense(chain(1e-9, 0.0001));
    rare.advance(200);
    dense.advance(200000);
    // a series or two more until the unit of time fits
    EXPECT_LE(dense.evaluations(), rare.evaluations() + 3 * 19);
    EXPECT_LT(distance(rare.frame(), dense.frame()), 1e-8);  // both within some times the tolerance
    EXPECT_LT(chain_error(chain(1e-12, 0.0001), 20001), 1e-11);
}

/// Distance between runs of two tolerances, the scene everywhere smooth.
double change_with_tolerance(RunDescription description, double coarse, std::uint64_t steps) {
    description.method_parameters.set("tolerance", coarse);
    const Frame a = frame_after(description, steps);
    description.method_parameters.set("tolerance", 1e-15);
    return distance(a, frame_after(description, steps));
}

TEST(Taylor, does_drag_gravity_meshes_and_morse) {
    const std::pair<RunDescription, std::uint64_t> runs[] = {
        {run_of("rope", "taylor", Precision::double_, 0.1), 10},
        {run_of("chain", "taylor", Precision::double_, 0.1, {{"c", 0.3}, {"fixed", 0}}), 100},
        {run_of("mesh", "taylor", Precision::double_, 0.5), 20},
        {run_of("morse", "taylor", Precision::double_, 0.1, {{"spacing", 0.3}}), 10},
        {run_of("free", "taylor", Precision::double_, 0.1), 100},
    };
    for (const auto& [description, steps] : runs) {
        EXPECT_LT(change_with_tolerance(description, 1e-10, steps), 1e-7) << description.model;
        RunDescription other = with_method(description, "kahan-li-8");
        other.dt = description.dt / 128;
        RunDescription fine = description;
        fine.method_parameters.set("tolerance", 1e-13);
        // order 8 at steps of 1/256 and less: below 1e-9 on these scenes, rounding of 2560 steps included
        EXPECT_LT(distance(frame_after(fine, steps), frame_after(other, 128 * steps)), 1e-8) << description.model;
    }
}

// Where pairs cross a cut-off the force jumps; steps end there. rk4 does not look and is of first order there: at a
// thousandth of the step its error is below 1e-4.
TEST(Taylor, ends_its_steps_where_pairs_cross_the_cut_off) {
    const Settings settings = {{"spacing", 0.3}, {"cutoff", 0.8}};
    EXPECT_LT(change_with_tolerance(run_of("morse", "taylor", Precision::double_, 0.1, settings), 1e-9, 5), 1e-6);
    const Frame fine = frame_after(run_of("morse", "rk4", Precision::double_, 1e-4, settings), 5000);
    EXPECT_LT(distance(frame_after(run_of("morse", "taylor", Precision::double_, 0.1, settings), 5), fine), 1e-4);
}

TEST(Taylor, with_drag_left_out_is_not_the_motion) {
    RunDescription damped = run_of("chain", "taylor", Precision::double_, 0.1, {{"c", 0.3}});
    RunDescription free = run_of("chain", "taylor", Precision::double_, 0.1, {{"c", 0.299}});
    EXPECT_GT(distance(frame_after(damped, 50), frame_after(free, 50)), 1e-4);
}

TEST(Taylor, works_in_float) {
    RunDescription description = chain(1e-6);
    description.precision = Precision::float_;
    // positions up to 18 as float holds them, and the tolerance over some 20 steps
    EXPECT_LT(chain_error(description, 681), 1e-4);
    RunDescription stiff = run_of("rope", "taylor", Precision::float_, 0.001, {{"k", 2e7}});
    Simulation simulation(stiff);
    simulation.advance(10);
    EXPECT_FALSE(simulation.divergence());
}

TEST(Taylor, comes_back_to_the_same_bits) {
    for (const char* id : {"chain", "rope", "mesh", "morse"}) {
        Simulation simulation(run_of(id, "taylor", Precision::double_, 0.03));
        simulation.advance(7);
        const auto snapshot = simulation.save();
        const Frame then = simulation.frame();
        simulation.advance(11);
        const std::string hash = simulation.hash();
        simulation.restore(snapshot);
        EXPECT_EQ(simulation.frame().positions, then.positions) << id;
        simulation.advance(11);
        EXPECT_EQ(simulation.hash(), hash) << id;
    }
}

TEST(Taylor, counts_a_series_of_so_many_orders_as_so_many_evaluations) {
    std::uint64_t evaluations = 0;
    chain_at<double>(1e-9, 68.1, &evaluations);
    EXPECT_EQ(evaluations % 19, 0u);  // x to order 20: accelerations to order 18, 19 of them
    EXPECT_LT(evaluations, 1000u);
}

// A bullet so far away that its force is far below the tolerance: the step must not reach through the collision.
TEST(Taylor, does_not_step_over_what_it_cannot_feel_yet) {
    RunDescription description = run_of("morse", "taylor", Precision::double_, 1, {{"spacing", 0.3}, {"k", 5}});
    EXPECT_LT(change_with_tolerance(description, 1e-8, 7), 1e-5);
}

TEST(Taylor, passes_through_a_head_on_collision_in_finite_time) {
    RunDescription description = run_of("morse", "taylor", Precision::double_, 0.1);
    Simulation simulation(description);
    simulation.advance(15);  // particles pass through each other first at t = 0.94
    EXPECT_FALSE(simulation.divergence());
    EXPECT_LT(std::abs(simulation.diagnostics().energy_error), 1e-2);
}

// Two particles of a spring at one place: the force there is none, and a moment later it is all there.
TEST(Taylor, begins_at_coincident_particles_with_a_short_step) {
    System<double, Line<double>> system(
        Line<double>({.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 1}), 0, 0.5);
    State<double> state{Field<double>(2), Field<double>(2)};
    state.displacement.x()[1] = -1;
    state.velocity.x()[1] = 0.5;
    Taylor::Integrator<double> integrator{ParameterValues(Taylor::parameters)};
    integrator.start(system, state);
    integrator.step(system);
    integrator.synchronised(system, state);
    // the first step is 1e-8 of a time unit, in which the force is not that of the formula
    EXPECT_NEAR(state.displacement.x()[1], 0.5 * std::sin(0.5) - std::cos(0.5), 1e-7);
}

// Eight Morse particles whose distances have no square, and a bullet that passes them: they stay together.
TEST(Taylor, goes_on_with_particles_that_stay_at_one_place) {
    const auto run = [](const char* method) {
        return run_of("morse", method, Precision::double_, 1, {{"edge", 2}, {"spacing", 1e-200}, {"r0", 0.2}});
    };
    Simulation simulation(run("taylor"));
    simulation.advance(3);
    EXPECT_LT(simulation.evaluations(), 1000u);                                    // steps of 1e-8 would take 1e9
    EXPECT_LT(distance(simulation.frame(), frame_after(run("dop853"), 3)), 1e-6);  // both at tolerance 1e-9
}

TEST(Taylor, refuses_more_pairs_than_memory_holds) {
    try {
        check(run_of("morse", "taylor", Precision::double_, 0.01, {{"edge", 20}}));
        ADD_FAILURE();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("taylor cannot run this scene: "));
    }
}

// What is left of the motion is noise: steps as long as its velocities allow would let the high terms of the series
// grow, to metres within 10^4 frames. 2e-6 is four ulps of the position.
TEST(Taylor, in_float_rests_where_drag_has_ended_the_motion) {
    for (const double drag : {2.8, 2.9, 3.0, 3.1, 3.2}) {
        Simulation simulation(run_of("rope", "taylor", Precision::float_, 0.01, {{"c", drag}}));
        simulation.advance(10000);
        for (int look = 0; look < 100; ++look) {
            simulation.advance(100);
            EXPECT_NEAR(simulation.frame().positions[9].y, -6.70725, 2e-6) << drag << " " << simulation.time();
        }
    }
}

}  // namespace
}  // namespace steplab::test
