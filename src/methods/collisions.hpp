#pragma once

#include "core/collision.hpp"
#include "core/elementwise.hpp"
#include "core/field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace steplab {

// Two particles that meet exactly (head on, by symmetry; neighbours in a line) pass through each other, and the force
// between them, which points along their distance, jumps. A step across the jump loses its order. An adaptive method
// therefore
//
//     h = guard.before(system, now, h)                     shortens a step on its way to a collision;
//     if (guard.at_hand()) guard.cross(system, now, next)  takes the collision itself;
//     if (guard.passes(system, now, next.x, h)) ...        throws away a trial that straddles one, and tries the h
//     given.
//
// where `now` and `next` hold fields x, v, a of one time, a the accelerations with drag. The steps end ever nearer
// before the collision, their ends predicted from x, v, a of their beginnings, until it is so near that one step of the
// velocity Verlet kind, whose two half kicks are weighted by the times before and after, takes the jump with an error
// below rounding.

/// When two particles will be abreast of each other, and how far apart: predicted from their present accelerations.
template <class T>
struct Meeting {
    T distance;  ///< now
    T time;      ///< from now; not above 0 where there will be none
    T miss;      ///< distance then
    T turn;      ///< change of velocity while the distance turns by a right angle, if they miss each other

    /// A pass at a distance is smooth and left to the control of errors.
    bool is_collision(T negligible_turn) const {
        return distance > T(0) && time > T(0) && (miss < T(0.1) * distance || turn < negligible_turn);
    }
};

/// d(t) = d + w t + b t^2 / 2, where d . d(t) = 0.
template <class T, class System, class Moment>
Meeting<T> meeting(const System& system, const Moment& now, std::uint32_t first, std::uint32_t second) {
    const auto d = system.separation(now.x, first, second);
    const auto difference = [=](const Field<T>& f) {
        return decltype(d){f.x()[second] - f.x()[first], f.y()[second] - f.y()[first], f.z()[second] - f.z()[first]};
    };
    const auto dot = [](const auto& p, const auto& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
    const auto w = difference(now.v), b = difference(now.a);
    const T c = dot(d, d), p = dot(d, w), q = dot(d, b) / T(2);
    const T time = T(2) * c / (square_root(p * p - T(4) * q * c) - p);  // not a number where there is no root
    const auto then = [=](T d0, T w0, T b0) { return d0 + time * (w0 + time / T(2) * b0); };
    const decltype(d) at{then(d.x, w.x, b.x), then(d.y, w.y, b.y), then(d.z, w.z, b.z)};
    const T miss = square_root(dot(at, at));
    return {square_root(c), time, miss, miss * square_root(dot(b, b) / dot(w, w))};
}

template <class T>
class CollisionGuard {
public:
    /// `tolerance`: of the errors of a step.
    explicit CollisionGuard(T tolerance)
        : negligible_turn_(std::max(tolerance / T(10), T(64) * std::numeric_limits<T>::epsilon())) {}

    /// The length allowed of a step that would have the length h.
    template <class System, class Moment>
    T before(const System& system, const Moment& now, T h) {
        tries_ = 0;
        if (!approaching()) return h;
        const Meeting<T> next = meeting<T>(system, now, state_.first, state_.second);
        if (!next.is_collision(negligible_turn_) || next.time > state_.scale) {
            state_.scale = T(0);
            return h;
        }
        state_.time = next.time;
        return std::min(h, reach());
    }

    /// True if a trial step of length h that ends at these positions carries particles through each other. Then h
    /// becomes the length to try instead.
    template <class System, class Moment>
    bool passes(const System& system, const Moment& now, const Field<T>& end, T& h) {
        T earliest = std::numeric_limits<T>::infinity();
        std::uint32_t pair[2] = {0, 0};
        system.passing_pairs(now.x, end, [&](std::uint32_t first, std::uint32_t second) {
            const Meeting<T> next = meeting<T>(system, now, first, second);
            const T time = next.time > T(0) ? std::min(next.time, h) : h;
            if ((!next.is_collision(negligible_turn_) && next.time < h) || !(next.distance > T(0)) ||
                !(time < earliest))
                return;
            earliest = time;
            pair[0] = first;
            pair[1] = second;
        });
        if (!(earliest <= h)) return false;
        // a second trial that straddles shows that the prediction is late
        state_ = {approaching() ? state_.scale : h, tries_++ > 0 ? std::min(earliest, h / T(2)) : earliest, pair[0],
                  pair[1]};
        h = reach();
        return true;
    }

    /// True on the way to a collision: steps are shorter than the control of errors would have them.
    bool approaching() const { return state_.scale > T(0); }
    /// True if the collision is so near that cross() may take it.
    bool at_hand() const { return approaching() && state_.time <= T(2) * nearest(); }
    /// Length of the step in which the collision was first seen: a good first guess behind it.
    T scale() const { return state_.scale; }

    /// Takes the step across: `next` gets x, v, a as long behind the collision as `now` is before it. Returns the time
    /// of the collision from now, half of the step; the pairs go to `record`, whose times begin at `start`.
    template <class System, class Moment>
    T cross(System& system, const Moment& now, Moment& next, double start, CollisionRecord& record) {
        const T time = state_.time, whole = T(2) * time, drag = system.drag();
        const T *const x = now.x.flat().data(), *const v = now.v.flat().data(), *const a = now.a.flat().data();
        T *const next_x = next.x.flat().data(), *const next_v = next.v.flat().data(),
                 *const next_a = next.a.flat().data();
        const std::size_t size = now.x.flat().size();
        elementwise(size, [=](std::size_t k) { next_x[k] = x[k] + whole * (v[k] + time * a[k]); });
        system.accelerations(next.x, next.a);
        elementwise(size, [=](std::size_t k) {
            const T at_collision = v[k] + time * a[k];
            next_a[k] = (next_a[k] - drag * at_collision) / (T(1) + drag * time);  // drag with the new velocity
            next_v[k] = at_collision + time * next_a[k];
        });
        system.passing_pairs(now.x, next.x, [&](std::uint32_t first, std::uint32_t second) {
            record.add({start + static_cast<double>(time), first, second});
        });
        state_.scale = T(0);
        return time;
    }

    /// The pair that a step is on its way to; part of an integrator's internal state. Plain data.
    struct State {
        T scale = T(0);  ///< 0: none
        T time = T(0);
        std::uint32_t first = 0, second = 0;
    };
    const State& state() const { return state_; }
    void state(const State& state) { state_ = state; }

private:
    /// Half of the step that crosses: its error, of second order, is a sixteenth of the rounding unit relative to what
    /// happens in a step of length `scale`, and there the distance still has half of its digits.
    T nearest() const { return state_.scale * square_root(std::numeric_limits<T>::epsilon()) / T(4); }

    /// A step that ends before the collision by a margin in which its prediction and the positions of the method's last
    /// stages, both of higher order in the time left, are safe.
    T reach() const {
        const T share = std::min(T(1), state_.time / state_.scale) / T(10);
        return state_.time - std::max(nearest(), share * state_.time);
    }

    T negligible_turn_;
    State state_;
    int tries_ = 0;
};

}  // namespace steplab
