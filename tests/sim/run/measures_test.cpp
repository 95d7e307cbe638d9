#include "sim/run/measures.hpp"

#include "sim/run/energy.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace steplab::test {
namespace {

State<double> anywhere(std::size_t count) {
    State<double> state{Field<double>(count), Field<double>(count)};
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    for (std::size_t i = 0; i < count; ++i) {
        state.displacement.set(i, {number(random), number(random), number(random)});
        state.velocity.set(i, {number(random), number(random), number(random)});
    }
    return state;
}

struct Sums {
    long double px = 0, py = 0, pz = 0, lx = 0, ly = 0, lz = 0, displacement = 0, speed = 0;
    long double sizes = 0;  ///< of the terms of angular momentum
};
Sums plain_sums(const Plan& scene, const Shape& shape, const State<double>& state) {
    Sums sums;
    const long double m = scene.mass;
    for (std::size_t i = 0; i < state.velocity.count(); ++i) {
        const Vec3 x = scene.reference.at(i) + state.displacement.at(i), v = state.velocity.at(i);
        const long double rx = x.x, ry = x.y, rz = x.z;
        sums.px += m * v.x, sums.py += m * v.y, sums.pz += m * v.z;
        sums.lx += m * (ry * v.z - rz * v.y), sums.ly += m * (rz * v.x - rx * v.z),
            sums.lz += m * (rx * v.y - ry * v.x);
        sums.displacement = std::max(sums.displacement, static_cast<long double>(length(x - shape.rest[i])));
        sums.speed = std::max(sums.speed, static_cast<long double>(length(v)));
        sums.sizes += m * length(x) * length(v);
    }
    return sums;
}

Diagnostics in_pieces(const Plan& scene, const Shape& shape, const State<double>& state) {
    EnergyMeter meter(scene, fastest_instructions());
    ParticleSums sums(scene, shape, meter.pieces());
    meter.energy(
        1,
        [&](const PortionSink& sink) {
            sink({0, state.velocity.count(), state});
        },
        [&](const Piece& piece) { sums.add(piece); });
    return sums.result();
}

// In several pieces, which share particles; a particle that is counted twice or not at all shows: one is a thousandth
// of the sums. Of n terms a sum rounds n / 2 ulp of its largest part at most, much less on the average.
TEST(ParticleSums, are_those_of_plain_sums_in_long_double) {
    for (const RunDescription& run : {run_of("chain", "euler", Precision::double_, 0.1, {{"n", 9001}, {"m", 2}}),
                                      run_of("mesh", "euler", Precision::double_, 0.1, {{"dim", 131}}),
                                      run_of("crystal", "euler", Precision::double_, 0.1, {{"edge", 14}})}) {
        const Plan scene = model_of(run).plan(run.scene);
        const Shape shape = model_of(run).shape(run.scene);
        const State<double> state = anywhere(scene.reference.count);
        const Sums expected = plain_sums(scene, shape, state);
        const Diagnostics found = in_pieces(scene, shape, state);
        const auto rounding = static_cast<double>(expected.sizes) * 100 * std::numeric_limits<double>::epsilon();
        const auto near = [&](double number, long double right) {
            EXPECT_NEAR(number, static_cast<double>(right), rounding) << run.model;
        };
        near(found.momentum.x, expected.px), near(found.momentum.y, expected.py), near(found.momentum.z, expected.pz);
        near(found.angular_momentum.x, expected.lx), near(found.angular_momentum.y, expected.ly);
        near(found.angular_momentum.z, expected.lz);
        EXPECT_NEAR(found.max_displacement, static_cast<double>(expected.displacement), rounding);
        EXPECT_NEAR(found.max_speed, static_cast<double>(expected.speed), rounding);
        double farthest = 0;  // of displacements as they are counted, whatever the particles' rest positions
        for (std::size_t i = 0; i < state.displacement.count(); ++i)
            farthest = std::max(farthest, length(state.displacement.at(i)));
        EXPECT_DOUBLE_EQ(found.farthest, farthest);
        if (run.model == "crystal") {
            EXPECT_LT(found.farthest, 0.2 * found.max_displacement)
                << "of particles around the origin, far from where they rest";
        }
        State<double> less = state;
        less.velocity.set(scene.reference.count / 2, {0, 0, 0});
        EXPECT_GT(length(in_pieces(scene, shape, less).angular_momentum - found.angular_momentum), rounding);
    }
}

TEST(Farthest, is_the_same_in_little_memory) {
    for (const RunDescription& run : {scene_with("chain", {{"n", 9001}}), scene_with("mesh"), scene_with("morse")}) {
        for (const Precision precision : precisions) {
            RunDescription here = run;
            here.precision = precision;
            Simulation simulation(here);
            simulation.advance(30);
            EXPECT_GT(simulation.farthest(), 0) << run.model;
            EXPECT_DOUBLE_EQ(simulation.farthest(), simulation.diagnostics().farthest) << run.model;
        }
    }
}

}  // namespace
}  // namespace steplab::test
