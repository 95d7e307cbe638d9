#pragma once
// How long a step may be that is not to carry a particle through an encounter unseen (encounters.hpp).

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/lanes.hpp"
#include "core/number.hpp"
#include "core/pair_approach.hpp"
#include "core/pair_range.hpp"
#include "core/vector.hpp"
#include "methods/engines/collisions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace steplab {

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

/// The same for power series, which passes of particles through each other cost ten times the tolerance.
template <class System>
double series_tolerance_in(const System& system, double tolerance) {
    const double here = tolerance_in(system, tolerance);
    return system.range() || here < tolerance ? here / 8 : here;
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

/// True in scenes of which parts may be felt at some places alone, at ends of which the stages tell nothing.
template <class System>
bool has_hidden_forces(const System& system) {
    return !system.approaches().terms.empty() || system.has_local_fields();
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
/// no longer negligible, until it has grown, or for a part of the narrowest stretch of the way in which it acts; and no
/// farther than the images stay those that were nearest.
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
        const ApproachTable::Pair pair{
            .distance = distance, .speed2 = speed2, .strength = strongest, .negligible = negligible * speed2};
        if (distance > 0) h = std::min(h, table.time_to_growth(pair, h));
        h = std::min(h, table.time_within_hidden(pair));
    }
    return h;
}

/// Whether a step of length h moves a pair of an open space by this share of its distance, or half of it: of others
/// nothing need be asked. Pairs in rows, a register at a time.
template <class T>
bool moves_pairs(const MotionOf<T>& now, T h, T share) {
    using N = Lanes<T>;
    const FieldLanes<const T> places(now.x), velocities(now.v), pulls(now.a);
    const N moved(T(4) * h * h), near(share * share), half(h / T(2));
    const auto square = [](const Vector<N>& d) { return d.x * d.x + d.y * d.y + d.z * d.z; };
    N most(T(0));
    const std::size_t count = now.x.count();
    const auto all = [](const Field<T>& field, std::size_t i) {
        return Vector<N>{N(field.x()[i]), N(field.y()[i]), N(field.z()[i])};
    };
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const Vector<N> at = all(now.x, i), with = all(now.v, i), pull = all(now.a, i);
        for (std::size_t r = (i + 1) / N::count; r * N::count < count; ++r) {
            const Vector<N> w = velocities.get(r) - with;
            const N slow2 = square(w), fast2 = square(w + half * (pulls.get(r) - pull)),
                    way2 = where(slow2 < fast2, fast2, slow2), distance2 = square(places.get(r) - at);
            const N beyond = where(N::first(count - r * N::count), moved * way2 - near * distance2, N(T(0)));
            most = where(most < beyond, beyond, most);
        }
    }
    bool found = false;
    for (std::size_t lane = 0; lane < N::count; ++lane) found = found || most[lane] > T(0);
    return found;
}

/// What tells an ApproachTable how a pair moves within a step of length h; none where that is no matter.
template <class System, class T>
std::optional<ApproachTable::Pair> moving_pair(const System& system, const Approaches::Pair& pair,
                                               const MotionOf<T>& now, double h, double share, double negligible) {
    const Vector<T> d = system.separation(now.x, pair.first, pair.second),
                    w = difference_of(now.v, pair.first, pair.second),
                    a = difference_of(now.a, pair.first, pair.second);
    const auto distance2 = static_cast<double>(dot(d, d)), speed2 = static_cast<double>(dot(w, w)),
               inwards = static_cast<double>(-dot(d, w)), pulled = static_cast<double>(-dot(d, a));
    const double soon2 = speed2 + h * (static_cast<double>(dot(w, a)) + h / 4 * static_cast<double>(dot(a, a)));
    const double way2 = h * h * std::max(speed2, soon2);
    if (4 * way2 < share * share * distance2) return std::nullopt;
    const double distance = std::sqrt(distance2);
    return ApproachTable::Pair{.distance = distance,
                               .speed2 = speed2,
                               .momentum2 = std::max(distance2 * speed2 - inwards * inwards, 0.0),
                               .pull = std::sqrt(static_cast<double>(dot(a, a))),
                               .strength = pair.strength,
                               .negligible = negligible * std::max(speed2, soon2),
                               .inwards = std::max(inwards, inwards + h * pulled) >= 0,
                               .outwards = std::min(inwards, inwards + h * pulled) < 0};
}

/// longest_step() by Approaches.
template <class System, class T>
T longest_approach(const System& system, const Approaches& approaches, const MotionOf<T>& now, T h, T tolerance) {
    auto longest = static_cast<double>(h);
    const double negligible = negligible_share * static_cast<double>(tolerance);
    const bool few = !approaches.pairs.empty(), open = approaches.shortest_side == 0;
    if (few && open && !moves_pairs(now, h, static_cast<T>(approaches.least_way))) return h;
    for (const Approaches::Pair& pair : approaches.pairs) {
        const ApproachTable& table = approaches.terms[pair.term].table;
        const auto moving = moving_pair(system, pair, now, longest, table.least_way(), negligible);
        if (moving && moving->inwards) longest = std::min(longest, table.time_to_growth(*moving, longest));
        if (moving && moving->outwards && table.grows_outwards())
            longest = std::min(longest, table.time_to_growth_outwards(*moving, longest));
        if (moving && table.has_hidden()) longest = std::min(longest, table.time_to_hidden(*moving));
    }
    return static_cast<T>(std::min(longest, longest_of_many(approaches, now.v, longest, negligible)));
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
T longest_to_fields(const System& system, const MotionOf<T>& now, T h, T tolerance) {
    auto longest = static_cast<double>(h);
    for (std::size_t i = 0; i < now.x.count(); ++i) {
        const auto bound = [&](double from, double to) { return system.field_bound(now.x, now.v, now.a, i, from, to); };
        const Vector<T> own{now.v.x()[i], now.v.y()[i], now.v.z()[i]}, pull{now.a.x()[i], now.a.y()[i], now.a.z()[i]};
        const double speed =
            std::sqrt(static_cast<double>(dot(own, own))) + longest * std::sqrt(static_cast<double>(dot(pull, pull)));
        const double soon = longest * 0x1p-20, here = bound(0, 0), slope = (bound(soon, soon) - here) / soon,
                     negligible = negligible_share * static_cast<double>(tolerance) * speed / longest,
                     limit = ApproachTable::growth * std::max(here + std::abs(slope) * longest, negligible);
        longest = std::min(longest, kept_until(bound, limit, longest));
    }
    return static_cast<T>(longest);
}

/// The length allowed of a step that would have the length h. In scenes of many particles, where all are among others,
/// the fastest motion decides. The accelerations are asked for where has_hidden_forces().
template <class System, class T>
T longest_step(const System& system, const MotionOf<T>& now, T h, T tolerance) {
    if (const auto range = system.range()) return longest_within(system, *range, now.x, now.v, h, tolerance);
    const Approaches& approaches = system.approaches();
    if (!approaches.terms.empty()) h = longest_approach(system, approaches, now, h, tolerance);
    return system.has_local_fields() ? longest_to_fields(system, now, h, tolerance) : h;
}

}  // namespace steplab
