#pragma once
// How much the force of a pair changes as its particles approach: what tells a method that an encounter lies ahead,
// which the control of errors does not see from afar (methods/engines/encounters.hpp).

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace steplab {

/// Distances between two neighbouring ones of a table, at which a force does more than there.
struct HiddenStretch {
    double from = 0, to = 0;  ///< [m]
    double weight = 0;        ///< the largest |F| r between them
};

/// A pair force F(r) in steps of a 32nd of an octave of the distance, from 2^-64 m to 2^64 m. What is narrower than
/// that is not in it, but is added as hidden stretches.
class ApproachTable {
public:
    /// F: a function of r, divided by the unit of mass. `cutoff`: beyond it there is no force; 0: none.
    template <class Force>
    ApproachTable(Force force, double cutoff) : cutoff_(cutoff), weight_(nodes), pull_(nodes), next_(nodes) {
        std::vector<double> forces(nodes);
        for (std::size_t k = 0; k < nodes; ++k) forces[k] = force(distance(k));
        for (std::size_t k = 0; k + 1 < nodes; ++k) {
            const double r = distance(k), slope = (forces[k + 1] - forces[k]) / (distance(k + 1) - r);
            if (cutoff > 0 && !(r < cutoff)) continue;
            pull_[k] = number(std::abs(forces[k]) * r);
            weight_[k] = std::max(pull_[k], number(std::abs(slope) * r * r));
        }
        find_next();
        find_way_outwards();
    }

    /// From one step to the next, what a force does may grow by this factor.
    static constexpr double growth = 4;

    /// Calls f(from, to) for each step of the table.
    template <class F>
    static void each_step(F f) {
        for (std::size_t k = 0; k + 1 < nodes; ++k) f(distance(k), distance(k + 1));
    }
    void add_hidden(std::vector<HiddenStretch> hidden) {
        hidden_ = std::move(hidden);
        for (const HiddenStretch& stretch : hidden_) least_way_ = std::min(least_way_, eighth(stretch) / stretch.to);
    }
    /// Whether it has some.
    bool has_hidden() const { return !hidden_.empty(); }

    double cutoff() const { return cutoff_; }
    /// Of the distance, which two particles have to come nearer, or to move apart, at least before the force matters
    /// `growth` times as much.
    double least_way() const { return std::min(least_way_, least_way_outwards_); }
    /// Whether it does so anywhere where they move apart.
    bool grows_outwards() const { return least_way_outwards_ < never; }

    /// Two particles that move.
    struct Pair {
        double distance = 0, speed2 = 0;        ///< squared, relative to each other
        double momentum2 = 0;                   ///< |d x w|^2: what keeps them apart
        double pull = 0;                        ///< acceleration relative to each other now, of all forces
        double strength = 1;                    ///< their relative acceleration is this times F
        double negligible = 0;                  ///< a squared speed: what a force that does less can be overlooked
        bool inwards = true, outwards = false;  ///< whether they approach, or move apart, now or soon
    };

    /// After which time the force matters so many times as much as now, if all its work, and that of the others as they
    /// are now, goes into their approach; not within `longest`: infinity. What matters is |F| r or |F'| r^2, whichever
    /// is more.
    double time_to_growth(const Pair& pair, double longest) const {
        const std::size_t now = place(pair.distance);
        const double limit = growth * std::max(pair.strength * weight_[now], pair.negligible);
        // with the work of forces that do not matter yet they are hardly faster
        const double farthest = pair.distance - longest * (2 * std::sqrt(pair.speed2) + longest * pair.pull);
        const std::size_t last = farthest > 0 ? place(farthest) : 0;
        const bool matters = pair.strength * weight_[now] >= pair.negligible;
        for (std::size_t k = matters ? next_[now] + std::size_t{1} : now; k-- > last;) {
            if (pair.strength * weight_[k] >= limit) return meets(pair, k, limit) ? time_to(pair, k) : never;
        }
        return never;
    }

    /// The same of two particles that move apart, at all their speed: a force may be felt from a distance on.
    double time_to_growth_outwards(const Pair& pair, double longest) const {
        const std::size_t now = place(pair.distance);
        const double limit = growth * std::max(pair.strength * weight_[now], pair.negligible);
        const double speed = std::sqrt(pair.speed2), farthest = pair.distance + longest * (speed + longest * pair.pull);
        const std::size_t last = place(farthest);
        for (std::size_t k = now + 1; k <= last; ++k) {
            if (pair.strength * weight_[k] < limit) continue;
            return time_for(std::max(distance(k) - pair.distance, 0.0), speed, pair.pull);
        }
        return never;
    }

    /// After which time a pair is where the nearest hidden stretch begins, or has gone an eighth of it: there the force
    /// itself tells the rest. Infinity if none lies ahead.
    double time_to_hidden(const Pair& pair) const {
        double way = never;
        for (const HiddenStretch& stretch : hidden_) {
            if (pair.strength * stretch.weight < pair.negligible) continue;
            const double inwards = pair.distance - stretch.to, outwards = stretch.from - pair.distance;
            if ((inwards > 0 && !pair.inwards) || (outwards > 0 && !pair.outwards)) continue;
            way = std::min(way, std::max({inwards, outwards, eighth(stretch)}));
        }
        return way < never ? time_for(way, std::sqrt(pair.speed2), pair.pull) : never;
    }
    /// How long a pair that may be at any distance takes for an eighth of the narrowest hidden stretch.
    double time_within_hidden(const Pair& pair) const {
        const double way = hidden_way(pair.strength, pair.negligible);
        return way < never ? time_for(way, std::sqrt(pair.speed2), pair.pull) : never;
    }

    /// Where, from afar inwards, a force of this strength first matters more than `negligible`; 0: nowhere.
    double outermost(double strength, double negligible) const {
        for (std::size_t k = nodes - 1; k-- > 0;) {
            if (strength * weight_[k] > negligible) return distance(k);
        }
        return 0;
    }

    /// The length over which a force of this strength changes by a factor e, where from afar inwards it first matters
    /// more than `negligible`, or an eighth of a hidden stretch; infinity: nowhere.
    double length(double strength, double negligible) const {
        return std::min(hidden_way(strength, negligible), shown_length(strength, negligible));
    }

private:
    double shown_length(double strength, double negligible) const {
        const double outer = outermost(strength, negligible), here = weight_[place(outer)];
        for (std::size_t k = place(outer); outer > 0 && k-- > 0;) {
            if (weight_[k] >= e_squared * here) return (outer - distance(k)) / 2;
        }
        return never;
    }

    static constexpr double never = std::numeric_limits<double>::infinity();
    static constexpr int octaves = 64, bits_of_step = 52 - 5;  // 32 = 2^5 nodes from one power of two to the next
    static constexpr std::size_t nodes = std::size_t{2 * octaves} << 5;
    static constexpr std::uint64_t first = std::uint64_t{1023 - octaves} << 5;
    static constexpr double e_squared = 7.389;
    static constexpr double step = 1.0 / 32;  ///< not less than the step of ln r

    static double eighth(const HiddenStretch& stretch) { return (stretch.to - stretch.from) / 8; }
    /// Of the least stretch in which a force of this strength matters more than `negligible`.
    double hidden_way(double strength, double negligible) const {
        double way = never;
        for (const HiddenStretch& stretch : hidden_) {
            if (strength * stretch.weight >= negligible) way = std::min(way, eighth(stretch));
        }
        return way;
    }
    /// speed t + pull t^2 / 2 = way.
    static double time_for(double way, double speed, double pull) {
        return 2 * way / (speed + std::sqrt(speed * speed + 2 * pull * way));
    }

    /// Node k, by the leading bits of the number.
    static double distance(std::size_t k) { return std::bit_cast<double>((first + k) << bits_of_step); }
    static std::size_t place(double r) {
        if (!(r > distance(0))) return 0;
        return std::min<std::size_t>((std::bit_cast<std::uint64_t>(r) >> bits_of_step) - first, nodes - 1);
    }
    static double number(double value) { return value < never ? value : std::numeric_limits<double>::max(); }

    /// Of each node the next one inwards at which the force matters `growth` times as much, looked for as far as to a
    /// quarter of the distance; else what is left to be looked through.
    void find_next() {
        constexpr std::size_t far = 64;
        for (std::size_t k = 0; k < nodes; ++k) {
            const std::size_t end = k > far ? k - far : 0;
            std::size_t m = k;
            while (m > end && !(weight_[m - 1] > 0 && weight_[m - 1] >= growth * weight_[k])) --m;
            next_[k] = static_cast<std::uint16_t>(m > 0 ? m - 1 : 0);
            if (m > end && k + 1 < nodes)
                least_way_ = std::min(least_way_, (distance(k) - distance(m - 1)) / distance(k + 1));
        }
    }

    /// Whether they come as near as node k, if the force that is below `limit` until there draws them together.
    bool meets(const Pair& pair, std::size_t k, double limit) const {
        const double r = distance(k), steps = static_cast<double>(place(pair.distance) - k + 1);
        return pair.momentum2 < r * r * (pair.speed2 + 2 * (limit * step * steps + pair.pull * (pair.distance - r)));
    }

    double time_to(const Pair& pair, std::size_t last) const {
        const double own = pair.strength * pull_[place(pair.distance)] / pair.distance;
        const double others = std::max(pair.pull - own, 0.0);
        double time = 0, speed2 = pair.speed2, r = pair.distance;
        for (std::size_t k = place(pair.distance) + 1; k-- > last;) {
            const double next = std::min(distance(k), r);
            speed2 += 2 * (pair.strength * pull_[k] * step + others * (r - next));
            if (r > next && !(pair.momentum2 < next * next * speed2)) return never;
            if (r > next) time += (r - next) / std::sqrt(speed2);
            r = next;
        }
        return time;
    }

    /// The least way outwards from a node to one at which the force matters `growth` times as much; from where there is
    /// none to where it begins, too.
    void find_way_outwards() {
        double least = never;
        std::size_t low = nodes;  // the farthest node so far at which it matters least
        for (std::size_t k = 0; k < nodes; ++k) {
            if (low < nodes && weight_[k] > 0 && weight_[k] >= growth * weight_[low]) {
                least = std::min(least, (distance(k) - distance(low)) / distance(low + 1));
                low = k;
            } else if (low == nodes || weight_[k] <= weight_[low]) {
                low = k;
            }
        }
        least_way_outwards_ = least;
    }

    double cutoff_, least_way_ = 0.75, least_way_outwards_ = never;
    std::vector<double> weight_, pull_;
    std::vector<std::uint16_t> next_;
    std::vector<HiddenStretch> hidden_;
};

/// How the pairs of a scene act on each other at all distances.
struct Approaches {
    struct Term {
        ApproachTable table;
        double strongest = 1;  ///< of its pairs
    };
    struct Pair {
        std::uint32_t first = 0, second = 0, term = 0;
        double strength = 1;  ///< of its relative acceleration in units of the force of the table
    };
    std::vector<Term> terms;
    std::vector<Pair> pairs;   ///< of scenes of at most Coupling::most_held particles; else empty
    double least_way = 0.75;   ///< the least of all terms
    double shortest_side = 0;  ///< of space that repeats itself; 0: it does not
};

}  // namespace steplab
