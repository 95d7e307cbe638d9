#include "methods/engines/collisions.hpp"

#include "core/power.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/own_steps.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/grid.hpp"
#include "models/forces/line.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

constexpr std::string_view ids[] = {"dopri5", "dop853", "rkn-12-10", "taylor", "gauss-16", "ias15"};

// Two particles of a spring of rest length 1, the second thrown at the held first: from d = 1 it arrives at d = 0 with
// v^2 = v0^2 - 1, having moved as x = v0 sin t, and flies on as if the spring's other side began: d = -sin of what is
// left.
TEST(Collisions, of_a_chain_are_found_located_and_passed) {
    const double v0 = 2, meeting = std::asin(1 / v0), speed = std::sqrt(v0 * v0 - 1);
    for (const std::string_view id : ids) {
        Simulation simulation(run_to_tolerance("chain", id, 1, 1e-13, {{"n", 2}, {"L", 1}, {"v0", -v0}}));
        simulation.advance(1);
        const auto collisions = simulation.collisions();
        ASSERT_EQ(collisions.count(), 1u) << id;
        EXPECT_NEAR(collisions.kept()[0].time, meeting, 1e-12) << id;
        EXPECT_EQ(collisions.kept()[0].first, 0u);
        EXPECT_EQ(collisions.kept()[0].second, 1u);
        // behind: x'' = -(x + 1), x(0) = 0, x' = -speed
        const double left = 1 - meeting, x = std::cos(left) - 1 - speed * std::sin(left);
        EXPECT_NEAR(simulation.frame().positions[1].x, x, 1e-11) << id;
    }
}

TEST(Collisions, are_none_where_particles_keep_apart) {
    for (const std::string_view id : ids) {
        Simulation simulation(run_to_tolerance("chain", id, 1, 1e-10));
        simulation.advance(60);
        EXPECT_EQ(simulation.collisions().count(), 0u) << id;
    }
}

// A step across of finite length, in which drag alone acts: the second half kick has the drag of its own end, and one
// sees each half with its own acceleration.
TEST(Collisions, are_crossed_with_the_drag_of_either_side) {
    System<double, Line<double>> system(
        Line<double>({.count = 2, .first_fixed = true, .mass = 1, .k = 0, .rest_length = 1}), 0.5, 1);
    Motion<double> now(2), next(2);
    now.v.set(1, {0, 2, 0});
    now.a.set(1, {0, -1, 0});
    constexpr double time = 0.25;
    go_across(system, now, time, next);
    EXPECT_DOUBLE_EQ(next.x.y()[1], 2 * time * (2 - time));
    EXPECT_DOUBLE_EQ(next.v.y()[1], (2 - time) / (1 + time / 2));
    EXPECT_DOUBLE_EQ(next.a.y()[1], -0.5 * next.v.y()[1]);
    State<double> seen;
    within_crossing(now, next, time, 0.1, seen);
    EXPECT_DOUBLE_EQ(seen.displacement.y()[1], 0.1 * 2 - 0.01 / 2);
    EXPECT_DOUBLE_EQ(seen.velocity.y()[1], 2 - 0.1);
    within_crossing(now, next, time, 0.4, seen);
    EXPECT_DOUBLE_EQ(seen.displacement.y()[1], next.x.y()[1] - 0.1 * (next.v.y()[1] - 0.05 * next.a.y()[1]));
    EXPECT_DOUBLE_EQ(seen.velocity.y()[1], next.v.y()[1] - 0.1 * next.a.y()[1]);
}

// What is a collision and what is left to the control of errors: the rule itself, at a speed of 2 and an acceleration
// of 1.
TEST(Meeting, is_a_collision_where_its_turn_is_negligible) {
    const auto at = [](double distance, double miss) { return Meeting<double>{distance, distance / 2, miss, 1, 2}; };
    EXPECT_DOUBLE_EQ(at(1, 0.5).turn(), 0.25);
    EXPECT_TRUE(at(1, 0.05).is_collision(0, 1));      // from afar, on the way to it
    EXPECT_FALSE(at(1, 0.2).is_collision(0, 1));      // a pass at a distance
    EXPECT_FALSE(at(1, 0.2).is_collision(1, 1));      // of weak force, but never near
    EXPECT_TRUE(at(1, 0.2).is_collision(1, 10));      // seen from afar, and what is left does not matter
    EXPECT_FALSE(at(1, 0.2).is_collision(0.05, 10));  // and where it does
    EXPECT_FALSE((Meeting<double>{1, -1, 0, 1, 2}.is_collision(1, 1)));  // behind
    EXPECT_TRUE(at(1, 3e-6).is_seen_as_collision());
    EXPECT_FALSE(at(1, 5e-6).is_seen_as_collision());
    EXPECT_DOUBLE_EQ((Meeting<double>{1, -1, 0, 1, 2}.closest()), 1);
    EXPECT_DOUBLE_EQ(at(1, 0.5).turning_time(), 0.25);
}

// Steps are the same long or short before: what is guessed from a short one does not run away.
TEST(Guess, is_carried_on_over_no_more_than_four_steps) {
    EXPECT_EQ(guess_ratio(1.0, 2.0), 0.5);
    EXPECT_EQ(guess_ratio(1.0, 1e-9), 4.0);
}

// A kick along z alone moves along z, although nothing else is there: no axis is left out too many.
TEST(MovingAxes, are_those_of_positions_velocities_and_forces) {
    const auto axes = [](Vec3 x, Vec3 v, double gravity) {
        const System<double, Line<double>> system(Line<double>({.count = 2, .rest_length = 1, .gravity = gravity}), 0,
                                                  1);
        State<double> state{Field<double>(2), Field<double>(2)};
        state.displacement.set(1, x);
        state.velocity.set(1, v);
        return moving_axes(system.force(), state);
    };
    EXPECT_EQ(axes({1, 0, 0}, {1, 0, 0}, 0), 1u);
    EXPECT_EQ(axes({0, 0, 0}, {0, 0, 0}, 9), 2u);
    EXPECT_EQ(axes({0, 1e-300, 0}, {0, 0, 0}, 0), 2u);
    EXPECT_EQ(axes({0, 0, 0}, {0, -1, 0}, 0), 2u);
    EXPECT_EQ(axes({0, 0, -1}, {0, 0, 0}, 0), 3u);
    EXPECT_EQ(axes({0, 0, 0}, {0, 0, 1}, 0), 3u);
    const System<double, Grid<double>> mesh(Grid<double>({.rows = 3, .columns = 3}), 0, 1);
    EXPECT_EQ(moving_axes(mesh.force(), State<double>{Field<double>(9), Field<double>(9)}), 3u);
}

// What one sees between the ends of steps, the moment of the collision itself included: there x = -1, v = -speed.
TEST(Collisions, of_a_chain_look_right_from_all_sides) {
    const double meeting = std::asin(0.5), speed = std::sqrt(3.0);
    for (const std::string_view id : ids) {
        Simulation simulation(run_to_tolerance("chain", id, meeting / 100, 1e-13, {{"n", 2}, {"L", 1}, {"v0", -2}}));
        for (int i = 1; i <= 150; ++i) {
            simulation.advance(1);
            const double t = simulation.time(), left = t - meeting;
            const bool before = left < 0;
            const double x = before ? -2 * std::sin(t) : std::cos(left) - 2 - speed * std::sin(left);
            const double v = before ? -2 * std::cos(t) : -std::sin(left) - speed * std::cos(left);
            const Frame frame = simulation.frame();
            ASSERT_NEAR(frame.positions[1].x - 1, x, 1e-11) << id << " " << i;
            ASSERT_NEAR(frame.velocities[1].x, v, 1e-8) << id << " " << i;  // time is known to 1e-9 of a step
        }
        EXPECT_EQ(simulation.collisions().count(), 1u) << id;
    }
}

// What is kept of a run in the middle of its approach is enough to go on with the same bits, and names it once.
TEST(Collisions, come_again_after_a_return) {
    for (const std::string_view id : ids) {
        const double meeting = std::asin(0.5);
        Simulation simulation(run_to_tolerance("chain", id, meeting / 3, 1e-9, {{"n", 2}, {"L", 1}, {"v0", -2}}));
        simulation.advance(2);
        const auto before = simulation.save();
        simulation.advance(1);
        const auto within = simulation.save();
        simulation.advance(3);
        const std::string hash = simulation.hash();
        for (const auto& [saved, steps] : {std::pair(&before, 4u), std::pair(&within, 3u)}) {
            simulation.restore(*saved);
            simulation.advance(steps);
            EXPECT_EQ(simulation.hash(), hash) << id;
            EXPECT_EQ(simulation.collisions().count(), 1u) << id;
        }
    }
}

/// A ball thrown at the held end of its spring of rest length 1, to miss it by so much, until it is through.
struct Throw {
    std::uint64_t collisions;
    State<double> end;

    Throw(std::string_view id, double miss, double tolerance) {
        const RunDescription run = run_to_tolerance("chain", id, 1, tolerance, {{"n", 2}, {"L", 1}});
        const Plan scene = model("chain").plan(run.scene);
        State<double> state{Field<double>(2), Field<double>(2)};
        state.displacement.set(1, {0, miss, 0});
        state.velocity.set(1, {-2, 0, 0});
        const auto stepper = method(id).make({scene, state, run.method_parameters, run.precision, run.dt});
        stepper->advance(1);
        stepper->synchronised(end);
        collisions = stepper->collisions().count();
    }
};

TEST(Collisions, are_passes_through_each_other_whatever_the_tolerance) {
    for (const std::string_view id : ids) {
        // Near misses are crossed at one tolerance and resolved at the other: either way they are collisions.
        for (const double tolerance : {1e-6, 1e-13}) {
            for (const double miss : {0.0, 1e-14, 1e-10}) EXPECT_EQ(Throw(id, miss, tolerance).collisions, 1u) << miss;
            for (const double miss : {1e-3, 0.1}) EXPECT_EQ(Throw(id, miss, tolerance).collisions, 0u) << miss;
        }
        // a pass at a distance is smooth and keeps its accuracy: a greater height changes the end by much more
        const State<double> wide = Throw(id, 1e-3, 1e-13).end, right = Throw("rkn-12-10", 1e-3, 1e-15).end;
        EXPECT_NEAR(wide.displacement.x()[1], right.displacement.x()[1], 1e-10) << id;
        EXPECT_NEAR(wide.displacement.y()[1], right.displacement.y()[1], 1e-10) << id;
        EXPECT_GT(std::abs(right.displacement.y()[1] - Throw(id, 0.1, 1e-13).end.displacement.y()[1]), 1e-4) << id;
    }
}

// The cube of spacing 0.5 to t = 5: mirror pairs meet head on, some twice. All methods name the same, as nature does,
// at every tolerance.
TEST(Collisions, of_the_morse_cube_are_named_alike_by_all) {
    struct Named {
        std::uint32_t first, second;
        double time;
    };
    constexpr Named named[] = {{6, 18, 0.937855},  {8, 20, 0.938226},  {4, 10, 2.548747},
                               {16, 22, 2.549161}, {16, 22, 4.136706}, {4, 10, 4.136806}};
    for (const std::string_view id : ids) {
        for (const double tolerance : {1e-8, 1e-11}) {
            Simulation simulation(run_to_tolerance("morse", id, 5, tolerance, {{"spacing", 0.5}, {"v0", 1.5}}));
            simulation.advance(1);
            const CollisionRecord collisions = simulation.collisions();
            ASSERT_EQ(collisions.count(), std::size(named)) << id << " " << tolerance;
            for (std::size_t i = 0; i < std::size(named); ++i) {
                EXPECT_EQ(collisions.kept()[i].first, named[i].first) << id;
                EXPECT_EQ(collisions.kept()[i].second, named[i].second) << id;
                EXPECT_NEAR(collisions.kept()[i].time, named[i].time, 2e-6) << id;  // six digits above, and 1e-8 grown
            }
        }
    }
}

// The cube of spacing 0.5: mirror pairs meet head on. The error at t = 2 falls with the tolerance; a method that does
// not look, rk4, is off by 1e-3 there.
TEST(Collisions, of_the_morse_cube_do_not_stall_the_error) {
    const auto end = [](double tolerance, std::string_view id = "rkn-12-10") {
        Simulation simulation(run_to_tolerance("morse", id, 2, tolerance, {{"spacing", 0.5}, {"v0", 1.5}}));
        simulation.advance(1);
        EXPECT_EQ(simulation.collisions().count(), 2u);
        EXPECT_NEAR(simulation.collisions().kept()[0].time, 0.937855, 1e-5);  // as the finest run has it
        return simulation.frame();
    };
    const Frame right = end(1e-15);
    EXPECT_LT(distance(end(1e-12), right), 1e-10);
    EXPECT_LT(distance(end(1e-8), right), 1e-6);
    for (const std::string_view id : ids) {  // a hundred and a thousand times the tolerance, in a motion that grows
        EXPECT_LT(distance(end(1e-12, id), right), 2e-9) << id;
        EXPECT_LT(distance(end(1e-8, id), right), 1e-5) << id;
    }
    const Frame blind =
        frame_after(run_of("morse", "rk4", Precision::double_, 1.0 / 512, {{"spacing", 0.5}, {"v0", 1.5}}), 1024);
    EXPECT_GT(distance(blind, right), 1e-6);
}

// Where a step begins just behind a collision, the direction of the force has half of its digits. Methods that take it
// there would carry the rest along: 2e-9 at t = 5 if the first step were as long as the last before the collision,
// whatever the tolerance.
TEST(Collisions, leave_no_rounding_behind) {
    const auto end = [](std::string_view id, double tolerance) {
        return frame_after(run_to_tolerance("morse", id, 5, tolerance, {{"spacing", 0.5}, {"v0", 1.5}}), 1);
    };
    const Frame right = end("gauss-16", 1e-15);  // which takes no force where a step begins
    for (const std::string_view id : {"dopri5", "dop853", "rkn-12-10", "ias15"})
        EXPECT_LT(distance(end(id, 1e-13), right), 3e-10) << id;  // a thousand times the tolerance
    EXPECT_GT(distance(end("dopri5", 1e-11), right), 3e-10);
}

// How long a step may be: ten times the time since the collision where the tolerance is that of rounding, longer where
// it is wider, and then as long as it likes.
TEST(CollisionGuard, lets_steps_grow_behind_a_collision) {
    System<double, Line<double>> system(
        Line<double>({.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 1}), 0, 1);
    Motion<double> now(2), next(2);
    const auto allowed = [&](double tolerance) {
        CollisionGuard<double> guard(tolerance);
        CollisionGuard<double>::State state;
        state.approach.time = 1e-9;
        guard.state(state);
        EXPECT_EQ(guard.behind(1), 1);
        guard.cross(system, now, next, 0);
        std::vector<double> lengths;
        for (int step = 0; step < 12; ++step) lengths.push_back(guard.behind(1));
        return lengths;
    };
    const std::vector<double> tight = allowed(1e-16), wide = allowed(1e-10);
    for (std::size_t step = 0; step < 8; ++step)
        EXPECT_NEAR(tight[step], 1e-8 * std::pow(10, step), 1e-6 * tight[step]);
    EXPECT_EQ(tight[11], 1);
    EXPECT_NEAR(wide[0], 1e-9 * 1e-10 / 0x1p-52, 1e-6 * wide[0]);
    EXPECT_EQ(wide[2], 1);
}

// Against libm, which is right within an ulp.
TEST(Power, is_right) {
    for (const double base : {1e-300, 1e-9, 0.3, 0.75, 1.0, 1.4, 7.0, 1e12, 1e300}) {
        EXPECT_NEAR(logarithm(base), std::log(base), 4e-16 * std::max(1.0, std::abs(std::log(base)))) << base;
        EXPECT_NEAR(power(base, 1.0 / 11) / std::pow(base, 1.0 / 11), 1, 1e-13) << base;
    }
    EXPECT_EQ(power(1, 0.3), 1);
    EXPECT_LT(power(0, 0.1), 1e-30);
}

}  // namespace
}  // namespace steplab::test
