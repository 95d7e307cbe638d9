#pragma once

#include "methods/gauss_table.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

/// Columns of a matrix whose rows lie in the lanes of a register.
template <class T>
using StageColumns = std::array<Stages<T>, stage_count>;

/// sum over j of columns[j] numbers[j], from left to right; the numbers lie in lanes or in memory.
template <SideBySide N, class Numbers>
N product(const std::array<N, stage_count>& columns, const Numbers& numbers) {
    N sum = columns[0] * N(numbers[0]);
    for (std::size_t j = 1; j < stage_count; ++j) sum += columns[j] * N(numbers[j]);
    return sum;
}

/// The Gauss method for x'' = f(x) - gamma x', with the velocities of the stages eliminated. With kappa = gamma h and
/// M = (1 + kappa A)^-1 the stages and the end of a step of length h are
///     X  = x0 + h (A M 1 v0 + h A M A f),
///     x1 = x0 + h (b M 1 v0 + h b M A f),   v1 = v0 - kappa b M 1 v0 + h b M f.
/// What rounding cuts off the weights is kept too ("low"): a method is symplectic only as far as its weights are
/// right, and an error of 1e-16 in them would add up over the steps.
template <class T>
struct GaussWeights {
    /// The lanes of a product with `end`.
    enum : std::size_t { velocity, position, velocity_low, position_low, coefficient_6, coefficient_7 };

    T kappa;
    Stages<T> reach, reach_low;        ///< A M 1
    StageColumns<T> stage, stage_low;  ///< A M A
    T end_reach;                       ///< b M 1
    StageColumns<T> end;               ///< b M, b M A, and what f's Legendre coefficients 6 and 7 are made of

    explicit GaussWeights(T damping) : kappa(damping) {
        const auto [ma, m1] = solved(static_cast<long double>(damping));
        std::array<Row, stage_count> rows{}, low{}, columns{};
        Row lanes{};
        for (std::size_t i = 0; i < stage_count; ++i) {
            lanes[i] = dot(gauss_table.a[i], m1);
            for (std::size_t j = 0; j < stage_count; ++j) {
                rows[j][i] = dot(gauss_table.a[i], column(ma, j));
                low[j][i] = rest(rows[j][i]);
            }
        }
        reach = in_lanes(lanes);
        for (long double& weight : lanes) weight = rest(weight);
        reach_low = in_lanes(lanes);
        end_reach = static_cast<T>(dot(gauss_table.b, m1));
        for (std::size_t j = 0; j < stage_count; ++j) {
            const long double x = dot(gauss_table.b, column(ma, j));
            const long double v = gauss_table.b[j] - static_cast<long double>(damping) * x;
            columns[j] = {v, x, rest(v), rest(x), gauss_table.legendre[6][j], gauss_table.legendre[7][j], 0, 0};
            stage[j] = in_lanes(rows[j]);
            stage_low[j] = in_lanes(low[j]);
            end[j] = in_lanes(columns[j]);
        }
    }

private:
    using Row = GaussTable::Row;
    using Matrix = std::array<Row, stage_count>;

    static long double rest(long double x) { return x - static_cast<long double>(static_cast<T>(x)); }

    static Stages<T> in_lanes(const Row& row) {
        alignas(64) std::array<T, stage_count> numbers;
        for (std::size_t i = 0; i < stage_count; ++i) numbers[i] = static_cast<T>(row[i]);
        return Stages<T>::load(numbers.data());
    }

    static Row column(const Matrix& matrix, std::size_t j) {
        Row column{};
        for (std::size_t i = 0; i < stage_count; ++i) column[i] = matrix[i][j];
        return column;
    }

    static long double dot(const Row& a, const Row& b) {
        long double sum = 0;
        for (std::size_t i = 0; i < stage_count; ++i) sum += a[i] * b[i];
        return sum;
    }

    /// M A and M 1 by elimination in (1 + kappa A | A, 1); without pivots, as the eigenvalues of A have positive real
    /// parts and those of its leading blocks stay away from zero.
    static std::pair<Matrix, Row> solved(long double kappa) {
        Matrix left{}, right = gauss_table.a;
        Row one{};
        one.fill(1);
        if (kappa == 0) return {right, one};
        for (std::size_t i = 0; i < stage_count; ++i) {
            for (std::size_t j = 0; j < stage_count; ++j) left[i][j] = kappa * gauss_table.a[i][j];
            left[i][i] += 1;
        }
        for (std::size_t p = 0; p < stage_count; ++p) {
            for (std::size_t i = 0; i < stage_count; ++i) {
                if (i == p) continue;
                const long double factor = left[i][p] / left[p][p];
                for (std::size_t j = 0; j < stage_count; ++j) left[i][j] -= factor * left[p][j];
                for (std::size_t j = 0; j < stage_count; ++j) right[i][j] -= factor * right[p][j];
                one[i] -= factor * one[p];
            }
        }
        for (std::size_t i = 0; i < stage_count; ++i) {
            for (std::size_t j = 0; j < stage_count; ++j) right[i][j] /= left[i][i];
            one[i] /= left[i][i];
        }
        return {right, one};
    }
};

/// Columns of the matrix that carries a polynomial from its values at the stages of one interval to those of another,
/// which begins at `first` and is `ratio` times as long, in units of the first.
template <class T>
StageColumns<T> extrapolation(T first, T ratio) {
    StageColumns<T> columns;
    alignas(64) std::array<T, stage_count> nodes;
    for (std::size_t i = 0; i < stage_count; ++i) nodes[i] = first + ratio * static_cast<T>(gauss_table.c[i]);
    const Stages<T> at = Stages<T>::load(nodes.data());
    for (std::size_t j = 0; j < stage_count; ++j) {
        Stages<T> lagrange = T(1);
        for (std::size_t k = 0; k < stage_count; ++k) {
            if (k == j) continue;
            const auto gap = static_cast<T>(1 / (gauss_table.c[j] - gauss_table.c[k]));
            lagrange = lagrange * ((at - Stages<T>(static_cast<T>(gauss_table.c[k]))) * Stages<T>(gap));
        }
        columns[j] = lagrange;
    }
    return columns;
}

}  // namespace steplab
