#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/phi.hpp"
#include "methods/engines/adaptive_steps.hpp"
#include "methods/engines/weighted_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace steplab {

/// An explicit Runge-Kutta-Nystrom method for u'' = f(t, u) with an embedded one of lower order for its error (Hairer,
/// Norsett, Wanner, Solving Ordinary Differential Equations I, II.14):
///     k_i = f(t + c[i] h, u + c[i] h u' + h^2 sum_j a[i][j] k_j),
///     u += h u' + h^2 sum_i b[i] k_i,  u' += h sum_i b_slope[i] k_i.
template <std::size_t Stages>
struct NystromTable {
    static constexpr std::size_t stages = Stages;
    using Row = std::array<long double, Stages>;
    Row c;
    std::array<Row, Stages> a;
    Row b, b_slope;                ///< of the method
    Row embedded, embedded_slope;  ///< of the lower order

    /// The difference of the two methods.
    constexpr Row error() const { return difference(b, embedded); }
    constexpr Row error_slope() const { return difference(b_slope, embedded_slope); }

private:
    static constexpr Row difference(const Row& p, const Row& q) {
        Row result{};
        for (std::size_t i = 0; i < Stages; ++i) result[i] = p[i] - q[i];
        return result;
    }
};

/// One step of such a method on x'' = a(x) - gamma v; `Table::table` is its table, `Table::control` its step control.
/// Drag would make the force depend on v; in u(s) = exp(gamma s / 2) x, s the time since the step's beginning, it is
/// u'' = exp(gamma s / 2) a(x) + gamma^2 / 4 u, free of velocities, so that the method keeps its order.
template <class T, class Table>
class EmbeddedNystrom {
public:
    static constexpr ControlConstants control = Table::control;

    explicit EmbeddedNystrom(std::size_t count) : x_(count), v_(count), error_x_(count), error_v_(count) {
        for (auto& field : k_) field = Field<T>(count);
        for (auto& field : sums_) field = Field<T>(count);
    }

    /// From `from` on for h. Fills positions and velocities of `next`; the error is the largest of any component,
    /// relative to tolerance (1 + |value|).
    template <class System>
    double attempt(System& system, const Moment<T>& from, T h, Moment<T>& next, T tolerance) {
        if (system.drag() * h > most_damping) return std::numeric_limits<double>::infinity();
        stages_of_step(system, from, h);
        end(from, h, system.drag(), next, tolerance);
        return static_cast<double>(larger_of(largest_of(error_x_), largest_of(error_v_)));
    }

    template <class System>
    void finish(System& system, T, Moment<T>& next) {
        accelerate(system, next.x, next.v, next.a);
    }

    /// The state at from + part h, by a step of its own from `from`.
    template <class System>
    void between(System& system, const Moment<T>& from, const Moment<T>&, T h, T part, State<T>& out) {
        if (seen_.x.count() != from.x.count()) seen_ = Moment<T>(from.x.count());
        attempt(system, from, part * h, seen_, T(1));
        out = {seen_.x, seen_.v};
    }

    void forget() {}

private:
    using N = Lanes<T>;
    static constexpr auto& table = Table::table;
    /// gamma h above which u and x are too far apart for any precision: e^16 times.
    static constexpr T most_damping = T(32);
    static constexpr std::size_t stages = std::remove_cvref_t<decltype(Table::table)>::stages;
    template <std::size_t I>
    struct StageWeights {
        static constexpr auto weights = table.a[I];
    };
    struct EndWeights {
        static constexpr auto weights = table.b;
    };
    struct EndSlopeWeights {
        static constexpr auto weights = table.b_slope;
    };
    struct ErrorWeights {
        static constexpr auto weights = table.error();
    };
    struct ErrorSlopeWeights {
        static constexpr auto weights = table.error_slope();
    };

    template <class System>
    void stages_of_step(System& system, const Moment<T>& from, T h) {
        first_stage(system, from);
        [&]<std::size_t... I>(std::index_sequence<I...>) { (stage<I + 1>(system, from, h), ...); }
        (std::make_index_sequence<stages - 1>{});
    }

    /// u, u' and u'' where s = 0; without drag they are x, v and a.
    template <class System>
    void first_stage(System& system, const Moment<T>& from) {
        const T drag = system.drag();
        if (drag == T(0)) return;
        const T *const x = from.x.flat().data(), *const v = from.v.flat().data(), *const a = from.a.flat().data();
        T *const slope = v_.flat().data(), *const k0 = k_[0].flat().data();
        elementwise(x_.flat().size(), [=](std::size_t k) {
            slope[k] = v[k] + drag / T(2) * x[k];
            k0[k] = a[k] + drag * (v[k] + drag / T(4) * x[k]);
        });
    }

    template <std::size_t I, class System>
    void stage(System& system, const Moment<T>& from, T h) {
        const T drag = system.drag(), step = static_cast<T>(table.c[I]) * h;
        if constexpr (first_of(I) == I) begin_sums<I>(from, drag);
        begin_stage<I>(from, h, step, drag);
        if (drag == T(0)) return system.accelerations(x_, k_[I]);
        const T growth = exponential(drag * step / T(2)), decay = T(1) / growth, stiffness = drag * drag / T(4);
        T *const at = x_.flat().data(), *const force = k_[I].flat().data();
        elementwise(x_.flat().size(), [=](std::size_t k) { at[k] *= decay; });
        system.accelerations(x_, k_[I]);
        elementwise(x_.flat().size(), [=](std::size_t k) { force[k] = growth * (force[k] + stiffness * at[k]); });
    }

    /// Stages whose sums over the slopes before all of them are taken together: slopes of all stages are more than a
    /// first-level cache holds, and are read once for them.
    static constexpr std::size_t together = 4;
    /// Of those that stage I is taken together with.
    static constexpr std::size_t first_of(std::size_t i) { return (i - 1) / together * together + 1; }

    /// The first I terms of the sums of stage I and of those that are taken together with it.
    template <std::size_t I>
    void begin_sums(const Moment<T>& from, T drag) {
        const auto before = accelerations<I>(from, drag);
        [&]<std::size_t... S>(std::index_sequence<S...>) {
            const std::array<T*, sizeof...(S)> to{sums_[S].flat().data()...};
            lanewise<T>(x_.flat().size(), [=](std::size_t k) {
                const std::array<N, sizeof...(S)> sums{weighted_sum<StageWeights<I + S>>(before, k)...};
                (sums[S].store(to[S] + k), ...);
            });
        }
        (std::make_index_sequence<std::min(together, stages - I)>{});
    }

    template <std::size_t I>
    void begin_stage(const Moment<T>& from, T h, T step, T drag) {
        const T *const x = from.x.flat().data(), *const v = slope(from, drag);
        T* const at = x_.flat().data();
        const auto before = accelerations<I>(from, drag);
        constexpr std::size_t begun = first_of(I);
        const T* const sums = sums_[I - begun].flat().data();
        lanewise<T>(x_.flat().size(), [=, square = h * h](std::size_t k) {
            const N sum = with_terms<StageWeights<I>, begun>(N::load(sums + k), before, k);
            const N moved = N(step) * N::load(v + k) + N(square) * sum;
            (N::load(x + k) + moved).store(at + k);
        });
    }

    const T* slope(const Moment<T>& from, T drag) const { return (drag == T(0) ? from.v : v_).flat().data(); }

    /// k_0 ... k_(N-1); the first is the step's beginning's own unless there is drag.
    template <std::size_t N>
    std::array<const T*, N> accelerations(const Moment<T>& from, T drag) const {
        std::array<const T*, N> result;
        for (std::size_t j = 0; j < N; ++j) result[j] = k_[j].flat().data();
        if (drag == T(0)) result[0] = from.a.flat().data();
        return result;
    }

    /// From u and u' back to x and v, as increments so that no digits are lost: with d = exp(-gamma h / 2),
    /// x - x_0 = d (u - u_0) + (d - 1) x_0 and v - v_0 = d ((u' - u'_0) - gamma / 2 (u - u_0)) + (d - 1) v_0.
    void end(const Moment<T>& from, T h, T drag, Moment<T>& next, T tolerance) {
        const T half = drag / T(2), exponent = -half * h, loss = drag == T(0) ? T(0) : exponent * phi_1(exponent);
        const T *const x = from.x.flat().data(), *const v = from.v.flat().data(), *const u1 = slope(from, drag);
        const auto slopes = accelerations<stages>(from, drag);
        T *const error_x = error_x_.flat().data(), *const error_v = error_v_.flat().data();
        const SumInto<T> sum_x(from.x, from.lost.x, next.x, next.lost.x),
            sum_v(from.v, from.lost.v, next.v, next.lost.v);
        lanewise<T>(x_.flat().size(), [=, square = N(h * h), decay = T(1) + loss](std::size_t k) {
            const N u = N(h) * N::load(u1 + k) + square * weighted_sum<EndWeights>(slopes, k);
            const N slope = N(h) * weighted_sum<EndSlopeWeights>(slopes, k);
            const N error = square * weighted_sum<ErrorWeights>(slopes, k);
            const N error_of_slope = N(h) * weighted_sum<ErrorSlopeWeights>(slopes, k);
            const N end_x = sum_x.add(k, N(decay) * u + N(loss) * N::load(x + k));
            const N end_v = sum_v.add(k, N(decay) * (slope - N(half) * u) + N(loss) * N::load(v + k));
            relative(N(decay) * error, end_x, tolerance).store(error_x + k);
            relative(N(decay) * (error_of_slope - N(half) * error), end_v, tolerance).store(error_v + k);
        });
    }

    static N relative(N error, N value, T tolerance) {
        return magnitude(error) / (N(tolerance) * (N(T(1)) + magnitude(value)));
    }

    Field<T> x_;                  ///< of a stage
    Field<T> v_;                  ///< u' at the beginning
    Field<T> error_x_, error_v_;  ///< relative to what is allowed
    std::array<Field<T>, stages> k_;
    std::array<Field<T>, together> sums_;  ///< of the stages begun so far
    Moment<T> seen_;
};

}  // namespace steplab
