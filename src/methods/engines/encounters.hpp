#pragma once

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/lanes.hpp"
#include "core/number.hpp"
#include "core/own_stop.hpp"
#include "core/pair_approach.hpp"
#include "core/pair_range.hpp"
#include "core/vector.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/collisions.hpp"

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
//     h = longest_step(system, x, v, h, tolerance)      takes no step that carries two particles deep into each other's
//                                                       reach from outside (PairRange of the models' own layouts,
//                                                       Approaches of composed scenes);
//     system.hold(x, v)                                 has no force jump inside a step;
//     crossing(system, from, to, h)                     ends a step where a pair crosses the cut-off.

/// Of the tolerance: what a force may do unseen, relative to the speeds that it changes.
inline constexpr double negligible_share = 1e-3;

/// Steps carry two particles that approach each other over this many lengths of the force at most: it grows by a factor
/// of e^2, which the stages see.
inline constexpr double lengths_per_step = 2;

/// From this distance on, two particles that approach change their velocities by less than a thousandth of the
/// tolerance in the time that they take for a length.
template <class T>
T distance_of_effect(const PairRange<T>& range, T tolerance) {
    return std::min(range.cutoff,
                    range.r0 + range.length * static_cast<T>(7 - std::log(static_cast<double>(tolerance))));
}

template <class T>
T dot(const Vector<T>& p, const Vector<T>& q) {
    return p.x * q.x + p.y * q.y + p.z * q.z;
}
template <class T>
Vector<T> difference_of(const Field<T>& field, std::size_t i, std::size_t j) {
    return {field.x()[j] - field.x()[i], field.y()[j] - field.y()[i], field.z()[j] - field.z()[i]};
}

/// The tolerance in a scene with pair forces: what an error of position matters goes with the length over which the
/// force changes. Not below what the precision holds.
template <class System, class Number>
Number tolerance_in(const System& system, Number tolerance) {
    double share = 1;
    if (const auto range = system.range()) share = static_cast<double>(range->length) / 8;
    const double negligible = negligible_share * static_cast<double>(tolerance);
    for (const auto& [table, strongest] : system.approaches().terms)
        share = std::min(share, table.length(strongest, negligible));
    const Number least = static_cast<Number>(2 * std::numeric_limits<decltype(system.dt())>::epsilon());
    return std::max(std::min(tolerance, least), tolerance * static_cast<Number>(std::min(1.0, share)));
}

/// How long a step of two particles may be at a distance: to where they begin to act on each other as they approach,
/// and some lengths on with all the speed that the potential can give them.
template <class T>
T time_to_act(const PairRange<T>& range, T effect, T distance, T speed) {
    const T way = std::max(distance - effect, T(0)), on = T(lengths_per_step) * range.length;
    const T depth = T(1) - exponential((range.r0 - distance) / range.length);
    return (way > T(0) ? way / speed : T(0)) + on / square_root(speed * speed + range.gain * depth * depth);
}

template <class System>
bool has_encounters(const System& system) {
    return system.range() || !system.approaches().terms.empty();
}

/// longest_step() by a PairRange.
template <class System, class T>
T longest_within(const System& system, const PairRange<T>& range, const Field<T>& x, const Field<T>& v, T h,
                 T tolerance) {
    const T effect = distance_of_effect(range, tolerance);
    const bool small = x.count() <= Coupling::most_held;
    T fastest2 = T(0);
    for (std::size_t i = 0; i < x.count(); ++i) {
        const Vector<T> own{v.x()[i], v.y()[i], v.z()[i]};
        fastest2 = std::max(fastest2, dot(own, own));
        for (std::size_t j = i + 1; small && j < x.count(); ++j) {
            const Vector<T> d = system.separation(x, i, j), w = difference_of(v, i, j);
            const T distance = square_root(dot(d, d));
            if (distance < effect || dot(d, w) < T(0))
                h = std::min(h, time_to_act(range, effect, distance, square_root(dot(w, w))));
        }
    }
    const T fastest = T(2) * square_root(fastest2);
    if (!small) h = std::min(h, time_to_act(range, effect, effect, fastest));
    // what comes near must be the image that was nearest where the step began
    return range.period > T(0) ? std::min(h, (range.period / T(2) - range.cutoff) / fastest) : h;
}

/// How long a step of many particles may be, by the fastest of them: as long as two of them take, from where a force is
/// no longer negligible, until it has grown; and no farther than the images stay those that were nearest.
template <class T>
double longest_of_many(const Approaches& approaches, const Field<T>& v, double h, double negligible) {
    if (!approaches.pairs.empty() && approaches.shortest_side == 0) return h;
    T fastest2 = T(0);
    for (std::size_t i = 0; i < v.count(); ++i) {
        const Vector<T> own{v.x()[i], v.y()[i], v.z()[i]};
        fastest2 = std::max(fastest2, dot(own, own));
    }
    const double speed2 = 4 * static_cast<double>(fastest2);
    for (const auto& [table, strongest] : approaches.terms) {
        if (approaches.shortest_side > 0 && table.cutoff() > 0) {
            const double side = approaches.shortest_side;
            h = std::min(h, std::max(side / 2 - table.cutoff(), side / 16) / std::sqrt(speed2));
        }
        if (!approaches.pairs.empty()) continue;
        const double distance = table.outermost(strongest, negligible * speed2);
        h = std::min(h, table.time_to_growth({distance, speed2, 0, strongest, negligible * speed2}, h));
    }
    return h;
}

/// Whether a step of length h moves a pair of an open space by this share of its distance, or half of it: of others
/// nothing need be asked. Pairs in rows, a register at a time.
template <class T>
bool moves_pairs(const Field<T>& x, const Field<T>& v, T h, T share) {
    using N = Lanes<T>;
    const FieldLanes<const T> places(x), velocities(v);
    const N moved(T(4) * h * h), near(share * share);
    const auto square = [](const Vector<N>& d) { return d.x * d.x + d.y * d.y + d.z * d.z; };
    N most(T(0));
    for (std::size_t i = 0; i + 1 < x.count(); ++i) {
        const Vector<N> at{N(x.x()[i]), N(x.y()[i]), N(x.z()[i])}, with{N(v.x()[i]), N(v.y()[i]), N(v.z()[i])};
        for (std::size_t r = (i + 1) / N::count; r * N::count < x.count(); ++r) {
            const N way2 = square(velocities.get(r) - with), distance2 = square(places.get(r) - at);
            const N beyond = where(N::first(x.count() - r * N::count), moved * way2 - near * distance2, N(T(0)));
            most = where(most < beyond, beyond, most);
        }
    }
    bool found = false;
    for (std::size_t lane = 0; lane < N::count; ++lane) found = found || most[lane] > T(0);
    return found;
}

/// longest_step() by Approaches.
template <class System, class T>
T longest_approach(const System& system, const Approaches& approaches, const Field<T>& x, const Field<T>& v, T h,
                   T tolerance) {
    auto longest = static_cast<double>(h);
    const double negligible = negligible_share * static_cast<double>(tolerance);
    if (approaches.shortest_side == 0 && !moves_pairs(x, v, h, static_cast<T>(approaches.least_way))) return h;
    for (const Approaches::Pair& pair : approaches.pairs) {
        const Vector<T> d = system.separation(x, pair.first, pair.second),
                        w = difference_of(v, pair.first, pair.second);
        const auto distance2 = static_cast<double>(dot(d, d)), speed2 = static_cast<double>(dot(w, w)),
                   inwards = static_cast<double>(-dot(d, w));
        const double share = approaches.terms[pair.term].table.least_way();
        if (!(inwards >= 0) || 4 * longest * longest * speed2 < share * share * distance2) continue;
        const ApproachTable::Pair now{.distance = std::sqrt(distance2),
                                      .speed2 = speed2,
                                      .momentum2 = std::max(distance2 * speed2 - inwards * inwards, 0.0),
                                      .strength = pair.strength,
                                      .negligible = negligible * speed2};
        longest = std::min(longest, approaches.terms[pair.term].table.time_to_growth(now, longest));
    }
    return static_cast<T>(std::min(longest, longest_of_many(approaches, v, longest, negligible)));
}

/// How long from now a bound is kept that holds for pieces of time; at least until `end`: infinity.
template <class Bound>
double kept_until(Bound bound, double limit, double end) {
    constexpr int most_pieces = 60;
    double safe = 0, piece = end;
    for (int i = 0; i < most_pieces && safe < end; ++i) {
        if (bound(safe, std::min(safe + piece, end)) <= limit) {
            safe += piece;
            piece *= 2;
        } else {
            piece /= 2;
            if (piece < safe / 8) break;
        }
    }
    return safe < end ? std::max(safe, piece) : std::numeric_limits<double>::infinity();
}

/// longest_step() where fields act that may be felt at some places alone: no farther than to where one does more than
/// it does now, as it changes now, and than a thousandth of the tolerance allows.
template <class System, class T>
T longest_to_fields(const System& system, const Field<T>& x, const Field<T>& v, T h, T tolerance) {
    auto longest = static_cast<double>(h);
    for (std::size_t i = 0; i < x.count(); ++i) {
        const auto bound = [&](double from, double to) { return system.field_bound(x, v, i, from, to); };
        const Vector<T> own{v.x()[i], v.y()[i], v.z()[i]};
        const double soon = longest * 0x1p-20, now = bound(0, 0), slope = (bound(soon, soon) - now) / soon,
                     negligible = negligible_share * static_cast<double>(tolerance) *
                                  std::sqrt(static_cast<double>(dot(own, own))) / longest,
                     limit = ApproachTable::growth * std::max(now + std::abs(slope) * longest, negligible);
        longest = std::min(longest, kept_until(bound, limit, longest));
    }
    return static_cast<T>(longest);
}

/// The length allowed of a step that would have the length h. In scenes of many particles, where all are among others,
/// the fastest motion decides.
template <class System, class T>
T longest_step(const System& system, const Field<T>& x, const Field<T>& v, T h, T tolerance) {
    if (const auto range = system.range()) return longest_within(system, *range, x, v, h, tolerance);
    const Approaches& approaches = system.approaches();
    if (!approaches.terms.empty()) h = longest_approach(system, approaches, x, v, h, tolerance);
    return system.has_local_fields() ? longest_to_fields(system, x, v, h, tolerance) : h;
}

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
