#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/interruption.hpp"
#include "methods/engines/newton_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace steplab {

/// Solves the equations of one stage of a diagonally implicit Runge-Kutta method (Hairer, Wanner, Solving Ordinary
/// Differential Equations II, IV.6),
///
///     X = x + tau V,   V = v + W,   W = tau (a(X) - gamma V - D(X) V),
///
/// each line of the second multiplied by the mass of its particle where masses differ,
/// for the change of velocity W by Newton's method with the exact Jacobian: (1 + tau gamma - tau^2 J) dW = -residual,
/// where there is damping D with tau D besides, but without its derivative.
/// As W is the unknown, what a step adds to position and velocity has small relative errors.
template <class T>
class ImplicitStage {
public:
    ImplicitStage() = default;
    explicit ImplicitStage(const Coupling& coupling)
        : matrix_(coupling),
          position_(coupling.particles),
          acceleration_(coupling.particles),
          residual_(coupling.particles),
          update_(coupling.particles),
          trial_(coupling.particles) {}

    /// False if no solution was found. Full Newton steps come first: stretched springs need them, whose residual grows
    /// before it falls. Where those do not end, steps are halved until the residual falls.
    template <class System>
    bool solve(System& system, const Field<T>& x, const Field<T>& v, T tau, Field<T>& w) {
        return iterate(system, x, v, tau, w, 1) || iterate(system, x, v, tau, w, most_halvings);
    }

    /// X of the solution that was found.
    const Field<T>& position() const { return position_; }

private:
    static constexpr int most_iterations = 50, most_halvings = 8;
    static constexpr T rounding = 4 * std::numeric_limits<T>::epsilon();
    /// Updates this small are rounding or end in it with the next one, Newton's convergence being quadratic.
    static constexpr T nearly = 4096 * std::numeric_limits<T>::epsilon();

    /// From w = 0, by Newton steps of which up to `parts` fractions are tried. Ends where a step changes nothing that
    /// rounding leaves, or where the residual no longer falls because rounding is all that is left.
    template <class System>
    bool iterate(System& system, const Field<T>& x, const Field<T>& v, T tau, Field<T>& w, int parts) {
        std::fill(w.flat().begin(), w.flat().end(), T(0));
        T size = evaluate(system, x, v, tau, w);
        for (int iteration = 0; iteration < most_iterations; ++iteration) {
            check_interruption();
            if (!std::isfinite(size) || !matrix_.factorise()) return false;
            matrix_.solve(residual_, update_);
            const T change = largest(update_);
            if (!std::isfinite(change)) return false;
            const T scale = largest(v) + largest(w) + largest(position_) / std::abs(tau);
            if (change <= rounding * scale) return add(w, T(1), w), true;
            const T before = size;
            if (!advance(system, x, v, tau, w, size, parts)) return change <= nearly * scale;
            if (size >= before / T(2) && change <= nearly * scale) return true;
        }
        return false;
    }

    /// One Newton step; where it has several parts, half, a quarter, ... of it until the residual gets smaller, and
    /// false if no part does that.
    template <class System>
    bool advance(System& system, const Field<T>& x, const Field<T>& v, T tau, Field<T>& w, T& size, int parts) {
        T part = T(1);
        for (int halving = 0; halving < parts; ++halving, part /= T(2)) {
            add(w, part, trial_);
            const T trial_size = evaluate(system, x, v, tau, trial_);
            if (parts > 1 && !(trial_size < size)) continue;
            std::swap(w, trial_);
            size = trial_size;
            return true;
        }
        return false;
    }

    /// sum = w + part * update.
    void add(const Field<T>& w, T part, Field<T>& sum) const {
        const T *const from = w.flat().data(), *const update = update_.flat().data();
        T* const to = sum.flat().data();
        elementwise(w.flat().size(), [=](std::size_t k) { to[k] = from[k] + part * update[k]; });
    }

    /// Minus the residual and the matrix at w; returns the residual's largest component.
    template <class System>
    T evaluate(System& system, const Field<T>& x, const Field<T>& v, T tau, const Field<T>& w) {
        const T drag = system.drag();
        const T *const from = x.flat().data(), *const speed = v.flat().data(), *const change = w.flat().data();
        T* const position = position_.flat().data();
        elementwise(x.flat().size(), [=](std::size_t k) { position[k] = from[k] + tau * (speed[k] + change[k]); });
        const auto& force = system.force();
        const std::vector<T>& masses = masses_of(force);
        matrix_.reset(T(1) + tau * drag, masses);
        system.accelerations_and_blocks(position_, acceleration_, [&](std::size_t i, std::size_t j, const auto& block) {
            matrix_.add(i, j, tau * tau * block, force.moves(i), force.moves(j));
        });
        if (system.damped()) add_damping(system, v, tau, w);
        T *const residual = residual_.flat().data(), *const a = acceleration_.flat().data();
        elementwise(x.flat().size(),
                    [=](std::size_t k) { residual[k] = tau * (a[k] - drag * (speed[k] + change[k])) - change[k]; });
        const T size = largest(residual_);
        for (std::size_t i = 0; i < masses.size(); ++i) {
            for (T* const component : {residual_.x(), residual_.y(), residual_.z()}) component[i] *= masses[i];
        }
        return size;
    }

    template <class System>
    void add_damping(const System& system, const Field<T>& v, T tau, const Field<T>& w) {
        Field<T> moving(v.count());
        const T *const speed = v.flat().data(), *const change = w.flat().data();
        T* const sum = moving.flat().data();
        elementwise(v.flat().size(), [=](std::size_t k) { sum[k] = speed[k] + change[k]; });
        system.add_damping(position_, moving, acceleration_);
        system.each_damping(position_, [&](std::size_t i, std::size_t j, const auto& block) {
            matrix_.add(i, j, tau * block, system.force().moves(i), system.force().moves(j));
        });
    }

    /// In the unit of mass; empty where all are 1.
    template <class Force>
    static const std::vector<T>& masses_of(const Force& force) {
        if constexpr (KnowsMasses<Force>) return force.masses();
        static const std::vector<T> equal;
        return equal;
    }

    /// The largest component, not a number if one is none.
    static T largest(const Field<T>& field) {
        T most = T(0), invalid = T(0);
        for (const T number : field.flat()) {
            const T size = std::abs(number);
            most = size > most ? size : most;
            invalid += number - number;
        }
        return most + invalid;
    }

    NewtonMatrix<T> matrix_;
    Field<T> position_, acceleration_, residual_, update_, trial_;
};

}  // namespace steplab
