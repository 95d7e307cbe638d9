#pragma once

#include "methods/engines/gauss_table.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace steplab {

/// Columns of a matrix whose rows lie in the lanes of a register.
template <class T>
using StageColumns = std::array<Stages<T>, stage_count>;

/// sum over j of columns[j] numbers[j], from left to right; the numbers lie in lanes or in memory.
template <HasLanes N, class Numbers>
N product(const std::array<N, stage_count>& columns, const Numbers& numbers) {
    N sum = columns[0] * N(numbers[0]);
    for (std::size_t j = 1; j < stage_count; ++j) sum += columns[j] * N(numbers[j]);
    return sum;
}

/// The Gauss method for x'' = f(x) - gamma x', with the velocities of the stages eliminated. With kappa = gamma h and
/// M = (1 + kappa A)^-1 the stages and the end of a step of length h are
///     X  = x0 + h A M 1 v0 + h^2 A M A f,   V = M 1 v0 + h M A f,
///     x1 = x0 + h b M 1 v0 + h^2 b M A f,   v1 = v0 - kappa b M 1 v0 + h b M f.
struct GaussMatrices {
    using Row = GaussTable::Row;
    using Matrix = std::array<Row, stage_count>;

    long double kappa;
    Row reach{};           ///< A M 1
    Matrix stage{};        ///< columns of A M A
    Row velocity{};        ///< b M
    Row position{};        ///< b M A
    long double far = 0;   ///< b M 1
    Row start_speed{};     ///< M 1
    Matrix stage_speed{};  ///< columns of M A

    explicit constexpr GaussMatrices(long double damping) : kappa(damping) {
        const auto [ma, m1] = solved(damping);
        far = dot(gauss_table.b, m1);
        start_speed = m1;
        for (std::size_t j = 0; j < stage_count; ++j) {
            reach[j] = dot(gauss_table.a[j], m1);
            const Row column = column_of(ma, j);
            for (std::size_t i = 0; i < stage_count; ++i) stage[j][i] = dot(gauss_table.a[i], column);
            stage_speed[j] = column;
            position[j] = dot(gauss_table.b, column);
            velocity[j] = gauss_table.b[j] - kappa * position[j];
        }
    }

private:
    static constexpr Row column_of(const Matrix& matrix, std::size_t j) {
        Row column{};
        for (std::size_t i = 0; i < stage_count; ++i) column[i] = matrix[i][j];
        return column;
    }

    static constexpr long double dot(const Row& a, const Row& b) {
        long double sum = 0;
        for (std::size_t i = 0; i < stage_count; ++i) sum += a[i] * b[i];
        return sum;
    }

    /// M A and M 1 by elimination in (1 + kappa A | A, 1); without pivots, as the eigenvalues of A have positive real
    /// parts and those of its leading blocks stay away from zero.
    static constexpr std::pair<Matrix, Row> solved(long double kappa) {
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

inline constexpr GaussMatrices undamped_gauss{0};

template <class T>
constexpr std::array<T, stage_count> rounded_to(const GaussTable::Row& row) {
    std::array<T, stage_count> rounded{};
    for (std::size_t j = 0; j < stage_count; ++j) rounded[j] = static_cast<T>(row[j]);
    return rounded;
}

/// The weights of a step of length h, which they contain. What rounding cuts off them is kept too ("low"): a method is
/// symplectic only as far as its weights are right, and an error of 1e-16 in them would add up over the steps.
///
/// Two more things keep rounding from going up more often than down. h is in the weights: like most people's dt it is
/// close to a fraction of small numbers (0.3, 1.7), so that in h v the digits cut off would be a smooth function of v,
/// whose mean over an oscillation is not zero. And what is multiplied with v0 has half of T's digits, the rest is in
/// its low part: the sum of the products then keeps what is below rounding in the mean, where a product rounded before
/// would swallow it.
template <class T>
struct GaussWeights {
    /// The lanes of a product with `end`.
    enum : std::size_t { velocity, position, velocity_low, position_low, coefficient_6, coefficient_7 };

    T h = T(0);
    Stages<T> reach{T(0)}, reach_low{T(0)};  ///< h A M 1, half of T's digits and the rest
    StageColumns<T> stage{}, stage_low{};    ///< h^2 A M A
    T far = T(0), far_low = T(0);            ///< h b M 1, half of T's digits and the rest
    T loss = T(0);                           ///< -kappa b M 1
    StageColumns<T> end{};  ///< h b M, h^2 b M A, and what f's Legendre coefficients 6 and 7 are made of

    GaussWeights() = default;
    GaussWeights(const GaussMatrices& matrices, T length) { make(matrices, length); }

    void make(const GaussMatrices& matrices, T length) {
        h = length;
        const auto h1 = static_cast<long double>(length), h2 = h1 * h1;
        std::tie(reach, reach_low) = in_lanes(matrices.reach, h1, half_of_digits);
        far = half_of_digits(h1 * matrices.far);
        far_low = static_cast<T>(h1 * matrices.far - static_cast<long double>(far));
        loss = static_cast<T>(-matrices.kappa * matrices.far);
        for (std::size_t j = 0; j < stage_count; ++j) {
            std::tie(stage[j], stage_low[j]) = in_lanes(matrices.stage[j], h2);
            const long double v = h1 * matrices.velocity[j], x = h2 * matrices.position[j];
            alignas(64) const std::array<T, stage_count> column{rounded(v),
                                                                rounded(x),
                                                                rounded(rest(v)),
                                                                rounded(rest(x)),
                                                                last_coefficients[0][j],
                                                                last_coefficients[1][j]};
            end[j] = Stages<T>::load(column.data());
        }
    }

private:
    static T rounded(long double x) { return static_cast<T>(x); }
    static long double rest(long double x) { return x - static_cast<long double>(rounded(x)); }

    static constexpr std::array<std::array<T, stage_count>, 2> last_coefficients{
        rounded_to<T>(gauss_table.legendre[6]), rounded_to<T>(gauss_table.legendre[7])};

    /// Towards zero: first to a T, then to half of its digits.
    static T half_of_digits(long double x) {
        constexpr int digits = std::numeric_limits<T>::digits, dropped = digits - digits / 2;
        if constexpr (std::is_same_v<T, long double>) {  // which has no integer of its size
            int exponent = 0;
            const long double mantissa = std::frexp(x, &exponent);
            return std::ldexp(std::trunc(std::ldexp(mantissa, digits / 2)), exponent - digits / 2);
        } else {
            return with_dropped_bits(x, dropped);
        }
    }

    static T with_dropped_bits(long double x, int dropped) {
        using Bits = std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t>;
        const T nearest = rounded(x);
        const bool beyond = std::abs(static_cast<long double>(nearest)) > std::abs(x);
        const Bits bits = std::bit_cast<Bits>(nearest) - static_cast<Bits>(beyond);
        return std::bit_cast<T>(static_cast<Bits>(bits >> dropped << dropped));
    }

    /// scale row, and what `cut` leaves of it.
    static std::pair<Stages<T>, Stages<T>> in_lanes(const GaussTable::Row& row, long double scale,
                                                    T (*cut)(long double) = rounded) {
        alignas(64) std::array<T, stage_count> numbers, low;
        for (std::size_t i = 0; i < stage_count; ++i) {
            numbers[i] = cut(scale * row[i]);
            low[i] = static_cast<T>(scale * row[i] - static_cast<long double>(numbers[i]));
        }
        return {Stages<T>::load(numbers.data()), Stages<T>::load(low.data())};
    }
};

/// 1 / (c_j - c_k) of the nodes, 0 for j = k: of their Lagrange polynomials.
template <class T>
constexpr std::array<std::array<T, stage_count>, stage_count> inverse_gaps() {
    std::array<std::array<T, stage_count>, stage_count> inverse{};
    for (std::size_t j = 0; j < stage_count; ++j) {
        for (std::size_t k = 0; k < stage_count; ++k) {
            if (k != j) inverse[j][k] = static_cast<T>(1 / (gauss_table.c[j] - gauss_table.c[k]));
        }
    }
    return inverse;
}

/// Columns of the matrix that carries a polynomial from its values at the stages of one interval to those of another,
/// which begins at `first` and is `ratio` times as long, in units of the first.
template <class T>
StageColumns<T> extrapolation(T first, T ratio) {
    static constexpr auto nodes = rounded_to<T>(gauss_table.c);
    static constexpr auto gaps = inverse_gaps<T>();
    StageColumns<T> from_node, columns;
    alignas(64) std::array<T, stage_count> places;
    for (std::size_t i = 0; i < stage_count; ++i) places[i] = first + ratio * nodes[i];
    for (std::size_t k = 0; k < stage_count; ++k) from_node[k] = Stages<T>::load(places.data()) - Stages<T>(nodes[k]);
    for (std::size_t j = 0; j < stage_count; ++j) {
        Stages<T> lagrange = T(1);
        for (std::size_t k = 0; k < stage_count; ++k) {
            if (k != j) lagrange = lagrange * (from_node[k] * Stages<T>(gaps[j][k]));
        }
        columns[j] = lagrange;
    }
    return columns;
}

}  // namespace steplab
