#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "methods/engines/adaptive_steps.hpp"
#include "methods/engines/weighted_sum.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace steplab {

/// An explicit Runge-Kutta method with error estimates and dense output (Hairer, Norsett, Wanner, Solving Ordinary
/// Differential Equations I, II.4 to II.6). Its last row of `Stages` is the end of the step, whose slope is the next
/// step's first; the rows behind are further stages that only dense output needs. With theta the part of the step,
///     y(theta) = y0 + theta (d + (1 - theta) (h k_0 - d + theta (2 d - h (k_0 + k_end) + (1 - theta) p))),
///     p = h (D_0 k + theta (D_1 k + (1 - theta) (D_2 k + theta D_3 k))),  d = y1 - y0.
template <std::size_t Stages, std::size_t Further, std::size_t Errors, std::size_t Dense>
struct EmbeddedTable {
    static constexpr std::size_t stages = Stages, all = Stages + Further, errors = Errors, dense_terms = Dense;
    using Row = std::array<long double, all>;
    std::array<Row, all> a;
    std::array<Row, Errors>
        error;                     ///< differences to embedded methods; the first counts, a second is its denominator's
    std::array<Row, Dense> dense;  ///< D
};

/// One step of such a method on (x, v)' = (v, a(x) - gamma v); `Table::table` is its table, `Table::control` its step
/// control.
template <class T, class Table>
class EmbeddedRungeKutta {
public:
    static constexpr ControlConstants control = Table::control;

    explicit EmbeddedRungeKutta(std::size_t count) : x_(count), squares_(count) {
        for (std::size_t i = 0; i < all; ++i) {
            if (i == 0 || i == last) continue;  // they are the moments' own
            stage_v_[i] = Field<T>(count);
            stage_a_[i] = Field<T>(count);
        }
    }

    /// From `from` on for h. Fills positions and velocities of `next`; the error is the root of the mean square over
    /// all components, each relative to tolerance (1 + |value|).
    template <class System>
    double attempt(System& system, const Moment<T>& from, T h, Moment<T>& next, T tolerance) {
        stages_of_step(system, from, h, next);
        if constexpr (end_in_error) accelerate(system, next.x, next.v, next.a);
        const double count = 6 * static_cast<double>(from.x.count());
        const double first = square_sum<0>(from, next, tolerance);
        const double step = static_cast<double>(h);
        if constexpr (errors == 1) {
            return step * std::sqrt(first / count);
        } else {
            // the error of order 3 makes that of order 5 one of order 8: Hairer, Norsett, Wanner I, II.5, (5.39)
            const double both = first + 0.01 * square_sum<1>(from, next, tolerance);
            return both > 0 ? step * first / std::sqrt(count * both) : both;
        }
    }

    template <class System>
    void finish(System& system, T, Moment<T>& next) {
        if constexpr (!end_in_error) accelerate(system, next.x, next.v, next.a);
        known_ = Known::step;
    }

    void forget() { known_ = Known::nothing; }

    /// The state at from + part h by dense output.
    template <class System>
    void between(System& system, const Moment<T>& from, const Moment<T>& next, T h, T part, State<T>& out) {
        know(Known::all, system, from, next, h);
        const Row weights = dense_weights(part);
        interpolate(from.x, slopes_of_x<all>(from, next), weights, h, out.displacement);
        interpolate(from.v, slopes_of_v<all>(from, next), weights, h, out.velocity);
    }

    /// The work of drag up to there, by the same weights; of a whole step they are those of its end.
    template <class System>
    double work(System& system, const Moment<T>& from, const Moment<T>& next, T h, T part, const CountedDrag& drag) {
        know(part < T(1) ? Known::all : Known::step, system, from, next, h);
        const Row weights = dense_weights(part);
        double sum = 0;
        for (std::size_t j = 0; j < all; ++j) {
            if (weights[j] == T(0)) continue;
            const Field<T>& v = j == 0 ? from.v : j == last ? next.v : stage_v_[j];
            sum += to_double(weights[j]) * drag.power(v);
        }
        return to_double(h) * sum;
    }
    using CanCountDrag = void;

    /// What the slopes are multiplied with at y0 + part h.
    static std::array<T, Table::table.all> dense_weights(T part) {
        Row weights{};
        const T rest = T(1) - part;
        for (std::size_t j = 0; j < all; ++j) {
            const T d = static_cast<T>(table.a[last][j]), first = T(j == 0), end = T(j == last);
            weights[j] = part * (d + rest * (first - d + part * (T(2) * d - first - end + rest * dense_term(j, part))));
        }
        return weights;
    }

private:
    using N = Lanes<T>;
    static constexpr auto& table = Table::table;
    static constexpr std::size_t stages = std::remove_cvref_t<decltype(table)>::stages;
    static constexpr std::size_t all = std::remove_cvref_t<decltype(table)>::all;
    static constexpr std::size_t errors = std::remove_cvref_t<decltype(table)>::errors;
    static constexpr std::size_t last = stages - 1;
    static constexpr bool end_in_error = table.error[0][last] != 0;
    using Row = std::array<T, all>;

    template <std::size_t I>
    struct StageWeights {
        static constexpr auto weights = table.a[I];
    };
    template <std::size_t I>
    struct ErrorWeights {
        static constexpr auto weights = table.error[I];
    };

    static T dense_term(std::size_t j, T part) {
        T sum = T(0);
        for (std::size_t i = table.dense.size(); i-- > 0;) {
            sum = static_cast<T>(table.dense[i][j]) + (i % 2 == 0 ? part : T(1) - part) * sum;
        }
        return sum;
    }

    template <class System>
    void stages_of_step(System& system, const Moment<T>& from, T h, Moment<T>& next) {
        known_ = Known::nothing;
        [&]<std::size_t... I>(std::index_sequence<I...>) { (stage<I + 1>(system, from, h, next), ...); }
        (std::make_index_sequence<last - 1>{});
        end(from, h, next);
    }

    /// Which stages of the last step are in memory.
    enum class Known { nothing, step, all };

    /// Those that are no longer there, or needed between the ends alone, are computed.
    template <class System>
    void know(Known wanted, System& system, const Moment<T>& from, const Moment<T>& next, T h) {
        if (known_ == Known::nothing) {
            Moment<T> again(from.x.count());
            stages_of_step(system, from, h, again);
            known_ = Known::step;
        }
        if (wanted == Known::step || known_ == Known::all) return;
        further_stages(system, from, h, next);
        known_ = Known::all;
    }

    template <class System>
    void further_stages(System& system, const Moment<T>& from, T h, const Moment<T>& next) {
        [&]<std::size_t... I>(std::index_sequence<I...>) { (stage<stages + I>(system, from, h, next), ...); }
        (std::make_index_sequence<all - stages>{});
    }

    template <std::size_t I, class System>
    void stage(System& system, const Moment<T>& from, T h, const Moment<T>& next) {
        const T *const x = from.x.flat().data(), *const v = from.v.flat().data();
        T *const at_x = x_.flat().data(), *const at_v = stage_v_[I].flat().data();
        const auto of_x = slopes_of_x<I>(from, next), of_v = slopes_of_v<I>(from, next);
        lanewise<T>(x_.flat().size(), [=](std::size_t k) {
            (N::load(x + k) + N(h) * weighted_sum<StageWeights<I>>(of_x, k)).store(at_x + k);
            (N::load(v + k) + N(h) * weighted_sum<StageWeights<I>>(of_v, k)).store(at_v + k);
        });
        accelerate(system, x_, stage_v_[I], stage_a_[I]);
    }

    void end(const Moment<T>& from, T h, Moment<T>& next) {
        const auto of_x = slopes_of_x<last>(from, next), of_v = slopes_of_v<last>(from, next);
        const SumInto<T> sum_x(from.x, from.lost.x, next.x, next.lost.x),
            sum_v(from.v, from.lost.v, next.v, next.lost.v);
        lanewise<T>(x_.flat().size(), [=](std::size_t k) {
            sum_x.add(k, N(h) * weighted_sum<StageWeights<last>>(of_x, k));
            sum_v.add(k, N(h) * weighted_sum<StageWeights<last>>(of_v, k));
        });
    }

    /// Over all components, of the slopes' sum with weights error[I] in units of what is allowed.
    template <std::size_t I>
    double square_sum(const Moment<T>& from, const Moment<T>& next, T tolerance) {
        const auto of_x = slopes_of_x<stages>(from, next), of_v = slopes_of_v<stages>(from, next);
        const T *const x = from.x.flat().data(), *const v = from.v.flat().data();
        const T *const next_x = next.x.flat().data(), *const next_v = next.v.flat().data();
        T* const squares = squares_.flat().data();
        const auto square = [tolerance](N error, N before, N after) {
            const N p = magnitude(before), q = magnitude(after);
            const N scaled = error / (N(tolerance) * (N(T(1)) + where(p > q, p, q)));
            return scaled * scaled;
        };
        lanewise<T>(x_.flat().size(), [=](std::size_t k) {
            const N of_position = weighted_sum<ErrorWeights<I>>(of_x, k),
                    of_velocity = weighted_sum<ErrorWeights<I>>(of_v, k);
            (square(of_position, N::load(x + k), N::load(next_x + k)) +
             square(of_velocity, N::load(v + k), N::load(next_v + k)))
                .store(squares + k);
        });
        return static_cast<double>(sum_of(squares_));
    }

    template <std::size_t M>
    static void interpolate(const Field<T>& from, const std::array<const T*, M>& slopes, const Row& weights, T h,
                            Field<T>& out) {
        out = from;
        T* const y = out.flat().data();
        lanewise<T>(out.flat().size(), [=](std::size_t k) {
            N sum = N(weights[0]) * N::load(slopes[0] + k);
            for (std::size_t j = 1; j < M; ++j) sum = sum + N(weights[j]) * N::load(slopes[j] + k);
            (N::load(y + k) + N(h) * sum).store(y + k);
        });
    }

    /// The first M slopes: of the positions and of the velocities.
    template <std::size_t M>
    std::array<const T*, M> slopes_of_x(const Moment<T>& from, const Moment<T>& next) const {
        return slopes<M>(from.v, stage_v_, next.v);
    }
    template <std::size_t M>
    std::array<const T*, M> slopes_of_v(const Moment<T>& from, const Moment<T>& next) const {
        return slopes<M>(from.a, stage_a_, next.a);
    }
    template <std::size_t M>
    static std::array<const T*, M> slopes(const Field<T>& first, const std::array<Field<T>, all>& stage,
                                          const Field<T>& end) {
        std::array<const T*, M> result;
        for (std::size_t j = 0; j < M; ++j) result[j] = (j == 0 ? first : j == last ? end : stage[j]).flat().data();
        return result;
    }

    Field<T> x_;  ///< of a stage
    Field<T> squares_;
    std::array<Field<T>, all> stage_v_, stage_a_;
    Known known_ = Known::nothing;
};

}  // namespace steplab
