#include "core/sum.hpp"
#include "methods/engines/system.hpp"
#include "methods/gauss-16.hpp"
#include "methods/rk4.hpp"
#include "models/forces/layouts.hpp"
#include "support/all_at_once.hpp"
#include "support/circling_ball.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

ParameterValues with_tolerance(double tolerance) {
    ParameterValues values(Gauss16::info.parameters);
    values.set("tolerance", tolerance);
    return values;
}

/// A soft rope that falls from the level: everything moves, nothing is linear.
constexpr LineForces swinging_rope{
    .count = 5, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 0.5, .gravity = 9.81};

template <class T>
State<T> at_rest(std::size_t particles) {
    return {Field<T>(particles), Field<T>(particles)};
}

template <class T>
T apart(const State<T>& a, const State<T>& b) {
    T largest = 0;
    for (std::size_t k = 0; k < a.displacement.flat().size(); ++k)
        largest = std::max(largest, std::abs(a.displacement.flat()[k] - b.displacement.flat()[k]));
    return largest;
}

/// The state after so many steps of dt from `state`.
template <class Integrator, class T, class Forces>
State<T> after(const Forces& forces, State<T> state, T drag, T dt, std::size_t steps, const ParameterValues& values) {
    System system(force_for<Integrator>(engine<T>(forces)), drag, dt);
    Integrator integrator(values);
    integrator.start(system, state);
    for (std::size_t i = 0; i < steps; ++i) integrator.step(system);
    integrator.synchronised(system, state);
    return state;
}

/// The order that going from `steps` to `more` for 14 seconds of the circling ball shows.
template <class Integrator>
double order_of_angle(const CirclingBall& circle, std::size_t steps, std::size_t more, const ParameterValues& values) {
    const auto error = [&](std::size_t count) {
        const auto end = circle.after<Integrator>(count, Real(14) / static_cast<Real>(count), values);
        return circle.angle_error(end.displacement, 14);
    };
    return exponent(error(steps), error(more), static_cast<Real>(more) / static_cast<Real>(steps));
}

// Errors of 1e-12 to 1e-15; below 1e-17 is what rounding leaves of the weights. On the nonlinear circle the even order
// after the first counts a half where steps are so long that it stands above that.
TEST(Gauss16Order, is_16_with_and_without_drag) {
    const ParameterValues values = with_tolerance(0);
    EXPECT_NEAR(order_of_angle<Gauss<Real>>(damped_circle, 7, 9, values), 16, 0.1);
    EXPECT_NEAR(order_of_angle<Gauss<Real>>(free_circle, 10, 12, values), 16, 0.5);
    EXPECT_LT((order_of_angle<RungeKutta<Real, Rk4>>(damped_circle, 70, 90, ParameterValues())), 5);
}

// Dense output is a step, so of order 16: it differs from one step of dt by what the iteration leaves, a thousandth of
// the tolerance. The partner: a step that ends 1e-8 later.
TEST(Gauss16Order, inside_a_step_is_that_of_a_step) {
    constexpr double tolerance = 1e-6;
    const auto apart_from_step = [](Real seen, Real step) {
        return apart(free_circle.after<Gauss<Real>>(1, seen, with_tolerance(tolerance)),
                     free_circle.after<Gauss<Real>>(1, step, with_tolerance(0)));
    };
    for (const Real time : {0.5L, 1.0L, 1.5L}) {
        EXPECT_LT(apart_from_step(time, time), tolerance / 1000) << time;
        EXPECT_GT(apart_from_step(time, time + 1e-8L), tolerance / 1000) << time;
    }
}

// The reference by a method of another family: kahan-li-8 in long double would do; rk4 at 20000 steps is right to
// 1e-13.
TEST(Gauss16Order, converges_to_what_another_method_finds) {
    for (const Real drag : {0.0L, 0.3L, 5.0L}) {
        const auto mine =
            after<Gauss<Real>>(swinging_rope, at_rest<Real>(5), drag, Real(0.5) / 16, 16, with_tolerance(0));
        const auto other = after<RungeKutta<Real, Rk4>>(swinging_rope, at_rest<Real>(5), drag, Real(0.5) / 20000, 20000,
                                                        ParameterValues(Rk4::info.parameters));
        EXPECT_LT(apart(mine, other), 1e-12L) << static_cast<double>(drag);
    }
}

// Gauss is symmetric: what is left after 100 steps there and 100 back is the rounding of sums kept in two parts, a few
// ulp of displacements of 10. rk4 comes back to its own error.
TEST(Gauss16, returns_to_its_start) {
    const LineForces chain{.count = 10, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 2};
    const auto off = [&]<class Integrator>(const ParameterValues& values) {
        State<double> start = at_rest<double>(10);
        start.displacement.set(9, {1, 0, 0});  // along the chain: it does not magnify errors
        State<double> state = after<Integrator>(chain, start, 0.0, 0.5, 100, values);
        for (double& v : state.velocity.flat()) v = -v;
        return apart(after<Integrator>(chain, state, 0.0, 0.5, 100, values), start);
    };
    EXPECT_LT((off.operator()<Gauss<double>>(with_tolerance(0))), 2e-13);
    EXPECT_GT((off.operator()<RungeKutta<double, Rk4>>(ParameterValues(Rk4::info.parameters))), 1e-6);
}

/// Parts of a two-part state come in the order x, v, lost x, lost v.
template <class Integrator>
void grow_velocity(Integrator& integrator, double factor) {
    std::vector<Field<double>*> parts;
    Integrator::each_part(integrator, [&](Field<double>& part) { parts.push_back(&part); });
    parts[3]->flat()[1] += factor * parts[1]->flat()[1];
}

/// Trend of an oscillator's energy, 1/2 at the start.
struct Trend {
    double change = 0;           ///< of the energy, from start to end
    double standard_errors = 0;  ///< how many of them that is, if the changes of its pieces are random
};

/// From 50 pieces of a long run. After every step the velocity grows by `spoil` of itself, in its low part.
template <class Integrator>
Trend energy_trend(std::size_t periods, double dt, double spoil, const ParameterValues& values) {
    constexpr std::size_t pieces = 50;
    const LineForces forces{.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 0};
    System system(force_for<Integrator>(engine<double>(forces)), 0.0, dt);
    State<double> state = at_rest<double>(2);
    state.velocity.set(1, {1, 0, 0});
    Integrator integrator(values);
    integrator.start(system, state);
    const auto steps = static_cast<std::size_t>(static_cast<double>(periods) * 6.283185307179586 / dt) / pieces;
    double before = 0, change = 0, squares = 0;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        for (std::size_t i = 0; i < steps; ++i) {
            integrator.step(system);
            if (spoil != 0) grow_velocity(integrator, spoil);
        }
        integrator.synchronised(system, state);
        const double x = state.displacement.x()[1], v = state.velocity.x()[1], error = (x * x + v * v) / 2 - 0.5;
        squares += (error - before) * (error - before);
        before = change = error;
    }
    const double mean = change / pieces, variance = (squares / pieces - mean * mean) / (pieces - 1);
    return {change, mean / std::sqrt(variance)};
}

// 10^5 periods of the oscillator in 2 10^6 to 0.3 10^6 steps. What rounding does to the energy is a random walk: its
// mean is zero within the standard error that its pieces show (4 of them: once in some thousand such runs), and its end
// is some 1e-13 away (sqrt(steps) ulps are 3e-13). The partners: 1e-18 of the velocity a step, a hundredth of an ulp,
// is a trend, and rk4 at a hundredth of the time loses all. So do products with dt (dt = 0.3, 1.7), low parts swallowed
// by rounding (dt = 1) and an iteration that ends too early (dt = 1.7), whose trends were 1e-19 to 3e-18 a step.
TEST(Gauss16, energy_has_no_trend_over_100000_periods) {
    for (const double dt : {0.3, 0.7, 1.0, 1.7, 2.0}) {
        const Trend trend = energy_trend<Gauss<double>>(100000, dt, 0, with_tolerance(0));
        EXPECT_LT(std::abs(trend.standard_errors), 4) << dt << ' ' << trend.change;
        EXPECT_LT(std::abs(trend.change), 3e-13) << dt;
    }
    EXPECT_GT(energy_trend<Gauss<double>>(100000, 1.0, 1e-18, with_tolerance(0)).standard_errors, 8);
    const ParameterValues none(Rk4::info.parameters);
    EXPECT_LT((energy_trend<RungeKutta<double, Rk4>>(1000, 0.1, 0, none).change), -1e-5);
}

/// Error at t = 68.1 of the chain of 10, which the catalogue knows exactly.
double chain_error(std::uint64_t steps, double tolerance, Precision precision = Precision::double_) {
    RunDescription description = run_of("chain", "gauss-16", precision, 68.1 / static_cast<double>(steps));
    description.method_parameters.set("tolerance", tolerance);
    Simulation simulation(description);
    simulation.advance(steps);
    return simulation.diagnostics().error.value();
}

// The frame's positions stand near 38, where an ulp is 7e-15: the diagnostics' error contains half of that.
TEST(Gauss16, chain_is_right_to_the_last_digits) {
    EXPECT_LT(chain_error(100, 0), 1e-14);
    EXPECT_GT(chain_error(40, 0), 1e-12);
}

TEST(Gauss16, float_is_right_to_its_digits) {
    EXPECT_LT(chain_error(100, 0, Precision::float_), 1e-5);  // half an ulp of 38 is 2e-6
    EXPECT_LT(chain_error(681, 1e-5, Precision::float_), 2e-5);
}

// In proportion within a factor 30 of the middle of what is seen, and never above the tolerance. 1 frame and 681.
TEST(Gauss16, error_follows_the_tolerance) {
    for (double tolerance = 1e-3; tolerance > 0.9e-12; tolerance /= 10) {
        for (const std::uint64_t frames : {1u, 681u}) {
            const double error = chain_error(frames, tolerance);
            EXPECT_LT(error, tolerance) << tolerance;
            EXPECT_GT(error, tolerance / 900) << tolerance;
        }
    }
    EXPECT_GT(chain_error(1, 1e-3), 1e3 * chain_error(1, 1e-8));  // a step that no tolerance changes would not
}

TEST(Gauss16, dense_frames_cost_nothing_and_looking_changes_nothing) {
    const auto run = [](std::uint64_t frames, bool look) {
        RunDescription description =
            run_of("chain", "gauss-16", Precision::double_, 64.0 / static_cast<double>(frames));
        description.method_parameters.set("tolerance", 1e-9);
        Simulation simulation(description);
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
    EXPECT_LT(run(65536, false).second, evaluations * 11 / 10);  // other first steps, at most
}

/// All fields of an integrator's internal state.
template <class Integrator>
std::vector<Field<double>> parts(Integrator& integrator) {
    std::vector<Field<double>> all;
    Integrator::each_part(integrator, [&](const Field<double>& part) { all.push_back(part); });
    return all;
}

// What is saved alone decides how a run goes on: another integrator takes it over and makes the same bits.
TEST(Gauss16, saved_state_goes_on_with_the_same_bits) {
    for (const double tolerance : {0.0, 1e-8}) {
        System system(engine<double>(swinging_rope), 0.3, 0.07), other(engine<double>(swinging_rope), 0.3, 0.07);
        Gauss<double> first(with_tolerance(tolerance)), second(with_tolerance(tolerance));
        first.start(system, at_rest<double>(5));
        for (int i = 0; i < 20; ++i) first.step(system);
        State<double> elsewhere = at_rest<double>(5);
        elsewhere.velocity.set(2, {1, 1, 1});
        second.start(other, elsewhere);
        for (int i = 0; i < 3; ++i) second.step(other);
        const auto all = parts(first);
        auto saved = all.begin();
        Gauss<double>::each_part(second, [&](Field<double>& part) { part = *saved++; });
        second.progress(first.progress());
        for (int i = 0; i < 20; ++i) {
            first.step(system);
            second.step(other);
        }
        State<double> a, b;
        first.synchronised(system, a);
        second.synchronised(other, b);
        EXPECT_EQ(apart(a, b), 0) << tolerance;
    }
}

// omega dt = 40 and 400: the iteration does not converge, pieces of the step do. Nothing is silently wrong.
TEST(Gauss16, steps_too_long_for_the_iteration_are_taken_in_pieces) {
    for (const double dt : {40.0, 400.0}) {
        Simulation simulation(run_of("oscillator", "gauss-16", Precision::double_, dt));
        simulation.advance(10);
        EXPECT_LT(simulation.diagnostics().error.value(), 1e-2) << dt;  // pieces of omega h = 6 over 4000
        EXPECT_FALSE(simulation.divergence());
    }
}

// Butcher's simplifying assumptions B(16), C(8) and the condition of symplecticity, to rounding of long double.
TEST(GaussTable, holds_its_order_conditions) {
    const GaussTable& t = gauss_table;
    const auto power = [](long double x, std::size_t k) {
        long double p = 1;
        while (k-- > 0) p *= x;
        return p;
    };
    for (std::size_t k = 0; k < 16; ++k) {
        long double sum = 0;
        for (std::size_t j = 0; j < stage_count; ++j) sum += t.b[j] * power(t.c[j], k);
        EXPECT_NEAR(static_cast<double>(sum * static_cast<long double>(k + 1) - 1), 0, 1e-17) << k;
    }
    for (std::size_t i = 0; i < stage_count; ++i) {
        for (std::size_t j = 0; j < stage_count; ++j) {
            const long double defect = t.b[i] * t.a[i][j] + t.b[j] * t.a[j][i] - t.b[i] * t.b[j];
            EXPECT_NEAR(static_cast<double>(defect), 0, 1e-18);
        }
        for (std::size_t k = 0; k < 8; ++k) {
            long double sum = 0;
            for (std::size_t j = 0; j < stage_count; ++j) sum += t.a[i][j] * power(t.c[j], k);
            const auto degree = static_cast<long double>(k + 1);
            EXPECT_NEAR(static_cast<double>(sum - power(t.c[i], k + 1) / degree), 0, 1e-17);
        }
    }
    long double seventeenth = 0;  // B(17) must fail: 16 is the highest order of 8 stages
    for (std::size_t j = 0; j < stage_count; ++j) seventeenth += t.b[j] * power(t.c[j], 16);
    EXPECT_GT(std::abs(static_cast<double>(seventeenth * 17 - 1)), 1e-10);
}

// Where drag has brought a rope to rest, accelerations are rounding alone, which must not shorten the steps: a hundred
// seconds cost no more than its stiffest motion asks for, in float too, whose rounding is above this tolerance.
TEST(Gauss16, rests_at_no_cost) {
    for (const Precision precision : precisions) {
        RunDescription description = run_of("rope", "gauss-16", precision, 1, {{"c", 3}});
        description.method_parameters.set("tolerance", 1e-9);
        Simulation simulation(description);
        simulation.advance(100);
        EXPECT_NEAR(simulation.frame().positions[9].y, -6.70725, precision == Precision::float_ ? 1e-3 : 1e-6);
        EXPECT_LT(simulation.evaluations(), 400000u) << id(precision);
    }
}

}  // namespace
}  // namespace steplab::test
