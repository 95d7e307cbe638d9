#pragma once

#include "core/field.hpp"
#include "methods/engines/adaptive_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace steplab {

/// Extrapolation of Stoermer's rule (Gragg; Deuflhard; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
/// I, II.14) on x'' = a(x) - gamma v, in the form of velocity Verlet with drag central in time, which is symmetric. A
/// step is taken with 1, 2, ... 8 substeps, whose errors are series in h^2; eight of them make order 16. What is summed
/// and extrapolated is the change of positions and velocities, so that rounding is relative to that. For references: no
/// method of the catalogue is of this family.
template <class T>
class Extrapolation {
public:
    static constexpr std::size_t columns = 8, order = 2 * columns;

    explicit Extrapolation(std::size_t particles) : x_(particles), a_(particles), start_a_(particles) {
        for (State<T>& entry : table_) entry = {Field<T>(particles), Field<T>(particles)};
    }

    /// What a step of length h adds to x and v, where the accelerations, drag included, are a. Of a System<T, Force>
    /// (methods/engines/system.hpp), or what has its accelerations(x, a), drag() and damping.
    template <class Equations>
    const State<T>& change(Equations& system, const Field<T>& x, const Field<T>& v, const Field<T>& a, T h) {
        for (std::size_t row = 0; row < columns; ++row) {
            take_substeps(system, x, v, a, h / static_cast<T>(substeps(row)), row);
            extrapolate(row);
        }
        return table_[0];
    }

    /// One step of length h from and to `state`.
    template <class Equations>
    void step(Equations& system, State<T>& state, Lost<T>& lost, T h) {
        accelerate(system, state.displacement, state.velocity, start_a_);
        const State<T>& both = change(system, state.displacement, state.velocity, start_a_, h);
        add(both.displacement, state.displacement, lost.x);
        add(both.velocity, state.velocity, lost.v);
    }

    /// sum += change, compensated if `lost` is kept.
    static void add(const Field<T>& change, Field<T>& sum, Field<T>& lost) {
        T none = T(0);
        for (std::size_t k = 0; k < sum.flat().size(); ++k, none = T(0))
            add_compensated(sum.flat()[k], lost.count() > 0 ? lost.flat()[k] : none, change.flat()[k]);
    }

    /// What the last step adds without the row of one substep, of order 14.
    const State<T>& lower_order() const { return table_[1]; }

private:
    static constexpr int substeps(std::size_t row) { return static_cast<int>(row) + 1; }

    /// All of a row, each of length h, into the row's entry of the table:
    ///     v(1/2) = v(0) + h/2 (a(0) - gamma v(0)), x(1) = x(0) + h v(1/2),
    ///     (1 + gamma h/2) v(1) = v(1/2) + h/2 a(1).
    /// With damping besides, each of these half steps of v is between two flows of it.
    template <class Equations>
    void take_substeps(Equations& system, const Field<T>& x, const Field<T>& v, const Field<T>& a, T h,
                       std::size_t row) {
        if (system.damped()) return take_damped_substeps(system, x, v, h, row);
        auto& [moved, gained] = table_[row];
        std::fill(moved.flat().begin(), moved.flat().end(), T(0));
        std::fill(gained.flat().begin(), gained.flat().end(), T(0));
        a_ = a;
        const T half = h / T(2), drag = system.drag();
        const std::size_t size = x.flat().size();
        for (int substep = 0; substep < substeps(row); ++substep) {
            for (std::size_t k = 0; k < size; ++k) {
                gained.flat()[k] += half * a_.flat()[k];
                moved.flat()[k] += h * (v.flat()[k] + gained.flat()[k]);
                x_.flat()[k] = x.flat()[k] + moved.flat()[k];
            }
            system.accelerations(x_, a_);
            for (std::size_t k = 0; k < size; ++k) {
                T& gain = gained.flat()[k];
                gain = (gain + half * (a_.flat()[k] - drag * v.flat()[k])) / (T(1) + half * drag);
                a_.flat()[k] -= drag * (v.flat()[k] + gain);
            }
        }
    }

    template <class Equations>
    void take_damped_substeps(Equations& system, const Field<T>& x, const Field<T>& v, T h, std::size_t row) {
        auto& [moved, gained] = table_[row];
        State<T> now{x, v};
        const auto kick = [&] {
            system.accelerations(now.displacement, a_);
            system.damp(now.displacement, now.velocity, h / T(4));
            const T drag = system.drag();
            for (std::size_t k = 0; k < a_.flat().size(); ++k) {
                T& speed = now.velocity.flat()[k];
                speed = ((T(1) - h / T(4) * drag) * speed + h / T(2) * a_.flat()[k]) / (T(1) + h / T(4) * drag);
            }
            system.damp(now.displacement, now.velocity, h / T(4));
        };
        for (int substep = 0; substep < substeps(row); ++substep) {
            kick();
            for (std::size_t k = 0; k < x.flat().size(); ++k) now.displacement.flat()[k] += h * now.velocity.flat()[k];
            kick();
        }
        for (std::size_t k = 0; k < x.flat().size(); ++k) {
            moved.flat()[k] = now.displacement.flat()[k] - x.flat()[k];
            gained.flat()[k] = now.velocity.flat()[k] - v.flat()[k];
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

    Field<T> x_, a_;  ///< within a step
    Field<T> start_a_;
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
        const State<T>& change = method_.change(system, from.x, from.v, from.a, h);
        next.x = from.x;
        next.v = from.v;
        next.lost = from.lost;
        Extrapolation<T>::add(change.displacement, next.x, next.lost.x);
        Extrapolation<T>::add(change.velocity, next.v, next.lost.v);
        const State<T>& lower = method_.lower_order();
        return larger_of(error(next.x, change.displacement, lower.displacement, tolerance),
                         error(next.v, change.velocity, lower.velocity, tolerance));
    }

    template <class System>
    void finish(System& system, T, Moment<T>& next) {
        accelerate(system, next.x, next.v, next.a);
    }

    template <class System>
    void between(System& system, const Moment<T>& from, const Moment<T>&, T h, T part, State<T>& out) {
        out = {from.x, from.v};
        Lost<T> lost = from.lost;
        method_.step(system, out, lost, part * h);
    }

    void forget() {}

private:
    /// Largest of any component, relative to tolerance (1 + |value|); not a number if one is none.
    static double error(const Field<T>& value, const Field<T>& change, const Field<T>& lower, T tolerance) {
        Field<T> relative(value.count());
        for (std::size_t k = 0; k < value.flat().size(); ++k) {
            const T allowed = tolerance * (T(1) + std::abs(value.flat()[k]));
            relative.flat()[k] = std::abs(change.flat()[k] - lower.flat()[k]) / allowed;
        }
        return static_cast<double>(largest_of(relative));
    }

    Extrapolation<T> method_;
};

}  // namespace steplab
