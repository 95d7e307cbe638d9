#include "models/forces/composed_approaches.hpp"

#include "core/coupling.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/hidden_stretches.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/forces/pair_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {

namespace {

using Particles = ComposedParticles<double>;
using Properties = PairProperties<double>;
using Weight = PotentialInfo::Weight;

/// Least and largest of the particles' masses and charges.
struct Extremes {
    std::array<double, 2> masses{1, 1}, charges{0, 0};

    explicit Extremes(const Composition& of) {
        const auto of_all = [](const std::vector<double>& numbers, std::array<double, 2>& out) {
            if (numbers.empty()) return;
            const auto [least, largest] = std::minmax_element(numbers.begin(), numbers.end());
            out = {*least, *largest};
        };
        of_all(of.masses, masses);
        of_all(of.charges, charges);
    }
    double largest_charge() const { return std::max(std::abs(charges[0]), std::abs(charges[1])); }
};

/// One term: a table of its force, and how much a pair has of it.
class ApproachTerm {
public:
    ApproachTerm(const ComposedPairs& pairs, const Composition& of)
        : potential_(pairs, of.mass), sides_(pairs, of.count), extremes_(of) {
        if (pairs.expression) {
            expression_ = pairs.expression.get();
        } else {
            weight_ = built_in_potential(pairs.potential)->weight;
        }
    }

    ApproachTable table() const {
        const std::vector<Properties> all = properties();
        const auto force = [&](double r) {
            double largest = 0;
            for (const Properties& pair : all) {
                const double here = potential_.factor(r * r, pair) * r;
                if (!(std::abs(here) <= std::abs(largest))) largest = here;
            }
            return largest;
        };
        ApproachTable table(force, potential_.cutoff());
        if (expression_) table.add_hidden(hidden_stretches(*expression_, range(), potential_.cutoff()));
        return table;
    }

    /// 0: it does not act between them.
    double strength(const Particles& particles, std::size_t i, std::size_t j) const {
        if (!sides_.joins(i, j)) return 0;
        const auto inverse = [&](std::size_t k) { return particles.moves(k) ? particles.inverse_mass(k) : 0; };
        return weight(particles.mass(i), particles.mass(j), particles.charge(i), particles.charge(j)) *
               (inverse(i) + inverse(j));
    }
    double strongest() const {
        const double mass = weight_ == Weight::masses ? extremes_.masses[1] : extremes_.masses[0],
                     charge = extremes_.largest_charge();
        return weight(mass, mass, charge, charge) * 2 / mass;
    }

private:
    double weight(double first_mass, double second_mass, double first_charge, double second_charge) const {
        if (weight_ == Weight::masses) return first_mass * second_mass;
        if (weight_ == Weight::charges) return std::abs(first_charge * second_charge);
        return 1;
    }

    /// Those for which the table is made; of an expression that asks for them, the extremes.
    std::vector<Properties> properties() const {
        if (!takes_properties()) return {{1, 1, 1, 1}};
        std::vector<Properties> all;
        for (const double m : extremes_.masses)
            for (const double n : extremes_.masses)
                for (const double p : extremes_.charges)
                    for (const double q : extremes_.charges) all.push_back({m, n, p, q});
        return all;
    }

    bool takes_properties() const { return expression_ && expression_->takes_properties; }
    RangeOfPairs range() const {
        const Interval one(1.0);
        if (!takes_properties()) return {one, one, one, one};
        const Interval masses(extremes_.masses[0], extremes_.masses[1]),
            charges(extremes_.charges[0], extremes_.charges[1]);
        return {masses, masses, charges, charges};
    }

    PairPotential<double> potential_;
    PairSides sides_;
    Extremes extremes_;
    const ExpressionForce* expression_ = nullptr;  ///< none: built in
    Weight weight_ = Weight::none;
};

double shortest_side(Vec3 box) {
    double shortest = 0;
    for (const double side : {box.x, box.y, box.z}) {
        if (side > 0) shortest = shortest > 0 ? std::min(shortest, side) : side;
    }
    return shortest;
}

/// Calls f(i, j) for pairs among which are all that a term joins.
template <class F>
void each_pair(const ComposedPairs& pairs, std::size_t count, F f) {
    for (const auto& [i, j] : pairs.listed) f(i, j);
    if (!pairs.listed.empty()) return;
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) f(i, j);
    }
}

}  // namespace

Approaches approaches_of(const std::shared_ptr<const Composition>& of) {
    Approaches all;
    all.shortest_side = shortest_side(of->box);
    const Particles particles(of);
    for (std::uint32_t t = 0; t < of->pairs.size(); ++t) {
        const ApproachTerm term(of->pairs[t], *of);
        all.terms.push_back({term.table(), term.strongest()});
        all.least_way = std::min(all.least_way, all.terms.back().table.least_way());
        if (of->count > Coupling::most_held) continue;
        each_pair(of->pairs[t], of->count, [&](std::uint32_t i, std::uint32_t j) {
            const double strength = term.strength(particles, i, j);
            if (strength > 0) all.pairs.push_back({i, j, t, strength});
        });
    }
    return all;
}

}  // namespace steplab
