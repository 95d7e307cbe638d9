#include "methods/ias15.hpp"

#include "methods/engines/system.hpp"
#include "methods/gauss-16.hpp"
#include "models/forces/layouts.hpp"
#include "support/circling_ball.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

Simulation chain(double tolerance, std::uint64_t frames, double duration = 68.1,
                 Precision precision = Precision::double_) {
    RunDescription description = run_of("chain", "ias15", precision, duration / static_cast<double>(frames));
    description.method_parameters.set("tolerance", tolerance);
    return Simulation(description);
}

double chain_error(double tolerance, std::uint64_t frames, Precision precision = Precision::double_) {
    Simulation simulation = chain(tolerance, frames, 68.1, precision);
    simulation.advance(frames);
    return simulation.diagnostics().error.value();
}

// Some 130 steps of two passes over seven nodes. Three passes, which a first guess of nothing takes, are 3500.
TEST(Ias15, its_first_guess_saves_a_pass) {
    Simulation simulation = chain(1e-9, 1);
    simulation.advance(1);
    EXPECT_LT(simulation.evaluations(), 2500u);
}

// Half an ulp of the frame's positions near 38 is 4e-15.
TEST(Ias15, chain_is_right_to_the_last_digits) {
    EXPECT_LT(chain_error(1e-14, 1), 1e-14);
    EXPECT_GT(chain_error(1e-10, 1), 1e-13);
}

TEST(Ias15, float_is_right_to_its_digits) {
    // half an ulp of 38 is 2e-6, the smallest tolerance kept 8e-6
    EXPECT_LT(chain_error(1e-6, 681, Precision::float_), 2e-5);
}

TEST(Ias15, dense_frames_cost_nothing_and_looking_changes_nothing) {
    const auto run = [](std::uint64_t frames, bool look) {
        Simulation simulation = chain(1e-9, frames, 64);
        for (std::uint64_t i = 0; i < frames; ++i) {
            simulation.advance(1);
            if (look) (void)simulation.frame();
        }
        return std::pair(simulation.frame(), simulation.evaluations());
    };
    const auto [plain, evaluations] = run(512, false);
    const auto [seen, evaluations_seen] = run(512, true);
    EXPECT_EQ(distance(plain, seen), 0);
    EXPECT_EQ(evaluations, evaluations_seen);
    EXPECT_LT(run(65536, false).second, evaluations * 11 / 10);
}

// Between the ends of its steps too: the polynomial of a step itself would be off by 1e-8 there.
TEST(Ias15, frames_inside_a_step_are_right) {
    Simulation simulation = chain(1e-9, 6810);
    double worst = 0;
    for (int i = 0; i < 681; ++i) {
        simulation.advance(1);
        worst = std::max(worst, simulation.diagnostics().error.value());
    }
    EXPECT_LT(worst, 1e-9);
}

/// With an iteration that leaves nothing to be seen.
struct FullyIterated : RadauControl {
    static constexpr double iteration_share = 1e-9;
};
/// Without one: the first pass over the nodes counts.
struct HardlyIterated : RadauControl {
    static constexpr double iteration_share = 1e9;
};

/// How the error falls inside the circling ball's first step, 1.97 long, between two times in it.
template <class Control>
double order_inside(Real late, Real early) {
    ParameterValues values(Ias15::info.parameters);
    values.set("tolerance", 1e-4);
    const auto error = [&](Real time) {
        return free_circle.error(free_circle.after<GaussRadau<Real, Control>>(1, time, values), time);
    };
    return exponent(error(late), error(early), late / early) - 1;
}

// A frame inside a step is a step of the method's own order: errors of 2e-15 and 1e-16 fall with the 16th power of its
// length.
TEST(Ias15Order, is_15_also_inside_a_step) {
    EXPECT_NEAR(order_inside<FullyIterated>(1.125L, 0.9375L), 15, 0.1);
    EXPECT_LT(order_inside<HardlyIterated>(1.125L, 0.9375L), 13);
}

constexpr LineForces hanging_rope{
    .count = 5, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 0.5, .gravity = 9.81};

template <class Integrator, class T>
State<T> rope_after(T duration, std::size_t frames, T drag, double tolerance, const ParameterValues& defaults) {
    ParameterValues values = defaults;
    values.set("tolerance", tolerance);
    System system(engine<T>(hanging_rope), drag, duration / static_cast<T>(frames));
    Integrator integrator(values);
    integrator.start(system, {Field<T>(5), Field<T>(5)});
    for (std::size_t i = 0; i < frames; ++i) integrator.step(system);
    State<T> state;
    integrator.synchronised(system, state);
    return state;
}

double apart(const State<double>& a, const State<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.displacement.flat().size(); ++k)
        largest = std::max(largest, std::abs(a.displacement.flat()[k] - b.displacement.flat()[k]));
    return largest;
}

// Drag inside the polynomial: compared with gauss-16, which eliminates it. A wrong drag is seen at once.
TEST(Ias15, drag_and_gravity_agree_with_gauss) {
    const ParameterValues mine(Ias15::info.parameters), gauss(Gauss16::info.parameters);
    for (const double drag : {0.0, 0.3, 5.0}) {
        const auto right = rope_after<Gauss<double>>(2.0, 64, drag, 0, gauss);
        EXPECT_LT(apart(rope_after<GaussRadau<double>>(2.0, 7, drag, 1e-12, mine), right), 1e-11) << drag;
        EXPECT_GT(apart(rope_after<GaussRadau<double>>(2.0, 7, drag + 1e-6, 1e-12, mine), right), 1e-9) << drag;
    }
}

TEST(Ias15, saved_state_goes_on_with_the_same_bits) {
    const ParameterValues values(Ias15::info.parameters);
    System system(engine<double>(hanging_rope), 0.3, 0.07), other(engine<double>(hanging_rope), 0.3, 0.07);
    GaussRadau<double> first(values), second(values);
    first.start(system, {Field<double>(5), Field<double>(5)});
    for (int i = 0; i < 20; ++i) first.step(system);
    State<double> elsewhere{Field<double>(5), Field<double>(5)};
    elsewhere.velocity.set(2, {1, 1, 1});
    second.start(other, elsewhere);
    for (int i = 0; i < 3; ++i) second.step(other);
    std::vector<Field<double>> all;
    GaussRadau<double>::each_part(first, [&](const Field<double>& part) { all.push_back(part); });
    auto saved = all.begin();
    GaussRadau<double>::each_part(second, [&](Field<double>& part) { part = *saved++; });
    second.progress(first.progress());
    for (int i = 0; i < 20; ++i) {
        first.step(system);
        second.step(other);
    }
    State<double> a, b;
    first.synchronised(system, a);
    second.synchronised(other, b);
    EXPECT_EQ(apart(a, b), 0);
}

// Two particles of a spring at one place have no force between them, a moment later all of it: steps are short there,
// whose error, some ten tolerances, an accepted long step would exceed a hundred thousand times.
TEST(Ias15, begins_at_coincident_particles_with_a_short_step) {
    System<double, Line<double>> system(
        engine<double>(LineForces{.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 1}), 0, 0.5);
    State<double> state{Field<double>(2), Field<double>(2)};
    state.displacement.x()[1] = -1;
    state.velocity.x()[1] = 0.5;
    GaussRadau<double> integrator{ParameterValues(Ias15::info.parameters)};
    integrator.start(system, state);
    integrator.step(system);
    integrator.synchronised(system, state);
    EXPECT_NEAR(state.displacement.x()[1], 0.5 * std::sin(0.5) - std::cos(0.5), 1e-8);
}

// The quadrature behind the form: integrals of the interpolating polynomials are exact up to s^14 (Radau, 8 nodes), and
// s^15 is not.
TEST(RadauTable, is_the_rule_of_order_15) {
    const auto integral_of_power = [](std::size_t power) {
        std::array<long double, Radau::terms> g{}, values{};
        for (std::size_t n = 0; n < Radau::terms; ++n) {
            values[n] = 1;
            for (std::size_t k = 0; k < power; ++k) values[n] *= Radau::nodes[n];
            long double newest = values[n] / Radau::nodes[n];
            for (std::size_t i = 0; i < n; ++i) newest = (newest - g[i]) / (Radau::nodes[n] - Radau::nodes[i]);
            g[n] = newest;
        }
        long double sum = 0;
        for (std::size_t k = 0; k < Radau::terms; ++k) {
            for (std::size_t j = 0; j <= k; ++j)
                sum += g[k] * Radau::from_newton[k][j] / static_cast<long double>(j + 2);
        }
        return static_cast<double>(sum * static_cast<long double>(power + 1));
    };
    for (std::size_t power = 1; power <= 14; ++power) EXPECT_NEAR(integral_of_power(power), 1, 1e-15) << power;
    EXPECT_GT(std::abs(integral_of_power(15) - 1), 1e-9);
}

// A polynomial told from s = 1: the shifted coefficients give its value at 1 + s.
TEST(RadauTable, shifts_polynomials) {
    const std::array<double, Radau::terms> b{1, -2, 3, 0.5, -0.25, 2, 1};
    const auto value = [](const std::array<double, Radau::terms>& terms, double s) {
        double sum = 0, power = 1;
        for (const double term : terms) sum += term * (power *= s);
        return sum;
    };
    std::array<double, Radau::terms> shifted{};
    for (std::size_t j = 0; j < Radau::terms; ++j) {
        for (std::size_t k = j; k < Radau::terms; ++k) shifted[j] += static_cast<double>(Radau::shift[j][k]) * b[k];
    }
    EXPECT_NEAR(value(shifted, 0.3), value(b, 1.3) - value(b, 1), 1e-13);
}

// Where drag has brought a rope to rest, accelerations are rounding alone, which must not shorten the steps, in float
// too, whose rounding is above this tolerance: a hundred seconds take 0.40 10^6 evaluations there (0.21 10^6 in
// double), most of them for its drag; where rounding counts as acceleration, more than a hundred times as many.
TEST(Ias15, rests_at_no_cost) {
    for (const Precision precision : precisions) {
        RunDescription description = run_of("rope", "ias15", precision, 1, {{"c", 3}});
        description.method_parameters.set("tolerance", 1e-9);
        Simulation simulation(description);
        simulation.advance(100);
        EXPECT_NEAR(simulation.frame().positions[9].y, -6.70725, precision == Precision::float_ ? 1e-3 : 1e-6);
        EXPECT_LT(simulation.evaluations(), 500000u) << id(precision);
    }
}

}  // namespace
}  // namespace steplab::test
