#include "sim/run/starting.hpp"

#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// The moment of a run, as a trajectory holds it.
StartChange start_at(const Simulation& simulation, bool reverse = false) {
    Frame frame;
    simulation.frame(frame, {.positions = true, .displacements = true});
    StartingValues values{.given = "a",
                          .positions = frame.positions,
                          .velocities = frame.velocities,
                          .displacements = frame.displacements};
    return {std::make_shared<const StartingValues>(std::move(values)), reverse};
}

RunDescription gentle(std::string_view model, std::string_view method) {
    RunDescription run = run_of(model, method, Precision::double_, 0.01);
    if (run.scene.contains("c")) run.scene.set("c", 0);
    return run;
}

double distance(const State<double>& a, const State<double>& b, double sign) {
    double largest = 0;
    for (std::size_t i = 0; i < a.velocity.count(); ++i)
        largest = std::max({largest, length(a.displacement.at(i) - b.displacement.at(i)),
                            length(a.velocity.at(i) - sign * b.velocity.at(i))});
    return largest;
}

TEST(Starting, of_a_moment_of_a_run_continues_it_bit_for_bit) {
    for (const std::string model : {"chain", "mesh", "rope", "morse"}) {
        const RunDescription run = run_of(model, "rk4", Precision::double_, 0.01);  // one-step: no history
        Simulation whole(run), half(run);
        whole.advance(20);
        half.advance(10);
        RunDescription rest = run;
        rest.start = start_at(half);
        Simulation second(rest);
        second.advance(10);
        EXPECT_EQ(distance(whole.state(), second.state(), 1), 0) << model;
    }
}

// A symmetric method is its own inverse with reversed velocities: only rounding is left, some units of it a step.
TEST(Starting, reversed_brings_every_symmetric_method_back_to_the_start) {
    constexpr int steps = 200;
    for (const Method& method : methods()) {
        if (!method.info.reversible || method.info.adaptive) continue;
        for (const std::string model : {"chain", "oscillator", "mesh"}) {
            const RunDescription run = gentle(model, method.info.id);
            Simulation there(run);
            const State<double> start = there.state();
            there.advance(steps);
            RunDescription back = run;
            back.start = start_at(there, true);
            Simulation return_trip(back);
            return_trip.advance(steps);
            EXPECT_LT(distance(return_trip.state(), start, -1), 1e-11) << model << ' ' << method.info.id;
            EXPECT_GT(distance(there.state(), start, 1), 0.01) << model << ": it moved";
        }
    }
}

// x(-t) of a start is x(t) of the reversed one as long as no drag acts, and a step of -dt is computed like one of dt.
TEST(Starting, backward_in_time_is_the_motion_of_reversed_velocities) {
    for (const Method& method : methods()) {
        if (method.info.adaptive || method.info.curiosity) continue;
        for (const std::string model : {"chain", "rope", "morse"}) {
            RunDescription forward = gentle(model, method.info.id);
            if (chooses_its_steps(forward)) continue;
            RunDescription backward = forward;
            backward.dt = -forward.dt;
            forward.start.reverse = true;
            Simulation a(forward), b(backward);
            a.advance(50);
            b.advance(50);
            EXPECT_EQ(a.step(), b.step());
            EXPECT_EQ(b.time(), -a.time());
            EXPECT_LT(distance(a.state(), b.state(), -1), 1e-12) << model << ' ' << method.info.id;
        }
    }
}

TEST(Starting, backward_in_time_is_refused_of_methods_that_choose_their_steps) {
    RunDescription run = describe("chain", "dopri5");
    run.dt = -0.1;
    try {
        check(run);
        ADD_FAILURE();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("dopri5 chooses its own steps"));
    }
    run.dt = 0;
    EXPECT_THROW(check(run), UsageError);
}

TEST(Starting, takes_drag_backward_in_time_too) {
    RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 0.001, {{"c", 0.2}});
    Simulation there(run);
    const State<double> start = there.state();
    there.advance(500);
    RunDescription back = run;
    back.start = start_at(there);
    back.dt = -run.dt;
    Simulation return_trip(back);
    return_trip.advance(500);
    EXPECT_LT(distance(return_trip.state(), start, 1), 1e-6);  // second order: dt^2 = 1e-6 over t = 0.5
}

TEST(Starting, leaves_fixed_particles_without_velocity) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 0.01, {{"n", 4}});
    RunDescription other = run;
    StartingValues values{.given = "a",
                          .positions = {{1, 0, 0}, {2, 0, 0}, {4, 0, 0}, {6, 0, 0}},
                          .velocities = std::vector<Vec3>(4, Vec3{1, 1, 1})};
    other.start.from = std::make_shared<const StartingValues>(values);
    const Start start = plan_of(other).start;
    EXPECT_EQ(start[0].velocity, (Vec3{}));
    EXPECT_EQ(start[1].velocity, (Vec3{1, 1, 1}));
    EXPECT_EQ(start[0].displacement, (Vec3{1, 0, 0}));
    EXPECT_EQ(start[3].displacement, (Vec3{}));
}

TEST(Starting, of_another_number_of_particles_is_refused) {
    RunDescription run = describe("chain", "rk4");
    run.start.from = std::make_shared<const StartingValues>(
        StartingValues{.given = "a.csv", .positions = std::vector<Vec3>(3), .velocities = std::vector<Vec3>(3)});
    try {
        check(run);
        ADD_FAILURE();
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), HasSubstr("'a.csv' holds 3 particles, the scene has 10"));
    }
}

TEST(Starting, is_part_of_what_a_run_is) {
    const RunDescription run = describe("chain", "rk4");
    RunDescription reversed = run;
    reversed.start.reverse = true;
    EXPECT_NE(run, reversed);
    EXPECT_THAT(command_line(reversed), HasSubstr("--reverse"));
    RunDescription one = run, same = run, other = run;
    const auto values = [](double x) {
        return std::make_shared<const StartingValues>(
            StartingValues{.given = "a", .positions = {{x, 0, 0}}, .velocities = {{}}});
    };
    one.start.from = values(1);
    same.start.from = values(1);
    other.start.from = values(2);
    EXPECT_EQ(one, same) << "by content";
    EXPECT_NE(one, other);
    EXPECT_FALSE(exact_of(one)) << "the exact solution is that of the scene's own start";
    EXPECT_TRUE(exact_of(run));
}

}  // namespace
}  // namespace steplab::test
