#pragma once

#include "core/entry.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/line.hpp"
#include "support/all_at_once.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steplab::test {

using Real = long double;

/// A ball that circles the held end of its spring, its angle the time itself: one frequency, and a solution known in
/// all digits, so that the error of a high order is seen alone. Reversal of time is a symmetry of the circle, under
/// which the angle's error of one order has the other sign than that of the next: of an even order, the next order is
/// in the radius alone.
struct CirclingBall {
    LineForces forces;
    Real drag;

    State<Real> start() const {
        State<Real> state{Field<Real>(2), Field<Real>(2)};
        state.displacement.x()[1] = 1 - static_cast<Real>(forces.rest_length);
        state.velocity.x()[1] = -drag / 2;
        state.velocity.y()[1] = 1;
        return state;
    }

    /// By how much it is ahead.
    Real angle_error(const Field<Real>& displacement, Real time) const {
        const Real x = static_cast<Real>(forces.rest_length) + displacement.x()[1], y = displacement.y()[1];
        const Real c = std::cos(time), s = std::sin(time);
        return std::atan2(y * c - x * s, x * c + y * s);
    }

    /// How far its position or its velocity is off, whichever is more.
    Real error(const State<Real>& state, Real time) const {
        const Real size = std::exp(-drag / 2 * time), c = size * std::cos(time), s = size * std::sin(time);
        const Real x = static_cast<Real>(forces.rest_length) + state.displacement.x()[1];
        const Real off_x = std::hypot(x - c, state.displacement.y()[1] - s);
        const Real off_v =
            std::hypot(state.velocity.x()[1] + drag / 2 * c + s, state.velocity.y()[1] + drag / 2 * s - c);
        return std::max(off_x, off_v);
    }

    System<Real, Line<Real>> system(Real dt) const { return {Line<Real>(forces), drag, dt}; }

    /// Where a method takes it in so many frames of dt.
    template <class Integrator>
    State<Real> after(std::size_t frames, Real dt, const ParameterValues& parameters) const {
        System ball(force_for<Integrator>(Line<Real>(forces)), drag, dt);
        State<Real> state = start();
        Integrator integrator(parameters);
        integrator.start(ball, state);
        for (std::size_t i = 0; i < frames; ++i) integrator.step(ball);
        integrator.synchronised(ball, state);
        return state;
    }
};

/// Nonlinear, without drag; and with drag, where a spiral keeps its angular velocity if the spring is linear.
inline constexpr CirclingBall free_circle{{.count = 2, .first_fixed = true, .mass = 1, .k = 2, .rest_length = 0.5}, 0};
inline constexpr CirclingBall damped_circle{{.count = 2, .first_fixed = true, .mass = 1, .k = 1.0625, .rest_length = 0},
                                            0.5L};

/// The exponent with which errors fall.
inline double exponent(Real coarse_error, Real fine_error, Real ratio_of_steps) {
    return static_cast<double>(std::log(std::abs(coarse_error / fine_error)) / std::log(ratio_of_steps));
}

}  // namespace steplab::test
