#include "methods/dop853.hpp"
#include "methods/dopri5.hpp"
#include "methods/engines/system.hpp"
#include "methods/rkn-12-10.hpp"
#include "models/forces/line.hpp"
#include "support/circling_ball.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace steplab::test {
namespace {

using Number = Real;

/// A soft chain of 5 with its first particle held that falls from the level: nonlinear, everything moves.
template <class T>
System<T, Line<T>> falling_chain(T drag, T dt) {
    return {Line<T>({.count = 5, .first_fixed = true, .mass = 1, .k = 20, .rest_length = 1, .gravity = 10}), drag, dt};
}

struct WrongDopri5 : Dopri5 {
    static constexpr auto table = [] {
        auto wrong = Dopri5::table;
        wrong.a[5][2] += 1e-3L;
        return wrong;
    }();
};

/// Displacements after one second in steps of fixed length.
template <class Rule>
Field<Number> fixed_steps(int steps, Number drag) {
    auto system = falling_chain<Number>(drag, 1);
    Rule rule(5);
    Moment<Number> from(5), next(5);
    accelerate(system, next.x, next.v, next.a);
    for (int i = 0; i < steps; ++i) {
        std::swap(from, next);
        rule.attempt(system, from, Number(1) / steps, next, Number(1));
        rule.finish(system, Number(1) / steps, next);
    }
    return next.x;
}

Number difference(const Field<Number>& a, const Field<Number>& b) {
    Number worst = 0;
    for (std::size_t k = 0; k < a.flat().size(); ++k) worst = std::max(worst, std::abs(a.flat()[k] - b.flat()[k]));
    return worst;
}

const Field<Number>& right_end(Number drag) {
    static const Field<Number> without = fixed_steps<EmbeddedNystrom<Number, Rkn1210>>(400, 0);
    static const Field<Number> with = fixed_steps<EmbeddedRungeKutta<Number, Dop853>>(4000, 0.3L);
    return drag == 0 ? without : with;
}

template <class Rule>
double slope(int steps, Number drag) {
    const Field<Number>& right = right_end(drag);
    return static_cast<double>(std::log2(difference(fixed_steps<Rule>(steps, drag), right) /
                                         difference(fixed_steps<Rule>(2 * steps, drag), right)));
}

// Steps fine enough for the leading term, coarse enough to stand above the rounding of long double, 1e-18.
TEST(EmbeddedOrder, is_the_declared_one_on_both_sides) {
    for (const Number drag : {0.0L, 0.3L}) {
        EXPECT_NEAR((slope<EmbeddedRungeKutta<Number, Dopri5>>(128, drag)), 5, 0.1) << drag;
        EXPECT_NEAR((slope<EmbeddedRungeKutta<Number, Dop853>>(48, drag)), 8, 0.2) << drag;
    }
}

/// By how much the angle of the circling ball is wrong after 14 seconds in steps of fixed length.
template <class Rule>
Number angle_error(const CirclingBall& circle, int steps) {
    auto system = circle.system(1);
    const State<Number> start = circle.start();
    Rule rule(2);
    Moment<Number> from(2), next(2);
    next.x = start.displacement;
    next.v = start.velocity;
    accelerate(system, next.x, next.v, next.a);
    for (int i = 0; i < steps; ++i) {
        std::swap(from, next);
        rule.attempt(system, from, Number(14) / steps, next, Number(1));
        rule.finish(system, Number(14) / steps, next);
    }
    return circle.angle_error(next.x, 14);
}

template <class Rule>
double order_of_angle(const CirclingBall& circle, int steps, int more) {
    return exponent(angle_error<Rule>(circle, steps), angle_error<Rule>(circle, more), Number(more) / steps);
}

/// The method whose error the steps are judged by.
struct Rkn1210Embedded : Rkn1210 {
    static constexpr auto table = [] {
        auto lower = Rkn1210::table;
        lower.b = lower.embedded;
        lower.b_slope = lower.embedded_slope;
        return lower;
    }();
};
struct WrongRkn1210 : Rkn1210 {
    static constexpr auto table = [] {
        auto wrong = Rkn1210::table;
        wrong.a[14][6] += 1e-8L;
        return wrong;
    }();
};

// Errors of 1e-12 to 1e-16: below 1e-17 is what long double leaves of the tables, with coefficients up to 48. The even
// order after the first moves the order by a twentieth to a tenth; with drag, that of rkn-12-10 by a sixth.
TEST(EmbeddedOrder, of_dop853_and_rkn_12_10_is_8_and_12_and_10) {
    using Eight = EmbeddedRungeKutta<Number, Dop853>;
    using Twelve = EmbeddedNystrom<Number, Rkn1210>;
    using Ten = EmbeddedNystrom<Number, Rkn1210Embedded>;
    for (const CirclingBall& circle : {free_circle, damped_circle})
        EXPECT_NEAR(order_of_angle<Eight>(circle, 60, 120), 8, 0.1) << circle.drag;
    EXPECT_NEAR(order_of_angle<Twelve>(free_circle, 14, 20), 12, 0.1);
    EXPECT_NEAR(order_of_angle<Twelve>(damped_circle, 22, 28), 12, 0.2);
    EXPECT_NEAR(order_of_angle<Ten>(free_circle, 48, 64), 10, 0.1);
    EXPECT_NEAR(order_of_angle<Ten>(damped_circle, 40, 52), 10, 0.1);
    EXPECT_LT((order_of_angle<EmbeddedNystrom<Number, WrongRkn1210>>(free_circle, 14, 20)), 3);  // the partner
}

// The substitution that takes drag out of a nonlinear force: what another family finds, to the errors of both, 1e-17.
TEST(EmbeddedOrder, of_rkn_12_10_leads_to_what_dop853_finds_with_drag) {
    const auto end = [](Number drag) { return fixed_steps<EmbeddedNystrom<Number, Rkn1210>>(100, drag); };
    EXPECT_LT(difference(end(0.3L), right_end(0.3L)), 1e-15L);
    EXPECT_GT(difference(end(0.3L + 1e-9L), right_end(0.3L)), 1e-12L);  // the partner
}

TEST(EmbeddedOrder, of_a_wrong_table_is_lower) {
    EXPECT_LT((slope<EmbeddedRungeKutta<Number, WrongDopri5>>(128, 0)), 3);
}

/// Largest error that dense output shows inside the circling ball's first step, of length h.
template <class Rule>
Number error_inside(const CirclingBall& circle, Number h) {
    auto system = circle.system(1);
    State<Number> seen = circle.start();
    Rule rule(2);
    Moment<Number> from(2), next(2);
    from.x = seen.displacement;
    from.v = seen.velocity;
    accelerate(system, from.x, from.v, from.a);
    rule.attempt(system, from, h, next, 1);
    rule.finish(system, h, next);
    Uncounted looking(system);
    Number worst = 0;
    for (const Number part : {0.2L, 0.5L, 0.7L}) {
        rule.between(looking, from, next, h, part, seen);
        worst = std::max(worst, circle.error(seen, part * h));
    }
    return worst;
}

/// One step of dense output of order p errs by h^(p+1).
template <class Rule>
double dense_order(const CirclingBall& circle, Number coarse, Number fine) {
    return exponent(error_inside<Rule>(circle, coarse), error_inside<Rule>(circle, fine), coarse / fine) - 1;
}

struct WronglySeenDop853 : Dop853 {
    static constexpr auto table = [] {
        auto wrong = Dop853::table;
        wrong.dense[1][8] += 1e-3L;
        return wrong;
    }();
};

// Of rkn-12-10 it is a step, whose next order counts more, and adds a quarter; below it is what is left of the table.
TEST(DenseOutput, has_its_own_order) {
    for (const CirclingBall& circle : {free_circle, damped_circle}) {
        EXPECT_NEAR((dense_order<EmbeddedRungeKutta<Number, Dopri5>>(circle, 0.02L, 0.01L)), 4, 0.1) << circle.drag;
        EXPECT_NEAR((dense_order<EmbeddedRungeKutta<Number, Dop853>>(circle, 0.1L, 0.05L)), 7, 0.1) << circle.drag;
        EXPECT_NEAR((dense_order<EmbeddedNystrom<Number, Rkn1210>>(circle, 1.0L, 0.75L)), 12, 0.3) << circle.drag;
    }
    EXPECT_LT((dense_order<EmbeddedRungeKutta<Number, WronglySeenDop853>>(free_circle, 0.1L, 0.05L)), 5);
    EXPECT_LT((dense_order<EmbeddedNystrom<Number, WrongRkn1210>>(free_circle, 1.0L, 0.75L)), 3);
}

constexpr std::string_view embedded_ids[] = {"dopri5", "dop853", "rkn-12-10"};

double chain_error(std::string_view id, double tolerance) {
    Simulation simulation(run_to_tolerance("chain", id, 0.1, tolerance));
    simulation.advance(681);
    return simulation.diagnostics().error.value();
}

/// Errors over tolerances 1e-3 ... 1e-12 as multiples of the tolerance: the largest over the smallest. `given` is what
/// the method gets for a tolerance.
template <class Given>
double spread(std::string_view id, Given given) {
    double least = infinity, most = 0;
    for (int k = 3; k <= 12; ++k) {
        const double tolerance = std::pow(10, -k), ratio = chain_error(id, given(tolerance)) / tolerance;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    return most / least;
}

TEST(Tolerance, is_what_the_end_error_is_proportional_to) {
    for (const std::string_view id : {"dopri5", "dop853", "rkn-12-10", "taylor", "gauss-16", "ias15"})
        EXPECT_LT(spread(id, [](double tolerance) { return tolerance; }), 30) << id;
    // the partner: Rein and Spiegel's epsilon in its place, 265 times the tolerance to the power of 7/15
    EXPECT_GT(spread("ias15", [](double epsilon) { return std::pow(epsilon / 265, 15.0 / 7); }), 30);
}

// Displacements of some 2, whose ulp is 4e-16; 200 compensated steps.
TEST(Rkn1210, comes_within_1e_14_of_the_chain) {
    EXPECT_LT(chain_error("rkn-12-10", 1e-14), 1e-14);
    EXPECT_GT(chain_error("rkn-12-10", 1e-11), 1e-14);  // the tolerance decides
}

TEST(Frames, however_dense_cost_no_evaluations) {
    for (const std::string_view id : embedded_ids) {
        Simulation coarse(run_to_tolerance("chain", id, 8, 1e-8)), fine(run_to_tolerance("chain", id, 1.0 / 128, 1e-8));
        coarse.advance(1);
        fine.advance(1024);
        EXPECT_EQ(coarse.evaluations(), fine.evaluations()) << id;
        EXPECT_EQ(distance(coarse.frame(), fine.frame()), 0) << id;
        EXPECT_GT(coarse.evaluations(), 0u);
    }
}

// Uncounted reads the run's steps and leaves them alone; what dense output makes is there again after coming back.
TEST(Frames, looked_at_or_restored_give_the_same_bits) {
    for (const Precision precision : precisions) {
        for (const std::string_view id : embedded_ids) {
            const auto run = run_to_tolerance("rope", id, 0.07, 1e-5, {}, precision);
            Simulation quiet(run), watched(run);
            quiet.advance(30);
            for (int i = 0; i < 30; ++i) watched.advance(1);
            EXPECT_EQ(quiet.hash(), watched.hash()) << id;
            const auto saved = watched.save();
            const std::string then = watched.hash();
            watched.advance(20);
            quiet.advance(20);
            EXPECT_EQ(quiet.hash(), watched.hash()) << id;
            watched.restore(saved);
            EXPECT_EQ(watched.hash(), then) << id;
            watched.advance(20);
            EXPECT_EQ(quiet.hash(), watched.hash()) << id;
            EXPECT_EQ(quiet.evaluations(), watched.evaluations()) << id;
        }
    }
}

// The damped oscillator, whose exact solution is known; errors at most 100 tolerances as on the chain.
TEST(Drag, keeps_the_accuracy) {
    for (const std::string_view id : embedded_ids) {
        for (const double c : {0.5, 4.0, 40.0}) {
            Simulation simulation(run_to_tolerance("oscillator", id, 0.5, 1e-10, {{"c", c}}));
            simulation.advance(20);
            EXPECT_LT(simulation.diagnostics().error.value(), 1e-8) << id << " " << c;
        }
    }
}

// Float: within 200 ulp of its displacements of 2, 2e-7 each.
TEST(Float, follows_the_chain) {
    for (const std::string_view id : embedded_ids) {
        Simulation simulation(run_to_tolerance("chain", id, 0.1, 1e-6, {}, Precision::float_));
        simulation.advance(200);
        EXPECT_LT(simulation.diagnostics().error.value(), 2e-4) << id;
    }
}

}  // namespace
}  // namespace steplab::test
