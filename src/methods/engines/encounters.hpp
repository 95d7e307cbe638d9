#pragma once

#include "core/field.hpp"
#include "core/number.hpp"
#include "core/own_stop.hpp"
#include "core/pair_range.hpp"
#include "core/vector.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/longest_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace steplab {

// The control of errors sees only what the stages of a step see. A force that is zero beyond a cut-off, or so weak from
// afar that nothing of it is seen, leaves steps free to grow until a whole encounter lies between two stages. A method
// that chooses its own steps therefore
//
//     h = longest_step(system, motion, h, tolerance)    takes no step that carries two particles deep into each other's
//                                                       reach from outside (PairRange of the models' own layouts,
//                                                       Approaches of composed scenes);
//     system.hold(x, v)                                 has no force jump inside a step;
//     crossing(system, from, to, h)                     ends a step where a pair crosses the cut-off.

/// The way of one particle relative to another in a step, from positions, velocities and accelerations at both ends:
/// d(s) = d + p_1 s + ... + p_5 s^5, s from 0 to 1.
template <class T>
class PairWay {
public:
    template <class System>
    PairWay(const System& system, const MotionOf<T>& from, const MotionOf<T>& to, T h, std::size_t i, std::size_t j)
        : d_(system.separation(from.x, i, j)) {
        const Vector<T> moved = difference_of(to.x, i, j) - difference_of(from.x, i, j);
        p1_ = h * difference_of(from.v, i, j);
        p2_ = (h * h / T(2)) * difference_of(from.a, i, j);
        const Vector<T> rest = moved - p1_ - p2_, slope = h * difference_of(to.v, i, j) - p1_ - T(2) * p2_,
                        bend = (h * h) * difference_of(to.a, i, j) - T(2) * p2_;
        p3_ = T(10) * rest - T(4) * slope + T(0.5) * bend;
        p4_ = T(7) * slope - T(15) * rest - bend;
        p5_ = T(6) * rest - T(3) * slope + T(0.5) * bend;
    }

    T distance2(T s) const {
        const Vector<T> d = at(s);
        return dot(d, d);
    }
    /// Half of its derivative.
    T slope(T s) const { return dot(at(s), rate(s)); }
    T distance() const { return size(d_); }
    /// Through each other and back again, as the force that jumps where they meet turns them round.
    bool goes_there_and_back() const {
        if (length() < distance() || !(dot(at(T(1)), d_) > T(0))) return false;
        for (int piece = 1; piece < pieces; ++piece) {
            if (dot(at(T(piece) / T(pieces)), d_) < T(0)) return true;
        }
        return false;
    }
    /// In which the way is looked at.
    static constexpr int pieces = 8;
    /// Not less than it moves.
    T length() const { return size(p1_) + size(p2_) + size(p3_) + size(p4_) + size(p5_); }
    /// What d(s) may be off in the middle: of a motion cos(omega t) with omega h below 6, more than that.
    T uncertainty() const { return size(p5_) / T(64); }

private:
    static T size(const Vector<T>& d) { return square_root(dot(d, d)); }
    Vector<T> at(T s) const { return d_ + s * (p1_ + s * (p2_ + s * (p3_ + s * (p4_ + s * p5_)))); }
    Vector<T> rate(T s) const {
        return p1_ + s * (T(2) * p2_ + s * (T(3) * p3_ + s * (T(4) * p4_ + s * (T(5) * p5_))));
    }

    Vector<T> d_, p1_, p2_, p3_, p4_, p5_;
};

/// Where in a step a pair that acts leaves the cut-off, or one that does not comes within it.
template <class T>
class Crossing {
public:
    Crossing(const PairWay<T>& way, bool acts, T cutoff)
        : way_(way), sign_(acts ? T(1) : T(-1)), cutoff_(cutoff), width_(cutoff_width(cutoff)) {}

    struct Found {
        T part = T(2);     ///< of the step: the pair is beyond the cut-off there, by less than its width; 2: nowhere
        bool sure = true;  ///< false: the way is too uncertain to say whether it crosses near there
    };
    Found first() const {
        if (way_.goes_there_and_back()) return {T(0.5), false};
        if (magnitude(way_.distance() - cutoff_) > way_.length() + way_.uncertainty() + width_) return {};
        for (int piece = 0; piece < PairWay<T>::pieces; ++piece) {
            const T begin = T(piece) / T(way_.pieces), end = T(piece + 1) / T(way_.pieces);
            if (beyond(end) > allowed()) return {place(begin, end), true};
            if (!(slope(begin) > T(0) && slope(end) < T(0))) continue;
            const T turn = turning(begin, end);
            if (beyond(turn) > allowed()) return {place(begin, turn), true};
            if (beyond(turn) > -uncertain()) return {turn, false};
        }
        return {};
    }

private:
    static constexpr int bisections = 60;

    /// Squares of distances, how far beyond the cut-off.
    T beyond(T s) const { return sign_ * (way_.distance2(s) - cutoff_ * cutoff_); }
    T slope(T s) const { return sign_ * way_.slope(s); }
    T allowed() const { return T(2) * cutoff_ * width_; }
    T uncertain() const { return way_.uncertainty() > width_ ? T(2) * cutoff_ * way_.uncertainty() : -allowed(); }

    /// Halfway through the width, so that the step that ends there crosses and goes no farther.
    T place(T before, T behind) const {
        const T begun = std::max(beyond(before), T(0)), aim = begun + (allowed() - begun) / T(2);
        for (int i = 0; i < bisections; ++i) {
            const T middle = before + (behind - before) / T(2);
            (beyond(middle) > aim ? behind : before) = middle;
        }
        return behind;
    }

    T turning(T before, T behind) const {
        for (int i = 0; i < bisections / 2; ++i) {
            const T middle = before + (behind - before) / T(2);
            (slope(middle) < T(0) ? behind : before) = middle;
        }
        return before;
    }

    const PairWay<T>& way_;
    T sign_, cutoff_, width_;
};

/// Where no step of a method from the positions x, the last of them tried with the length h, met its tolerance.
template <class System, class T>
OwnStop own_stop(const System& system, const Field<T>& x, double time, T h) {
    OwnStop stop{time, static_cast<double>(h)};
    T nearest2 = std::numeric_limits<T>::infinity();
    for (std::uint32_t i = 0; has_encounters(system) && i < x.count(); ++i) {
        for (std::uint32_t j = i + 1; j < x.count(); ++j) {
            const Vector<T> d = system.separation(x, i, j);
            if (!(dot(d, d) < nearest2)) continue;
            nearest2 = dot(d, d);
            stop.first = i;
            stop.second = j;
            stop.distance = static_cast<double>(square_root(nearest2));
        }
    }
    return stop;
}

/// Whether a pair crosses the cut-off in a step.
enum class Crosses { no, yes, perhaps };

/// The same for a step of length h between two motions of a system that holds the pairs at its beginning. Unless none
/// does, h becomes the length to try instead.
template <class System, class T>
Crosses crossing(const System& system, const MotionOf<T>& from, const MotionOf<T>& to, T& h) {
    if (system.held().empty()) return Crosses::no;
    typename Crossing<T>::Found first;
    system.each_held([&](std::size_t i, std::size_t j, T cutoff, bool acts) {
        const PairWay<T> way(system, from, to, h, i, j);
        const auto found = Crossing<T>(way, acts, cutoff).first();
        if (found.part < first.part) first = found;
    });
    if (first.part > T(1)) return Crosses::no;
    h *= first.sure ? first.part : T(0.5);
    return first.sure ? Crosses::yes : Crosses::perhaps;
}

/// The same for a trial step that ends at x and v. Costs an evaluation if pairs are held.
template <class System, class T>
bool crosses_on_the_way(System& system, const MotionOf<T>& from, const Field<T>& x, const Field<T>& v, T& h) {
    if (system.held().empty()) return false;
    Field<T> a(x.count());
    accelerate(system, x, v, a);
    return crossing(system, from, MotionOf<T>{x, v, a}, h) != Crosses::no;
}

/// How far a motion goes, `length` at most, until a pair crosses the cut-off, followed in pieces in which the way of
/// every pair is known from their ends: motion_at(t, motion) fills in positions, velocities and accelerations.
template <class System, class T, class F>
T length_until_crossing(const System& system, std::size_t count, T length, F motion_at) {
    Motion<T> begin(count), end(count);
    const auto refer = [](const Motion<T>& m) { return MotionOf<T>{m.x, m.v, m.a}; };
    motion_at(T(0), begin);
    T at = T(0), piece = length / T(8);
    for (bool cut = false; at < length;) {
        T h = std::min(piece, length - at);
        motion_at(at + h, end);
        const Crosses found = crossing(system, refer(begin), refer(end), h);
        if (found == Crosses::no) {
            at += h;
            if (cut) return at;
            std::swap(begin, end);
        } else {
            piece = h;
            cut = found == Crosses::yes;
        }
    }
    return length;
}

}  // namespace steplab
