#pragma once

#include "core/field.hpp"
#include "methods/adaptive_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steplab {

/// Extrapolation of the explicit midpoint rule (Gragg; Bulirsch, Stoer; Hairer, Norsett, Wanner, Solving Ordinary
/// Differential Equations I, II.9) on x'' = a(x) - gamma v, in steps of one size. A step is taken with 2, 4, ... 16
/// substeps, whose errors are series in h^2; eight of them make order 16. For references: no method of the catalogue is
/// of this family.
template <class T>
class Extrapolation {
public:
    static constexpr std::size_t columns = 8, order = 2 * columns;

    explicit Extrapolation(std::size_t particles) : slope_(zero(particles)), middle_(zero(particles)) {
        for (State<T>& entry : table_) entry = zero(particles);
    }

    /// One step of length h, from and to `state`. A System<T, Force> (methods/system.hpp), or what has its
    /// accelerations(x, a) and drag().
    template <class Equations>
    void step(Equations& system, State<T>& state, T h) {
        slope(system, state, slope_);
        for (std::size_t row = 0; row < columns; ++row) {
            midpoint_rule(system, state, h, substeps(row), table_[row]);
            extrapolate(row);
        }
        state = table_[0];
    }

    /// The same step without the coarsest row, of order 14.
    const State<T>& lower_order() const { return table_[1]; }

private:
    static constexpr int substeps(std::size_t row) { return 2 * (static_cast<int>(row) + 1); }
    static State<T> zero(std::size_t particles) { return {Field<T>(particles), Field<T>(particles)}; }

    /// (x, v)' = (v, a(x) - gamma v).
    template <class Equations>
    static void slope(Equations& system, const State<T>& y, State<T>& out) {
        system.accelerations(y.displacement, out.velocity);
        out.displacement = y.velocity;
        for (std::size_t k = 0; k < out.velocity.flat().size(); ++k)
            out.velocity.flat()[k] -= system.drag() * y.velocity.flat()[k];
    }

    /// to = from + h slope.
    static void add(const State<T>& from, T h, const State<T>& slope, State<T>& to) {
        for (std::size_t k = 0; k < from.velocity.flat().size(); ++k) {
            to.displacement.flat()[k] = from.displacement.flat()[k] + h * slope.displacement.flat()[k];
            to.velocity.flat()[k] = from.velocity.flat()[k] + h * slope.velocity.flat()[k];
        }
    }

    /// y(1) = y(0) + h f(y(0)), y(m+1) = y(m-1) + 2 h f(y(m)), up to y(n), n even.
    template <class Equations>
    void midpoint_rule(Equations& system, const State<T>& start, T length, int n, State<T>& end) {
        const T h = length / static_cast<T>(n);
        before_ = start;
        add(start, h, slope_, end);
        for (int m = 1; m < n; ++m) {
            slope(system, end, middle_);
            add(before_, T(2) * h, middle_, before_);
            std::swap(before_, end);
        }
    }

    /// Aitken-Neville: after row j, table_[i] holds the entry of the j-th row that used the rows i .. j.
    void extrapolate(std::size_t row) {
        for (std::size_t first = row; first-- > 0;) {
            const T ratio = static_cast<T>(substeps(row)) / static_cast<T>(substeps(first));
            towards(table_[first + 1], ratio * ratio - T(1), table_[first]);
        }
    }

    /// older = newer + (newer - older) / weight.
    static void towards(const State<T>& newer, T weight, State<T>& older) {
        const auto combine = [weight](const Field<T>& a, Field<T>& b) {
            for (std::size_t k = 0; k < a.flat().size(); ++k)
                b.flat()[k] = a.flat()[k] + (a.flat()[k] - b.flat()[k]) / weight;
        };
        combine(newer.displacement, older.displacement);
        combine(newer.velocity, older.velocity);
    }

    State<T> slope_;  ///< at the start of the step
    State<T> before_, middle_;
    std::array<State<T>, columns> table_;
};

/// The rule of AdaptiveSteps that takes such steps, with the difference to order 14 as their error.
template <class T>
class ExtrapolationRule {
public:
    static constexpr ControlConstants control{.order = Extrapolation<T>::order - 1};

    explicit ExtrapolationRule(std::size_t particles) : method_(particles) {}

    template <class System>
    double attempt(System& system, const Moment<T>& from, T h, Moment<T>& next, T tolerance) {
        state_ = {from.x, from.v};
        method_.step(system, state_, h);
        next.x = state_.displacement;
        next.v = state_.velocity;
        next.lost = from.lost;
        const State<T>& lower = method_.lower_order();
        return std::max(error(next.x, lower.displacement, tolerance), error(next.v, lower.velocity, tolerance));
    }

    template <class System>
    void finish(System& system, T, Moment<T>& next) {
        accelerate(system, next.x, next.v, next.a);
    }

    template <class System>
    void between(System& system, const Moment<T>& from, const Moment<T>&, T h, T part, State<T>& out) {
        out = {from.x, from.v};
        method_.step(system, out, part * h);
    }

    void forget() {}

private:
    /// Largest of any component, relative to tolerance (1 + |value|); not a number if one is none.
    static double error(const Field<T>& value, const Field<T>& lower, T tolerance) {
        Field<T> relative(value.count());
        for (std::size_t k = 0; k < value.flat().size(); ++k) {
            const T v = value.flat()[k];
            relative.flat()[k] = std::abs(v - lower.flat()[k]) / (tolerance * (T(1) + std::abs(v)));
        }
        return static_cast<double>(largest_of(relative));
    }

    Extrapolation<T> method_;
    State<T> state_;
};

}  // namespace steplab
