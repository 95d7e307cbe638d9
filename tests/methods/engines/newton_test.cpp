#include "methods/engines/newton_matrix.hpp"
#include "methods/engines/system.hpp"
#include "methods/implicit-midpoint.hpp"
#include "methods/tr-bdf2.hpp"
#include "models/forces/layouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

/// A chain of blocks as both kinds of matrix, solved for the same right-hand side.
template <class Matrix>
Field<double> solution_of_a_chain(std::size_t n, double coupling, bool& solvable) {
    Matrix matrix(n);
    matrix.reset(2, {});
    Field<double> right(n), solution(n);
    Block<double> block = Block<double>::diagonal(coupling);
    block.at[0][1] = block.at[1][0] = 0.3 * coupling;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        matrix.add_diagonal(i, block);
        matrix.add_diagonal(i + 1, block);
        matrix.add_beside(i, i + 1, -1.0 * block);
    }
    for (std::size_t i = 0; i < n; ++i) right.set(i, {1.0 + static_cast<double>(i), -2, 0.5});
    solvable = matrix.factorise();
    if (solvable) matrix.solve(right, solution);
    return solution;
}

// Condition number below 10: the two eliminations agree to some roundings of solutions below 10.
TEST(NewtonMatrix, block_tridiagonal_and_sparse_agree) {
    bool first = false, second = false;
    const auto a = solution_of_a_chain<BlockTridiagonal<double>>(7, 1.5, first);
    const auto b = solution_of_a_chain<SparseSymmetric<double>>(7, 1.5, second);
    ASSERT_TRUE(first && second);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_LT(length(a.at(i) - b.at(i)), 1e-14);
}

/// The solution for blocks between these pairs of 4 particles.
Field<double> solution_for_pairs(SparseSymmetric<double>& matrix,
                                 const std::vector<std::array<std::size_t, 2>>& pairs) {
    Field<double> right(4), solution(4);
    for (std::size_t i = 0; i < 4; ++i) right.set(i, {1, -2, 0.5 * static_cast<double>(i)});
    matrix.reset(2, {});
    for (const auto& [i, j] : pairs) {
        matrix.add_diagonal(i, Block<double>::diagonal(1));
        matrix.add_diagonal(j, Block<double>::diagonal(1));
        matrix.add_beside(i, j, Block<double>::diagonal(-1));
    }
    EXPECT_TRUE(matrix.factorise());
    matrix.solve(right, solution);
    return solution;
}

// As many pairs each time, of which others are near each other: the same bits as from a matrix that knew no pairs
// before.
TEST(NewtonMatrix, follows_pairs_that_change) {
    SparseSymmetric<double> used(4), fresh(4);
    const Field<double> before = solution_for_pairs(used, {{0, 1}, {1, 2}});
    const Field<double> after = solution_for_pairs(used, {{0, 3}, {2, 3}});
    const Field<double> right = solution_for_pairs(fresh, {{0, 3}, {2, 3}});
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(length(after.at(i) - right.at(i)), 0);
    EXPECT_GT(length(after.at(3) - before.at(3)), 0.01);
}

// Without blocks beside it, the diagonal alone divides.
TEST(NewtonMatrix, has_the_masses_in_its_diagonal) {
    BlockTridiagonal<double> chain(2);
    SparseSymmetric<double> sparse(2);
    const auto quotient = [](auto& matrix) {
        matrix.reset(2, {1, 4});
        EXPECT_TRUE(matrix.factorise());
        Field<double> right(2), solution(2);
        for (std::size_t i = 0; i < 2; ++i) right.set(i, {8, 8, 8});
        matrix.solve(right, solution);
        return solution;
    };
    for (const Field<double>& solution : {quotient(chain), quotient(sparse)}) {
        EXPECT_EQ(solution.at(0), (Vec3{4, 4, 4}));
        EXPECT_EQ(solution.at(1), (Vec3{1, 1, 1}));
    }
}

TEST(NewtonMatrix, says_that_a_singular_one_is) {
    BlockTridiagonal<double> chain(1);
    chain.reset(0, {});
    EXPECT_FALSE(chain.factorise());
    SparseSymmetric<double> sparse(1);
    sparse.reset(0, {});
    EXPECT_FALSE(sparse.factorise());
}

/// A chain whose blocks are `Error` per cent off.
template <int Error>
struct MisjudgedLine : Line<double> {
    using Line<double>::Line;
    std::array<SpringFormula<double>, 1> formulas() const { return {{{{1, 0, 0}, 1, 1 + Error / 100.0}}}; }
};

/// Evaluations of 10 steps over 5 particles that swing across their line.
template <class Method, class Force>
std::uint64_t evaluations_of_ten_steps(double drag = 0) {
    System<double, Force> system(Force({.count = 5, .first_fixed = true, .mass = 1, .k = 1, .rest_length = 1}), drag,
                                 1);
    State<double> state{Field<double>(5), Field<double>(5)};
    state.velocity.y()[4] = 0.5;
    typename Method::template Integrator<double> integrator{ParameterValues(Method::parameters)};
    integrator.start(system, state);
    const std::uint64_t start = system.evaluations();
    for (int i = 0; i < 10; ++i) integrator.step(system);
    return system.evaluations() - start;
}

// Newton's method doubles its digits: from some 10 % to 16 digits in 5 or 6 evaluations a stage. With a Jacobian a
// fifth off each evaluation gains less than a digit.
TEST(Newton, converges_in_few_evaluations_with_the_exact_jacobian_alone) {
    EXPECT_LE((evaluations_of_ten_steps<ImplicitMidpoint, MisjudgedLine<0>>()), 60u);
    EXPECT_GE((evaluations_of_ten_steps<ImplicitMidpoint, MisjudgedLine<20>>()), 100u);
    EXPECT_LE((evaluations_of_ten_steps<TrBdf2, MisjudgedLine<0>>()), 110u);
    EXPECT_GE((evaluations_of_ten_steps<TrBdf2, MisjudgedLine<20>>()), 180u);
    EXPECT_LE((evaluations_of_ten_steps<ImplicitMidpoint, MisjudgedLine<0>>(3)), 60u);
    EXPECT_LE((evaluations_of_ten_steps<TrBdf2, MisjudgedLine<0>>(3)), 110u);
}

/// A stage of length tau for 5 particles in a line, of which the last one is kicked.
template <class Force>
struct StageOfLine {
    double tau;
    System<double, Force> system;
    Field<double> x{5}, v{5}, w{5};
    bool solved = false;

    StageOfLine(double k, const Vec3& velocity, double length)
        : tau(length),
          system(Force({.count = 5, .first_fixed = true, .mass = 1, .k = k, .rest_length = 1}), 0, length) {
        v.set(4, velocity);
        solved = ImplicitStage<double>(system.force().coupling()).solve(system, x, v, tau, w);
    }

    /// Largest component of tau a(x + tau (v + w)) - w.
    double residual() {
        Field<double> position(5), a(5);
        for (std::size_t k = 0; k < x.flat().size(); ++k)
            position.flat()[k] = x.flat()[k] + tau * (v.flat()[k] + w.flat()[k]);
        system.accelerations(position, a);
        double largest = 0;
        for (std::size_t k = 0; k < x.flat().size(); ++k)
            largest = std::max(largest, std::abs(tau * a.flat()[k] - w.flat()[k]));
        return largest;
    }
};

// Springs three times too stiff in the matrix: the residual falls by less than a half an iteration. It ends with a
// change of w below 4096 roundings of numbers up to 2.5, which the matrix magnifies up to five times: 1.2e-11.
TEST(Newton, ends_at_rounding_where_it_converges_slowly_too) {
    StageOfLine<MisjudgedLine<0>> exact(1, {1, 0.5, 0}, 0.6);
    StageOfLine<MisjudgedLine<200>> slow(1, {1, 0.5, 0}, 0.6);
    ASSERT_TRUE(exact.solved && slow.solved);
    EXPECT_LT(exact.residual(), 1e-15);
    EXPECT_LT(slow.residual(), 1.2e-11);
    EXPECT_GT(slow.system.evaluations(), 5 * exact.system.evaluations());
}

// Springs that a stage stretches to many times their length turn while they pull: on the way to the solution the
// residual grows. Steps halved until it falls take 46 evaluations. The residual's numbers are some 10^4.
TEST(Newton, takes_full_steps_for_springs_far_stretched) {
    StageOfLine<Line<double>> stage(100, {-20, 10, 0}, 1);
    ASSERT_TRUE(stage.solved);
    EXPECT_LE(stage.system.evaluations(), 15u);
    EXPECT_LT(stage.residual(), 1e-11);
}

/// Two Morse particles, of which the second moves along their line, in a stage so long that what they do depends on
/// where they are then.
struct StageOfPair {
    static constexpr double tau = 3;
    System<double, Pairs<double>> system{engine<double>(PairForces{.count = 2}), 0, tau};
    Field<double> x{2}, v{2}, w{2};

    StageOfPair(double apart, double velocity) {
        x.set(1, {apart, 0, 0});
        v.set(1, {velocity, 0, 0});
    }

    bool solve() { return ImplicitStage<double>(system.force().coupling()).solve(system, x, v, tau, w); }

    /// Of the second particle, whose change of velocity is `change` and that of the first its opposite.
    double residual(double change) {
        Field<double> position(2), a(2);
        position.set(0, {tau * -change, 0, 0});
        position.set(1, {x.x()[1] + tau * (v.x()[1] + change), 0, 0});
        system.accelerations(position, a);
        return tau * a.x()[1] - change;
    }
    double slope(double change) { return (residual(change + 1e-7) - residual(change - 1e-7)) / 2e-7; }
};

// Full Newton steps go back and forth; halved where they overshoot they end.
TEST(Newton, solves_what_full_steps_do_not) {
    StageOfPair stage(0.1, -1);
    double full = 0;
    for (int i = 0; i < 50; ++i) full -= stage.residual(full) / stage.slope(full);
    EXPECT_GT(std::abs(stage.residual(full)), 1e-3);

    ASSERT_TRUE(stage.solve());
    EXPECT_LT(std::abs(stage.residual(stage.w.x()[1])), 1e-14);  // some roundings of numbers of size 1
}

// A residual may be smallest where it is not zero: that is no solution.
TEST(Newton, says_that_it_found_none) {
    StageOfPair stage(0.3, 1);
    EXPECT_FALSE(stage.solve());
    EXPECT_GT(std::abs(stage.residual(stage.w.x()[1])), 1e-3);
}

}  // namespace
}  // namespace steplab::test
