#pragma once

#include "core/field.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/counted_drag.hpp"
#include "methods/engines/gauss_weights.hpp"

#include <array>
#include <cstddef>
#include <limits>

namespace steplab {

/// Calls f(k) for every place k in flat() that holds a particle's coordinate, padding left out. Inlined by order, so
/// that what f keeps is kept in registers.
template <class T, class F>
[[gnu::always_inline]] inline void each_coordinate(const Field<T>& field, std::size_t axes, F f) {
    const std::size_t stride = field.flat().size() / 3;
    for (std::size_t begin = 0; begin < axes * stride; begin += stride) {
        for (std::size_t k = begin; k < begin + field.count(); ++k) f(k);
    }
}

template <class T, class F>
[[gnu::always_inline]] inline void each_coordinate(const Field<T>& field, F f) {
    each_coordinate(field, 3, f);
}

/// Positions and velocities of one time in two parts: what they are, and what rounding has cut off them.
template <class T>
struct TwoPartState {
    Field<T> x, v;
    Lost<T> lost;

    TwoPartState() = default;
    explicit TwoPartState(const State<T>& state)
        : x(state.displacement), v(state.velocity), lost(true, state.displacement.count()) {}

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.x);
        f(self.v);
        f(self.lost.x);
        f(self.lost.v);
    }
};

/// The stages of one step of the Gauss method: found by fixed-point iteration down to rounding, all eight at once
/// (Antonana, Makazaga, Murua, arXiv:2511.03655), and what follows from them.
template <class T>
class GaussStages {
public:
    GaussStages() = default;
    /// The iteration ends where an error of the stages of this size, relative to how far they are from the start, is
    /// reached. Along further axes than `axes` nothing moves.
    GaussStages(std::size_t particles, std::size_t axes, T error)
        : axes_(axes), error2_(error * error), x_(particles), f_(particles), fixed_(particles), gain_(particles) {}

    /// Forces f at the stages of an interval, eight numbers in a row for every coordinate: the first guess of those of
    /// another interval, which begins at `first` and is `ratio` times as long.
    struct Known {
        const Field<T>& f;
        T first = T(1);
        T ratio = T(1);
    };
    static Field<T> room_for_known(const Field<T>& x) { return Field<T>(stage_count * x.flat().size() / 3); }

    /// False if the iteration does not converge.
    template <class System>
    bool solve(System& system, const TwoPartState<T>& begin, T h, const Known& known) {
        prepare(system.drag() * h, h, known);
        guess(begin, known.f);
        system.accelerations(x_, f_, axes_);
        const Sizes sizes = improve<true>(begin);
        T change = sizes.change, before = T(0);
        for (iterations_ = 2; iterations_ <= most_iterations; ++iterations_) {
            system.accelerations(x_, f_, axes_);
            if (settled(change, before, sizes)) break;
            before = change;
            change = improve<false>(begin).change;
        }
        find_gains();
        return iterations_ <= most_iterations;
    }

    /// The matrices of the last solve.
    const GaussMatrices& matrices() const { return matrices_; }
    /// Evaluations of all stages that the last solve took.
    std::size_t iterations() const { return iterations_; }

    /// From the beginning of the step to its end, which may be the same object. Coordinates that do not move are left.
    void advance(const TwoPartState<T>& from, TwoPartState<T>& to) const {
        each_coordinate(from.x, axes_, [&](std::size_t k) {
            const Stages<T>& gain = gain_.flat()[k];
            T x = from.x.flat()[k], v = from.v.flat()[k];
            const T start_v = v, below_v = from.lost.v.flat()[k];
            const T low = weights_.far * below_v + weights_.far_low * start_v;
            T lost_x = from.lost.x.flat()[k] + (low + gain[Weights::position_low]);
            T lost_v = below_v + gain[Weights::velocity_low];
            add_compensated(x, lost_x, weights_.far * start_v + gain[Weights::position]);
            add_compensated(v, lost_v, weights_.loss * start_v + gain[Weights::velocity]);
            to.x.flat()[k] = x;
            to.v.flat()[k] = v;
            to.lost.x.flat()[k] = lost_x;
            to.lost.v.flat()[k] = lost_v;
        });
    }

    /// Keeps the forces, to guess from.
    void keep(Field<T>& known) const {
        each_coordinate(f_, axes_, [&](std::size_t k) { f_.flat()[k].store(known.flat().data() + stage_count * k); });
    }

    /// Sums over all coordinates of squares: of the forces (their mean over the stages) and of their last two Legendre
    /// coefficients.
    struct Spectrum {
        T force = T(0), coefficient_6 = T(0), coefficient_7 = T(0);
    };
    Spectrum spectrum() const {
        Stages<T> squares = T(0), ends = T(0);
        each_coordinate(f_, axes_, [&](std::size_t k) {
            squares += f_.flat()[k] * f_.flat()[k];
            ends += gain_.flat()[k] * gain_.flat()[k];
        });
        return {sum(squares) / T(stage_count), ends[Weights::coefficient_6], ends[Weights::coefficient_7]};
    }

    /// Sum of the squares of what forces at the beginning and at the end of the step differ by from the polynomial of
    /// its stages.
    T gap_at_ends(const Field<T>& begin, const Field<T>& end) const {
        const Stages<T> at_begin = of_stages(gauss_table.begin), at_end = of_stages(gauss_table.end);
        T gap2 = T(0);
        each_coordinate(f_, axes_, [&](std::size_t k) {
            const T before = begin.flat()[k] - sum(at_begin * f_.flat()[k]);
            const T behind = end.flat()[k] - sum(at_end * f_.flat()[k]);
            gap2 += before * before + behind * behind;
        });
        return gap2;
    }

    /// Sum of the squares of the Legendre coefficients of orders 4 and 5 of the forces.
    T coefficients_4_and_5() const {
        T squares = T(0);
        for (const std::size_t order : {std::size_t{4}, std::size_t{5}}) {
            const Stages<T> weights = of_stages(gauss_table.legendre[order]);
            each_coordinate(f_, axes_, [&](std::size_t k) {
                const T coefficient = sum(weights * f_.flat()[k]);
                squares += coefficient * coefficient;
            });
        }
        return squares;
    }

private:
    using Weights = GaussWeights<T>;

    /// A number for each stage, in lanes, which are loaded from aligned memory.
    template <class Numbers>
    static Stages<T> of_stages(const Numbers& numbers) {
        alignas(64) const auto rounded = rounded_to<T>(numbers);
        return Stages<T>::load(rounded.data());
    }

    /// Where only half of the digits are right after this number, the step is too long: two halves of it cost less.
    static constexpr std::size_t most_iterations = 40;

    /// Sums over all coordinates and stages of squares.
    struct Sizes {
        T change;  ///< what the iteration has changed
        T stages;  ///< X - x0
        T start;   ///< x0
    };

    void prepare(T kappa, T h, const Known& known) {
        const bool other_damping = static_cast<long double>(kappa) != matrices_.kappa;
        const bool other_weights = other_damping || h != weights_.h;
        if (other_damping) matrices_ = kappa == T(0) ? undamped_gauss : GaussMatrices(static_cast<long double>(kappa));
        if (other_weights) weights_.make(matrices_, h);
        if (!other_weights && known.first == first_ && known.ratio == ratio_) return;
        first_ = known.first;
        ratio_ = known.ratio;
        guess_ = extrapolation(first_, ratio_);
        for (Stages<T>& column : guess_) column = product(weights_.stage, column);
    }

    void guess(const TwoPartState<T>& begin, const Field<T>& known) {
        each_coordinate(begin.x, axes_, [&](std::size_t k) {
            const T x = begin.x.flat()[k], v = begin.v.flat()[k];
            const Stages<T> pull = product(guess_, known.flat().data() + stage_count * k);
            x_.flat()[k] = Stages<T>(x) + (weights_.reach * Stages<T>(v) + (weights_.reach_low * Stages<T>(v) + pull));
        });
    }

    /// X = x0 + h A M 1 v0 + h^2 A M A f, and how far that is from the last one. The first time it also computes
    /// the part that stays, with what is below rounding.
    template <bool First>
    Sizes improve(const TwoPartState<T>& begin) {
        const StageColumns<T> columns = weights_.stage;
        const T* const start = begin.x.flat().data();
        const Stages<T>* const f = f_.flat().data();
        Stages<T>*const x = x_.flat().data(), *const fixed = fixed_.flat().data();
        Stages<T> change = T(0), stages = T(0), starts = T(0);
        each_coordinate(begin.x, axes_, [&](std::size_t k) {
            if constexpr (First) fixed[k] = fixed_part(begin, k);
            const Stages<T> moved = fixed[k] + product(columns, f[k]);
            const Stages<T> next = Stages<T>(start[k]) + moved, difference = next - x[k];
            x[k] = next;
            change += difference * difference;
            if constexpr (First) {
                stages += moved * moved;
                starts += Stages<T>(start[k] * start[k]);
            }
        });
        return {sum(change), sum(stages), sum(starts)};
    }

    /// h A M 1 v0, and what is below rounding: of x0, of v0, of the weights.
    [[gnu::always_inline]] Stages<T> fixed_part(const TwoPartState<T>& begin, std::size_t k) const {
        const Stages<T> v = begin.v.flat()[k], lost_v = begin.lost.v.flat()[k], lost_x = begin.lost.x.flat()[k];
        const Stages<T> low = product(weights_.stage_low, f_.flat()[k]) + weights_.reach_low * v;
        return weights_.reach * v + (lost_x + (low + weights_.reach * lost_v));
    }

    /// True if another iteration would change nothing that matters: its change, extrapolated from the last two, is
    /// below the error; or what changes is rounding alone, which falls no further.
    bool settled(T change, T before, const Sizes& sizes) const {
        constexpr T noise = T(64) * std::numeric_limits<T>::epsilon();
        if (change <= error2_ * sizes.stages) return true;
        if (before == T(0)) return false;
        if (change < before) return change * (change / before) <= error2_ * sizes.stages;
        return change <= noise * noise * (sizes.stages + sizes.start);
    }

    void find_gains() {
        each_coordinate(f_, axes_, [&](std::size_t k) { gain_.flat()[k] = product(weights_.end, f_.flat()[k]); });
    }

    static T sum(const Stages<T>& lanes) {
        return ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]));
    }

    std::size_t axes_ = 3;
    T error2_ = T(0);
    std::size_t iterations_ = 0;
    Field<Stages<T>> x_, f_;
    Field<Stages<T>> fixed_;  ///< what of X - x0 does not depend on f, and what is below rounding
    Field<Stages<T>> gain_;   ///< what f does to the end of the step
    GaussMatrices matrices_ = undamped_gauss;
    Weights weights_;
    T first_ = T(1), ratio_ = T(1);
    StageColumns<T> guess_{};  ///< from known forces to h^-2 (X - x0)
};

/// The work of drag in a step of length h from `begin`, forces at whose stages are known (GaussStages::keep()).
template <class T>
double gauss_work(const CountedDrag& drag, const GaussMatrices& matrices, const TwoPartState<T>& begin,
                  const Field<T>& known, T h) {
    std::array<double, stage_count> weights, start_speed;
    std::array<std::array<double, stage_count>, stage_count> stage_speed;
    for (std::size_t i = 0; i < stage_count; ++i) {
        weights[i] = static_cast<double>(gauss_table.b[i]);
        start_speed[i] = static_cast<double>(matrices.start_speed[i]);
        for (std::size_t j = 0; j < stage_count; ++j)
            stage_speed[j][i] = to_double(h) * static_cast<double>(matrices.stage_speed[j][i]);
    }
    double sum = 0;
    drag.each_place(begin.v, [&](std::size_t k, double c) {
        const double v = to_double(begin.v.flat()[k]) + to_double(begin.lost.v.flat()[k]);
        std::array<double, stage_count> speed;
        for (std::size_t i = 0; i < stage_count; ++i) speed[i] = start_speed[i] * v;
        for (std::size_t j = 0; j < stage_count; ++j) {
            const double f = to_double(known.flat()[stage_count * k + j]);
            for (std::size_t i = 0; i < stage_count; ++i) speed[i] += stage_speed[j][i] * f;
        }
        double squares = 0;
        for (std::size_t i = 0; i < stage_count; ++i) squares += weights[i] * speed[i] * speed[i];
        sum += c * squares;
    });
    return to_double(h) * sum;
}

}  // namespace steplab
