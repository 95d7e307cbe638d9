#include "sim/run/act.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

constexpr Vec3 place{3, -2, 1};

/// Free particles without gravity.
RunDescription drifting(Precision precision) { return run_of("free", "velocity-verlet", precision, 0.01, {{"n", 3}}); }

/// Tugs particle 0 towards the place after every few steps; the distances after each tug.
std::vector<double> distances_while_tugged(Simulation& run, double rate, int tugs, std::uint64_t steps) {
    std::vector<double> distances;
    for (int i = 0; i < tugs; ++i) {
        run.act(Tug{0, place, rate, i > 0, {}, static_cast<double>(steps) * run.dt()});
        run.advance(steps);
        distances.push_back(length(run.frame().positions[0] - place));
    }
    return distances;
}

TEST(Act, a_tugged_free_particle_comes_to_the_place_and_stays) {
    for (const Precision precision : precisions) {
        for (const double rate : {0.5, 3.0, 1e3}) {
            Simulation run(drifting(precision));
            run.act(Kick{0, {0, 4, 0}});
            const auto distances = distances_while_tugged(run, rate, static_cast<int>(100 / rate) + 100, 10);
            EXPECT_LT(distances.back(), 1e-3) << rate;  // e^-(rate t) of some metres, t > 10 s
            EXPECT_LT(length(run.frame().velocities[0]), 1e-3) << rate;
        }
        Simulation alone(drifting(precision));
        alone.advance(1000);
        EXPECT_GT(length(alone.frame().positions[0] - place), 0.1) << "it would not have come by itself";
    }
}

// Critically damped: with an undamped spring it would pass the place.
TEST(Act, a_tugged_particle_does_not_pass_the_place) {
    Simulation run(drifting(Precision::double_));
    const double before = length(run.frame().positions[0] - place);
    double last = before;
    for (const double distance : distances_while_tugged(run, 2, 200, 5)) {
        EXPECT_LE(distance, last * (1 + 1e-12));
        last = distance;
    }
}

// The same impulse on twice the duration and other states: the implicit step solves its equation.
TEST(Act, a_tug_is_the_implicit_step_of_a_damped_spring) {
    const Tug tug{.particle = 0, .position = {}, .rate = 3, .duration = 0.2};
    for (const double v : {-1.0, 0.0, 5.0}) {
        for (const double distance : {-2.0, 0.0, 1.5}) {
            const double now = v + gained(tug, distance, 0.0, v), x = 0.2 * now;
            EXPECT_NEAR(now - v, 0.2 * (9 * (distance - x) - 6 * now), 1e-14);
        }
    }
}

// Where time runs backward, the place is ahead in the direction in which the run goes.
TEST(Act, a_tug_works_backward_in_time) {
    RunDescription back = drifting(Precision::double_);
    back.dt = -0.01;
    Simulation run(back);
    EXPECT_LT(distances_while_tugged(run, 3, 200, 5).back(), 1e-3);
}

TEST(Act, others_gain_the_same) {
    for (const Precision precision : precisions) {
        Simulation run(drifting(precision));
        run.act(Kick{1, {0, 0, 2}});
        const Frame before = run.frame();
        const ParticleList others({2});
        run.act(Kick{1, {0.5, 0, 0}, others});
        run.act(Tug{1, place, 2, false, others, 0.1});
        const Frame tugged = run.frame();
        EXPECT_NEAR(
            length((tugged.velocities[1] - before.velocities[1]) - (tugged.velocities[2] - before.velocities[2])), 0,
            1e-6);
        EXPECT_GT(length(tugged.velocities[1] - before.velocities[1]), 0.5);
        EXPECT_EQ(tugged.velocities[0], before.velocities[0]);
        run.act(Pull{1, place, others});
        const Frame pulled = run.frame();
        EXPECT_EQ(pulled.positions[1], place);
        EXPECT_NEAR(length((pulled.positions[2] - pulled.positions[1]) - (before.positions[2] - before.positions[1])),
                    0, 1e-6);
        EXPECT_EQ(pulled.velocities[2], Vec3{});
    }
}

TEST(Act, fixed_particles_are_left_out) {
    const Simulation run(describe("chain"));
    const Shape& shape = *run.shape();  // particle 0 is fixed
    EXPECT_FALSE(acts(Kick{3, {1, 0, 0}, ParticleList({0, 4})}, shape));
    EXPECT_FALSE(on_moving(Kick{0, {1, 0, 0}, ParticleList({4})}, shape));
    EXPECT_FALSE(on_moving(Kick{10, {1, 0, 0}}, shape)) << "there is none";
    const auto rest = on_moving(Kick{3, {1, 0, 0}, ParticleList({0, 3, 4, 99})}, shape);
    EXPECT_EQ(rest, Act(Kick{3, {1, 0, 0}, ParticleList({4})}));
}

// What is done to particles at the start is not lost by a change of dt there.
TEST(Act, at_the_start_it_stays_when_the_description_changes) {
    Simulation run(describe("chain"));
    run.act(Pull{5, place});
    RunDescription other = run.description();
    other.dt = 0.05;
    run.change(other);
    EXPECT_EQ(run.frame().positions[5], place);
    EXPECT_EQ(run.description().dt, 0.05);
}

}  // namespace
}  // namespace steplab::test
