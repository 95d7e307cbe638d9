#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/counted_drag.hpp"
#include "methods/engines/gauss_stages.hpp"
#include "methods/engines/gauss_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace steplab {

/// The Gauss-Radau rule of 8 nodes on [0, 1] whose first is 0, in the forms that the method of Everhart (in: Dynamics
/// of Comets, 1985, 185; Rein, Spiegel, MNRAS 446 (2015) 1424) works with. The accelerations of a step are
///     a(s) = a0 + g_0 s + g_1 s (s - h_1) + ... + g_6 s (s - h_1) ... (s - h_6)      (Newton, eq. 5)
///          = a0 + b_0 s + b_1 s^2 + ... + b_6 s^7                                    (eq. 4)
struct Radau {
    static constexpr std::size_t terms = 7;

    /// The nodes after 0: roots of P_7 + P_8 on [-1, 1] but for -1, carried to [0, 1].
    static constexpr std::array<long double, terms> nodes{
        0.056262560536922146465652191032311L, 0.18024069173689236498757994280918L, 0.35262471711316963737390777017124L,
        0.54715362633055538300144855765235L,  0.73421017721541053152321060830661L, 0.88532094683909576809035976293249L,
        0.97752061356128750189117450042915L};

    /// Of the rule on [0, 1], of the node 0 and of those after it: (1 - x) / (8 P_7(x))^2 halved, x the node on [-1, 1]
    /// (Abramowitz, Stegun 25.4.31).
    static constexpr long double first_weight = 1.0L / 64;
    static constexpr auto weights = [] {
        std::array<long double, terms> w{};
        for (std::size_t n = 0; n < terms; ++n) {
            const long double x = 2 * nodes[n] - 1, p = detail::legendre_polynomials(x)[terms];
            w[n] = (1 - x) / (128 * p * p);
        }
        return w;
    }();

    /// from_newton[k][j]: what g_k adds to b_j.
    static constexpr auto from_newton = [] {
        std::array<std::array<long double, terms>, terms> c{};
        c[0][0] = 1;
        for (std::size_t k = 1; k < terms; ++k) {
            for (std::size_t j = 0; j <= k; ++j) {
                c[k][j] = (j > 0 ? c[k - 1][j - 1] : 0) - nodes[k - 1] * c[k - 1][j];
            }
        }
        return c;
    }();

    /// shift[j][k]: what b_k adds to b_j of the same polynomial expanded at s = 1, (k + 1 over j + 1).
    static constexpr auto shift = [] {
        std::array<std::array<long double, terms>, terms> binomial{};
        for (std::size_t k = 0; k < terms; ++k) {
            long double value = static_cast<long double>(k + 1);
            for (std::size_t j = 0; j <= k; ++j) {
                binomial[j][k] = value;
                value = value * static_cast<long double>(k - j) / static_cast<long double>(j + 2);
            }
        }
        return binomial;
    }();

    /// What s^power adds to the coefficient of P_order(2 s - 1): (2 k + 1) n!^2 / ((n - k)! (n + k + 1)!).
    static constexpr long double legendre(std::size_t order, std::size_t power) {
        long double value = static_cast<long double>(2 * order + 1) / static_cast<long double>(power + 1);
        for (std::size_t i = 0; i < order; ++i)
            value *= static_cast<long double>(power - i) / static_cast<long double>(power + 2 + i);
        return value;
    }

    /// The numbers of the coefficients' fields.
    template <class Fields>
    static auto numbers(Fields& fields) {
        std::array<decltype(fields[0].flat().data()), terms> all;
        std::transform(fields.begin(), fields.end(), all.begin(), [](auto& f) { return f.flat().data(); });
        return all;
    }
};

/// What a and b_0 ... b_6 add to a motion after s of a step, x0 and v0 left out: eq. 9 and 10.
template <class T>
struct RadauWeights {
    std::array<T, Radau::terms + 1> position{}, velocity{};

    explicit RadauWeights(T s) {
        T power = s;
        for (std::size_t j = 0; j <= Radau::terms; ++j, power *= s) {
            velocity[j] = power / static_cast<T>(j + 1);
            position[j] = power * s / static_cast<T>((j + 1) * (j + 2));
        }
    }
};

/// weights[0] a + weights[1] b_0 + ..., the smallest first.
template <class T>
struct RadauSum {
    std::array<T, Radau::terms + 1> weights;
    const T* a;
    std::array<const T*, Radau::terms> b;

    T operator()(std::size_t k) const {
        T sum = weights[Radau::terms] * b[Radau::terms - 1][k];
        for (std::size_t j = Radau::terms - 1; j > 0; --j) sum += weights[j] * b[j - 1][k];
        return sum + weights[0] * a[k];
    }
};

/// g from b: b_j = sum over k of from_newton[k][j] g_k, solved from the last.
template <class T>
void newton_form(const std::array<Field<T>, Radau::terms>& b, std::array<Field<T>, Radau::terms>& g) {
    for (std::size_t j = Radau::terms; j-- > 0;) {
        const T* const from = b[j].flat().data();
        elementwise(b[j].flat().size(), [=, to = Radau::numbers(g)](std::size_t k) {
            T rest = from[k];
            for (std::size_t i = j + 1; i < Radau::terms; ++i)
                rest -= static_cast<T>(Radau::from_newton[i][j]) * to[i][k];
            to[j][k] = rest;
        });
    }
}

/// b of a step `ratio` times as long, from those of the one before if its polynomial goes on (eq. 13).
template <class T>
void carry_on_radau(const std::array<Field<T>, Radau::terms>& before, T ratio,
                    std::array<Field<T>, Radau::terms>& next) {
    T power = T(1);
    for (std::size_t j = 0; j < Radau::terms; ++j) {
        power *= ratio;
        T* const b = next[j].flat().data();
        elementwise(next[j].flat().size(), [=, last = Radau::numbers(before)](std::size_t k) {
            T sum = T(0);
            for (std::size_t i = j; i < Radau::terms; ++i) sum += static_cast<T>(Radau::shift[j][i]) * last[i][k];
            b[k] = power * sum;
        });
    }
}

/// The same of a step from the same beginning.
template <class T>
void shorten_radau(const std::array<Field<T>, Radau::terms>& whole, T ratio, std::array<Field<T>, Radau::terms>& part) {
    T power = T(1);
    for (std::size_t j = 0; j < Radau::terms; ++j) {
        power *= ratio;
        T* const b = part[j].flat().data();
        const T* const last = whole[j].flat().data();
        elementwise(part[j].flat().size(), [=](std::size_t k) { b[k] = power * last[k]; });
    }
}

/// The work of drag in a step of length h from velocities v and accelerations a: by the rule of the nodes.
template <class T>
double radau_work(const CountedDrag& drag, const Field<T>& v, const Field<T>& a,
                  const std::array<Field<T>, Radau::terms>& b, T h) {
    double sum = static_cast<double>(Radau::first_weight) * drag.power(v);
    for (std::size_t n = 0; n < Radau::terms; ++n) {
        const RadauSum<T> change{RadauWeights<T>(static_cast<T>(Radau::nodes[n])).velocity, a.flat().data(),
                                 Radau::numbers(b)};
        const auto there = [&](std::size_t k) { return to_double(v.flat()[k]) + to_double(h) * to_double(change(k)); };
        sum += static_cast<double>(Radau::weights[n]) * drag.power_of(v, there);
    }
    return to_double(h) * sum;
}

/// A state on to s of a step of length h.
template <class T>
void move_radau(TwoPartState<T>& state, const Field<T>& a, const std::array<Field<T>, Radau::terms>& b, T h, T s) {
    const RadauWeights<T> at(s);
    const RadauSum<T> position{at.position, a.flat().data(), Radau::numbers(b)},
        velocity{at.velocity, position.a, position.b};
    T *const x = state.x.flat().data(), *const v = state.v.flat().data();
    T *const lost_x = state.lost.x.flat().data(), *const lost_v = state.lost.v.flat().data();
    elementwise(a.flat().size(), [=](std::size_t k) {
        lost_x[k] += s * h * lost_v[k];
        add_compensated(x[k], lost_x[k], h * (s * v[k] + h * position(k)));
        add_compensated(v[k], lost_v[k], h * velocity(k));
    });
}

/// How the steps follow from the tolerance.
struct RadauControl {
    /// omega h at tolerance 1, and the longest that the iteration is good for. Rein and Spiegel's epsilon, the last
    /// coefficient relative to the accelerations, is (omega h)^7 / 7! = 265 tolerance^(7/15).
    static constexpr double reach = 7.5, longest = 4.6;
    /// The error of the last two coefficients that the iteration leaves, relative to the accelerations and the
    /// tolerance: the end of a step moves by 0.004 and 0.0002 of it.
    static constexpr double iteration_share = 100;
};

}  // namespace steplab
