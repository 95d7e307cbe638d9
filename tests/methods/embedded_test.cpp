#include "core/flush_subnormals.hpp"
#include "methods/dop853.hpp"
#include "methods/dopri5.hpp"
#include "methods/rkn-12-10.hpp"
#include "methods/system.hpp"
#include "models/line.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

using Number = long double;

// What the tables print: more digits than long double has; the sums over 16 coefficients of size 100 round at 1e-17.
constexpr Number digits = 1e-14L;

template <class Row>
Number moment(const Row& weights, const Row& c, int power) {
    Number sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * (power == 0 ? 1 : std::pow(c[i], power));
    return sum;
}

/// Largest violation of the quadrature conditions of order p and of the row conditions of a Nystrom table.
template <std::size_t Stages>
Number violation(const NystromTable<Stages>& table) {
    Number worst = 0;
    const auto hold = [&](Number left, Number right) { worst = std::max(worst, std::abs(left - right)); };
    for (int k = 0; k < 12; ++k) {
        const Number n = k + 1;
        if (k < 11) hold(moment(table.b, table.c, k), 1 / (n * (n + 1)));
        hold(moment(table.b_slope, table.c, k), 1 / n);
        if (k < 9) hold(moment(table.embedded, table.c, k), 1 / (n * (n + 1)));
        if (k < 10) hold(moment(table.embedded_slope, table.c, k), 1 / n);
    }
    for (std::size_t i = 0; i < Stages; ++i) {
        hold(moment(table.a[i], table.c, 0), table.c[i] * table.c[i] / 2);
        hold(table.b[i], table.b_slope[i] * (1 - table.c[i]));
        // c^4 and below are integrated exactly in the stages that count; those before have less to do
        for (int k = 1; k <= 4 && i >= 7; ++k) {
            hold(moment(table.a[i], table.c, k), std::pow(table.c[i], k + 2) / static_cast<Number>((k + 1) * (k + 2)));
        }
        // sum_j b'_j a_ji = b'_i (1 - c_i)^2 / 2
        Number column = 0;
        for (std::size_t j = 0; j < Stages; ++j) column += table.b_slope[j] * table.a[j][i];
        hold(column, table.b_slope[i] * (1 - table.c[i]) * (1 - table.c[i]) / 2);
    }
    return worst;
}

TEST(Rkn1210Table, holds_its_order_conditions) { EXPECT_LT(violation(Rkn1210::table), digits); }

TEST(Rkn1210Table, with_a_wrong_digit_does_not) {
    auto wrong = Rkn1210::table;
    wrong.a[14][6] += 1e-12L;
    EXPECT_GT(violation(wrong), digits);
    wrong = Rkn1210::table;
    wrong.embedded[8] += 1e-12L;
    EXPECT_GT(violation(wrong), digits);
}

/// The same for a Runge-Kutta table: its last row and its error's rows, which must not see polynomials below the order
/// of the embedded method.
template <class Table>
Number violation(const Table& table, int order, std::vector<int> embedded) {
    typename Table::Row c{};
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = moment(table.a[i], c, 0);
    Number worst = 0;
    const auto hold = [&](Number left, Number right) { worst = std::max(worst, std::abs(left - right)); };
    for (int k = 0; k < order; ++k) hold(moment(table.a[Table::stages - 1], c, k), 1 / static_cast<Number>(k + 1));
    for (std::size_t e = 0; e < embedded.size(); ++e) {
        for (int k = 0; k < embedded[e]; ++k) hold(moment(table.error[e], c, k), 0);
    }
    // sum_i b_i a_ij = b_j (1 - c_j)
    const auto& b = table.a[Table::stages - 1];
    for (std::size_t j = 0; j < Table::stages; ++j) {
        Number sum = 0;
        for (std::size_t i = 0; i < Table::stages; ++i) sum += b[i] * table.a[i][j];
        hold(sum, b[j] * (1 - c[j]));
    }
    // second moments of the rows: sum_j a_ij c_j = c_i^2 / 2 but in the second, whose weight is zero
    for (std::size_t i = 2; i < Table::all; ++i) hold(moment(table.a[i], c, 1), c[i] * c[i] / 2);
    return worst;
}

TEST(EmbeddedTables, hold_their_order_conditions) {
    EXPECT_LT(violation(Dopri5::table, 5, {4}), digits);
    EXPECT_LT(violation(Dop853::table, 8, {5, 3}), digits);
}

TEST(EmbeddedTables, with_a_wrong_digit_do_not) {
    auto wrong = Dop853::table;
    wrong.a[15][8] += 1e-12L;
    EXPECT_GT(violation(wrong, 8, {5, 3}), digits);
    wrong = Dop853::table;
    wrong.error[0][7] += 1e-12L;
    EXPECT_GT(violation(wrong, 8, {5, 3}), digits);
    auto wrong_5 = Dopri5::table;
    wrong_5.error[0][3] += 1e-12L;
    EXPECT_GT(violation(wrong_5, 5, {4}), digits);
}

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

/// One second in steps of fixed length; the displacements at the end and the largest difference of dense output in the
/// middle of each step.
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

/// A ball on a spring swinging for six seconds; error in steps of fixed length.
template <class Table>
Number swing_error(int steps, Number drag) {
    System<Number, Line<Number>> system(
        Line<Number>({.count = 2, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 1}), drag, 1);
    const auto end = [&]<class T>(EmbeddedNystrom<Number, T> method, int count) {
        Moment<Number> from(2), next(2);
        next.v.y()[1] = 0.5L;
        accelerate(system, next.x, next.v, next.a);
        for (int i = 0; i < count; ++i) {
            std::swap(from, next);
            method.attempt(system, from, Number(6) / count, next, Number(1));
            method.finish(system, Number(6) / count, next);
        }
        return next.x;
    };
    return difference(end(EmbeddedNystrom<Number, Table>(2), steps), end(EmbeddedNystrom<Number, Rkn1210>(2), 200));
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

template <class Table>
double swing_slope(Number drag) {
    return static_cast<double>(std::log(swing_error<Table>(12, drag) / swing_error<Table>(20, drag)) /
                               std::log(20.0L / 12));
}

// The errors, 7e-16 and 1e-18, stand between the rounding of long double, 5e-20, and steps so long that the next
// orders' terms are larger: the method's own first term is made small. What is left of them moves the slope by 0.6; the
// order conditions above are exact.
TEST(EmbeddedOrder, of_rkn_12_10_is_12_and_10) {
    for (const Number drag : {0.0L, 0.3L}) {
        EXPECT_NEAR(swing_slope<Rkn1210>(drag), 12, 0.7) << drag;
        EXPECT_NEAR(swing_slope<Rkn1210Embedded>(drag), 10, 0.7) << drag;
    }
}

TEST(EmbeddedOrder, of_a_wrong_table_is_lower) {
    EXPECT_LT((slope<EmbeddedRungeKutta<Number, WrongDopri5>>(128, 0)), 3);
}

/// Largest error inside one step of length h from a moment in mid-fall.
template <class Rule>
Number error_between(Number h) {
    auto system = falling_chain<Number>(0, 1);
    Rule rule(5);
    EmbeddedNystrom<Number, Rkn1210> fine(5);
    Moment<Number> from(5), next(5), middle(5), there(5);
    accelerate(system, from.x, from.v, from.a);
    fine.attempt(system, from, 0.1L, middle, 1);
    fine.finish(system, 0.1L, middle);
    rule.attempt(system, middle, h, next, 1);
    rule.finish(system, h, next);
    Looking looking(system);
    State<Number> seen;
    Number worst = 0;
    for (const Number part : {0.2L, 0.5L, 0.7L}) {
        fine.attempt(system, middle, part * h, there, 1);
        rule.between(looking, middle, next, h, part, seen);
        worst = std::max({worst, difference(seen.displacement, there.x), difference(seen.velocity, there.v)});
    }
    return worst;
}

// One step of dense output of order p errs by h^(p+1).
TEST(DenseOutput, has_its_own_order) {
    const auto order = [](Number coarse, Number fine) { return static_cast<double>(std::log2(coarse / fine)) - 1; };
    using Five = EmbeddedRungeKutta<Number, Dopri5>;
    using Eight = EmbeddedRungeKutta<Number, Dop853>;
    EXPECT_NEAR(order(error_between<Five>(0.01L), error_between<Five>(0.005L)), 4, 0.2);
    EXPECT_NEAR(order(error_between<Eight>(0.04L), error_between<Eight>(0.02L)), 7, 0.3);
}

RunDescription adaptive_run(std::string_view model, std::string_view id, double dt, double tolerance,
                            Settings settings = {}, Precision precision = Precision::double_) {
    RunDescription description = run_of(model, id, precision, dt, settings);
    description.method_parameters.set("tolerance", tolerance);
    return description;
}

constexpr std::string_view ids[] = {"dopri5", "dop853", "rkn-12-10"};

double chain_error(std::string_view id, double tolerance) {
    Simulation simulation(adaptive_run("chain", id, 0.1, tolerance));
    simulation.advance(681);
    return simulation.diagnostics().error.value();
}

// The errors over tolerances 1e-3 ... 1e-12 are the same multiple of the tolerance within a factor 30 between largest
// and smallest.
TEST(Tolerance, is_what_the_end_error_is_proportional_to) {
    for (const std::string_view id : {"dopri5", "dop853", "rkn-12-10", "taylor", "gauss-16"}) {
        double least = infinity, most = 0;
        for (int k = 3; k <= 12; ++k) {
            const double tolerance = std::pow(10, -k), ratio = chain_error(id, tolerance) / tolerance;
            least = std::min(least, ratio);
            most = std::max(most, ratio);
        }
        EXPECT_LT(most / least, 30) << id;
    }
}

// Displacements of some 2, whose ulp is 4e-16; 200 compensated steps.
TEST(Rkn1210, comes_within_1e_14_of_the_chain) {
    EXPECT_LT(chain_error("rkn-12-10", 1e-14), 1e-14);
    EXPECT_GT(chain_error("rkn-12-10", 1e-11), 1e-14);  // the tolerance decides
}

TEST(Frames, however_dense_cost_no_evaluations) {
    for (const std::string_view id : ids) {
        Simulation coarse(adaptive_run("chain", id, 8, 1e-8)), fine(adaptive_run("chain", id, 1.0 / 128, 1e-8));
        coarse.advance(1);
        fine.advance(1024);
        EXPECT_EQ(coarse.evaluations(), fine.evaluations()) << id;
        EXPECT_EQ(distance(coarse.frame(), fine.frame()), 0) << id;
        EXPECT_GT(coarse.evaluations(), 0u);
    }
}

// Looking reads the run's steps and leaves them alone; what dense output makes is there again after coming back.
TEST(Frames, looked_at_or_restored_give_the_same_bits) {
    for (const Precision precision : precisions) {
        for (const std::string_view id : ids) {
            const auto run = adaptive_run("rope", id, 0.07, 1e-5, {}, precision);
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
    for (const std::string_view id : ids) {
        for (const double c : {0.5, 4.0, 40.0}) {
            Simulation simulation(adaptive_run("oscillator", id, 0.5, 1e-10, {{"c", c}}));
            simulation.advance(20);
            EXPECT_LT(simulation.diagnostics().error.value(), 1e-8) << id << " " << c;
        }
    }
}

// Float: within 200 ulp of its displacements of 2, 2e-7 each.
TEST(Float, follows_the_chain) {
    for (const std::string_view id : ids) {
        Simulation simulation(adaptive_run("chain", id, 0.1, 1e-6, {}, Precision::float_));
        simulation.advance(200);
        EXPECT_LT(simulation.diagnostics().error.value(), 2e-4) << id;
    }
}

}  // namespace
}  // namespace steplab::test
