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
//     h = guard.before(system, now, h, time)                   shortens a step on its way to a collision;
//     h = guard.behind(h)                                      shortens a step behind one;
//     if (guard.at_hand()) guard.cross(system, now, next, time)   takes the collision itself;
//     if (guard.passes(system, now, end, h)) ...               throws away a trial that straddles one, for the h given.
//
// where `now` and `next` hold fields x, v, a of one time, a the accelerations with drag. The steps end ever
// nearer before the collision, their ends predicted from x, v, a of their beginnings, until it is so near that one step
// of the velocity Verlet kind, whose two half kicks are weighted by the times before and after, takes the jump with an
// error below rounding. So near, positions hold half of the digits of the force's direction. A method that takes the
// force where its step begins carries the rest as far as the step goes: behind a collision its steps begin short.
//
// No two particles meet exactly in numbers. What counts is `turn`, the change of their relative velocity while the
// distance turns by a right angle: the force's size times miss over speed, which the step across leaves out.
//   - Below a tenth of the tolerance the step across is right within the tolerance, and is taken.
//   - Above it the force turns in a time that the control of errors sees: it goes through in short steps of its own.
//   - Either way a pass whose turn is below a millionth of the relative speed looks like a collision, and is
//     recorded: whether it was crossed depends on the tolerance, whether it happened does not.

/// When two particles will be abreast of each other, and how far apart: predicted from their present accelerations.
template <class T>
struct Meeting {
    T distance;      ///< now
    T time;          ///< from now; not above 0 where there will be none
    T miss;          ///< distance then
    T acceleration;  ///< of one relative to the other, now
    T speed;         ///< the same

    T turn() const { return miss * acceleration / speed; }
    /// In which the distance turns round.
    T turning_time() const { return closest() / speed; }
    T closest() const { return time > T(0) ? std::min(miss, distance) : distance; }

    /// A pass at a distance is smooth and left to the control of errors: one that misses by a tenth of the distance
    /// from which it was first seen, or whose turn matters.
    bool is_collision(T negligible_turn, T seen_from) const {
        if (!(distance > T(0) && time > T(0))) return false;
        return miss < T(0.1) * distance || (turn() < negligible_turn && miss < T(0.1) * seen_from);
    }
    /// Whether the pass looks like one through each other.
    bool is_seen_as_collision() const { return closest() * acceleration < T(1e-6) * speed * speed; }
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
    return {square_root(c), time, miss, square_root(dot(b, b)), square_root(dot(w, w))};
}

/// Positions, velocities and accelerations, drag included, of one time: as values, and as references.
template <class T>
struct Motion {
    Field<T> x, v, a;
    explicit Motion(std::size_t count) : x(count), v(count), a(count) {}
};
template <class T>
struct MotionOf {
    const Field<T>&x, &v, &a;
};

/// True if a pair passes, in the sense of System::passing_pairs.
template <class System, class T>
bool any_pass(const System& system, const Field<T>& from, const Field<T>& to) {
    bool found = false;
    system.passing_pairs(from, to, [&found](std::uint32_t, std::uint32_t) { found = true; });
    return found;
}

/// A step across a collision that happens `time` after `now`, and ends as long after it.
template <class T, class System, class Now, class Next>
void go_across(System& system, const Now& now, T time, Next& next) {
    const T whole = T(2) * time, drag = system.drag();
    const T *const x = now.x.flat().data(), *const v = now.v.flat().data(), *const a = now.a.flat().data();
    T *const next_x = next.x.flat().data(), *const next_v = next.v.flat().data(), *const next_a = next.a.flat().data();
    const std::size_t size = now.x.flat().size();
    elementwise(size, [=](std::size_t k) { next_x[k] = x[k] + whole * (v[k] + time * a[k]); });
    system.accelerations(next.x, next.a);
    elementwise(size, [=](std::size_t k) {
        const T at_collision = v[k] + time * a[k];
        next_a[k] = (next_a[k] - drag * at_collision) / (T(1) + drag * time);  // drag with the new velocity
        next_v[k] = at_collision + time * next_a[k];
    });
}

/// The motion at a time from `before` within the step across from `before` to `after`, on either side of the collision
/// with that side's own acceleration.
template <class T, class Now, class After>
void within_crossing(const Now& before, const After& after, T time_of_collision, T time, State<T>& out) {
    const bool behind = time > time_of_collision;
    const T from_there = behind ? time - T(2) * time_of_collision : time;
    out = behind ? State<T>{after.x, after.v} : State<T>{before.x, before.v};
    T *const x = out.displacement.flat().data(), *const v = out.velocity.flat().data();
    const T* const a = (behind ? after.a : before.a).flat().data();
    elementwise(out.displacement.flat().size(), [=](std::size_t k) {
        x[k] += from_there * (v[k] + from_there / T(2) * a[k]);
        v[k] += from_there * a[k];
    });
}

template <class T>
class CollisionGuard {
public:
    /// `tolerance`: of the errors of a step.
    explicit CollisionGuard(T tolerance)
        : negligible_turn_(std::max(tolerance / T(10), T(64) * std::numeric_limits<T>::epsilon())),
          growth_(std::max(T(10), tolerance / std::numeric_limits<T>::epsilon())) {}

    /// Trials of the last step have nothing to do with those of the next.
    void begin_step() { tries_ = 0; }

    /// The length allowed of a step that would have the length h and begins `start` after the segment's start. Where
    /// the pair turns out to pass at a distance, the next step is no longer than the turn: from there the control of
    /// errors sees it coming.
    template <class System, class Now>
    T before(const System& system, const Now& now, T h, double start) {
        begin_step();
        if (!approaching()) return h;
        const Meeting<T> next = meeting<T>(system, now, state_.first, state_.second);
        if (!next.is_collision(negligible_turn_, state_.distance) || next.time > state_.scale) {
            if (next.is_seen_as_collision()) add(start + static_cast<double>(next.time > T(0) ? next.time : T(0)));
            state_.scale = T(0);
            return std::min(h, next.turning_time());
        }
        state_.time = next.time;
        return std::min(h, reach());
    }

    /// The length allowed of a step that would have the length h. The direction of the force is wrong by a rounding of
    /// positions over the distance, which is as the time since the collision: that many times as long, what a step
    /// makes of it stays within the tolerance. Once for each step.
    T behind(T h) {
        const T allowed = behind_;
        behind_ = allowed < h ? growth_ * allowed : T(0);
        return allowed > T(0) ? std::min(h, allowed) : h;
    }

    /// True if a trial step of length h that ends at these positions carries particles through each other. Then h
    /// becomes the length to try instead.
    template <class System, class Now>
    bool passes(const System& system, const Now& now, const Field<T>& end, T& h) {
        Approach found;
        found.time = std::numeric_limits<T>::infinity();
        system.passing_pairs(now.x, end, [&](std::uint32_t first, std::uint32_t second) {
            const Meeting<T> next = meeting<T>(system, now, first, second);
            const T seen_from = is_approach_of(first, second) ? state_.distance : next.distance;
            const T time = next.time > T(0) ? std::min(next.time, h) : h;
            if ((!next.is_collision(negligible_turn_, seen_from) && next.time < h) || !(next.distance > T(0)) ||
                !(time < found.time))
                return;
            found = {std::min(h, longest_scale * time), time, seen_from, first, second};
        });
        if (!(found.time <= h)) return false;
        if (approaching()) found.scale = state_.scale;
        // a second trial that straddles shows that the prediction is late
        if (tries_++ > 0) found.time = std::min(found.time, h / T(2));
        state_ = found;
        h = reach();
        return true;
    }

    /// True on the way to a collision: steps are shorter than the control of errors would have them.
    bool approaching() const { return state_.scale > T(0); }
    /// When it will be, from the beginning of the step.
    T time() const { return state_.time; }
    /// True if the collision is so near that cross() may take it.
    bool at_hand() const { return approaching() && state_.time <= T(2) * nearest(); }
    /// Length of the step in which the collision was first seen: a good first guess behind it.
    T scale() const { return state_.scale; }

    /// Takes the step across: `next` gets x, v, a as long behind the collision as `now` is before it. Returns the time
    /// of the collision from now, half of the step; `now` is `start` after the segment's start.
    template <class System, class Now, class Next>
    T cross(System& system, const Now& now, Next& next, double start) {
        const T time = state_.time;
        go_across(system, now, time, next);
        system.passing_pairs(now.x, next.x, [&](std::uint32_t first, std::uint32_t second) {
            state_.first = first;
            state_.second = second;
            add(start + static_cast<double>(time));
        });
        state_.scale = T(0);
        behind_ = growth_ * time;
        return time;
    }

    const CollisionRecord& record() const { return record_; }

    /// The pair that a step is on its way to. Plain data.
    struct Approach {
        T scale = T(0);  ///< length of the step in which it was first seen; 0: none
        T time = T(0);
        T distance = T(0);  ///< from which it was first seen
        std::uint32_t first = 0, second = 0;
    };
    /// Part of an integrator's internal state. Plain data.
    struct State {
        Approach approach;
        T behind = T(0);
        CollisionRecord record;
        Collision last;
    };
    State state() const { return {state_, behind_, record_, last_}; }
    /// The rest of a method's internal state, with this state in it.
    template <class Progress>
    Progress saved_in(Progress progress) const {
        progress.guard = state();
        return progress;
    }
    void state(const State& saved) {
        state_ = saved.approach;
        behind_ = saved.behind;
        record_ = saved.record;
        last_ = saved.last;
    }

private:
    /// Of the time to the collision: a longer step, which free flight suggests, would miss what happens near it.
    static constexpr T longest_scale = T(1024);

    /// Half of the step that crosses: its error, of second order, is a sixteenth of the rounding unit relative to what
    /// happens in a step of length `scale`, and there the distance still has half of its digits.
    T nearest() const { return state_.scale * square_root(std::numeric_limits<T>::epsilon()) / T(4); }

    /// A step that ends before the collision by a margin in which its prediction and the positions of the method's last
    /// stages, both of higher order in the time left, are safe.
    T reach() const {
        const T share = std::min(T(1), state_.time / state_.scale) / T(10);
        return state_.time - std::max(nearest(), share * state_.time);
    }

    bool is_approach_of(std::uint32_t first, std::uint32_t second) const {
        return approaching() && state_.first == first && state_.second == second;
    }

    /// Records a collision of the pair, unless it is the one that was recorded last, seen again from nearer.
    void add(double time) {
        const Collision found{time, state_.first, state_.second};
        const bool known = record_.count() > 0 && found.first == last_.first && found.second == last_.second &&
                           std::abs(found.time - last_.time) < static_cast<double>(state_.scale);
        last_ = found;
        if (!known) record_.add(found);
    }

    T negligible_turn_;
    T growth_;  ///< of steps behind a collision
    Approach state_;
    T behind_ = T(0);  ///< the longest that the next step may be, because of a collision behind; 0: as long as it likes
    CollisionRecord record_;
    Collision last_;
    int tries_ = 0;
};

}  // namespace steplab
