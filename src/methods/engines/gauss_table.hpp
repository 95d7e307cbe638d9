#pragma once

#include "core/stages.hpp"

#include <array>
#include <cstddef>

namespace steplab {

/// Gauss collocation with 8 stages on [0, 1] as a Runge-Kutta method of order 16 (Butcher, Math. Comp. 18 (1964) 50;
/// Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.7).
struct GaussTable {
    using Row = std::array<long double, stage_count>;

    Row c{};                                  ///< nodes: the roots of the Legendre polynomial P_8
    Row b{};                                  ///< weights
    std::array<Row, stage_count> a{};         ///< a[i][j] = integral of the j-th Lagrange polynomial from 0 to c_i
    std::array<Row, stage_count> legendre{};  ///< legendre[k][j]: what f_j adds to the coefficient of P_k(2 s - 1) of f
    Row begin{}, end{};  ///< what f_j adds to the polynomial at 0 and at 1, where P_k is (-1)^k and 1
};

namespace detail {

/// P_0 .. P_8 at x.
constexpr std::array<long double, stage_count + 1> legendre_polynomials(long double x) {
    std::array<long double, stage_count + 1> p{1, x};
    for (std::size_t k = 1; k < stage_count; ++k) {
        const auto degree = static_cast<long double>(k);
        p[k + 1] = ((2 * degree + 1) * x * p[k] - degree * p[k - 1]) / (degree + 1);
    }
    return p;
}

/// From the nodes alone: b_j = 2 (1 - x_j^2) / (8 P_7(x_j))^2 halved for the unit interval (Abramowitz, Stegun
/// 25.4.29), and a from the integrals of the Legendre polynomials, in which f is expanded by the quadrature itself
/// (Hairer, Wanner, Solving Ordinary Differential Equations II, IV.5).
constexpr GaussTable make_gauss_table() {
    constexpr std::array<long double, stage_count / 2> positive_roots{
        0.18343464249564980493947614236018L, 0.52553240991632898581773904918925L, 0.79666647741362673959155393647583L,
        0.96028985649753623168356086856947L};
    GaussTable table;
    std::array<std::array<long double, stage_count + 1>, stage_count> p{};
    for (std::size_t j = 0; j < stage_count; ++j) {
        const long double x = j < 4 ? -positive_roots[3 - j] : positive_roots[j - 4];
        p[j] = legendre_polynomials(x);
        table.c[j] = (1 + x) / 2;
        table.b[j] = (1 - x * x) / (64 * p[j][7] * p[j][7]);
        for (std::size_t k = 0; k < stage_count; ++k)
            table.legendre[k][j] = table.b[j] * static_cast<long double>(2 * k + 1) * p[j][k];
        for (std::size_t k = 0; k < stage_count; ++k) {
            table.end[j] += table.legendre[k][j];
            table.begin[j] += (k % 2 == 0 ? 1 : -1) * table.legendre[k][j];
        }
    }
    for (std::size_t i = 0; i < stage_count; ++i) {
        for (std::size_t j = 0; j < stage_count; ++j) {
            long double sum = table.c[i];
            for (std::size_t k = 1; k < stage_count; ++k) sum += p[j][k] * (p[i][k + 1] - p[i][k - 1]) / 2;
            table.a[i][j] = table.b[j] * sum;
        }
    }
    return table;
}

}  // namespace detail

inline constexpr GaussTable gauss_table = detail::make_gauss_table();

}  // namespace steplab
