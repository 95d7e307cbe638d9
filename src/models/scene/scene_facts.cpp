#include "models/scene/scene_facts.hpp"

#include "models/forces/pair_potential.hpp"
#include "models/scene/composer.hpp"
#include "models/scene/pair_well.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace steplab {

namespace {

/// A fixed particle is as one of infinite mass.
double inverse_mass(const SceneParticle& particle) { return particle.fixed ? 0 : 1 / particle.mass; }

/// The shortest bond, and the fastest swing of two particles on one of them alone; those of fixed ones do not count.
class Bonds {
public:
    void add(double length, double stiffness, double inverse_masses, double width = infinity) {
        if (inverse_masses == 0) return;
        narrowest_ = std::min(narrowest_, width);
        if (length > 0) shortest_ = std::min(shortest_, length);
        frequency_ = std::max(frequency_, std::sqrt(std::max(0.0, stiffness) * inverse_masses));
    }
    double shortest() const { return std::isinf(shortest_) ? 0 : shortest_; }
    double narrowest() const { return narrowest_; }
    double frequency() const { return frequency_; }

private:
    double narrowest_ = infinity;
    double shortest_ = std::numeric_limits<double>::infinity();
    double frequency_ = 0;
};

/// What rounding makes of two equal places is no bond.
double distance_of(Vec3 first, Vec3 second, const Shape& space) {
    const double distance = length(space.nearest(second - first));
    return distance > 1e-12 * (length(first) + length(second)) ? distance : 0;
}

/// Over which the force of a bond changes by a factor e, where that is known.
double bond_width(const PairTerm& term) {
    if (term.potential != "morse") return infinity;
    return std::sqrt(2 * term.values.at("D").value / term.values.at("k").value);
}

/// The wells of a potential along springs, each looked for once.
class SpringWells {
public:
    explicit SpringWells(const PairTerm& term) : term_(term), of_each_(takes_properties(pair_force_of(term, 1))) {}

    const std::optional<PairWell>& between(const SceneParticle& one, const SceneParticle& other) {
        const Key key = of_each_ ? Key{one.mass, other.mass, one.charge, other.charge} : Key{1, 1, 1, 1};
        const auto found = wells_.find(key);
        if (found != wells_.end()) return found->second;
        if (wells_.size() == most) return wells_.begin()->second;
        return wells_.emplace(key, pair_well(term_, {key[0], key[1], key[2], key[3]})).first->second;
    }

private:
    using Key = std::array<double, 4>;
    static constexpr std::size_t most = 100;  // of as many kinds

    const PairTerm& term_;
    bool of_each_;
    std::map<Key, std::optional<PairWell>> wells_;
};

void add_spring_wells(const SpringTerm& term, const SceneParticles& particles, Bonds& bonds) {
    SpringWells wells(*term.potential);
    each_spring(particles, term, [&](const ScenePair& pair) {
        const auto [lower, upper] = std::minmax(pair.first, pair.second);
        const SceneParticle one = particles[lower], other = particles[upper];
        if (const auto& well = wells.between(one, other))
            bonds.add(well->distance, well->stiffness, inverse_mass(one) + inverse_mass(other),
                      bond_width(*term.potential));
    });
}

void add_springs(const Scene& scene, const SceneParticles& particles, Bonds& bonds) {
    Shape space;
    space.box = scene.box.value();
    for (const SpringTerm& term : scene.springs) {
        if (term.potential) {
            add_spring_wells(term, particles, bonds);
            continue;
        }
        each_spring(particles, term, [&](const ScenePair& pair) {
            const SceneParticle first = particles[pair.first], second = particles[pair.second];
            const double length =
                term.length ? term.length->value : distance_of(first.position, second.position, space);
            bonds.add(length, term.k.value, inverse_mass(first) + inverse_mass(second));
        });
    }
}

/// Of the particles of one charge.
struct Lightest {
    double mass = std::numeric_limits<double>::infinity();
    double inverse = 0, next = 0;  ///< of the masses of the two lightest that move
};
using Charges = std::map<double, Lightest>;

/// Where there are more charges than in any salt, those of the first particles.
Charges charges_of(const SceneParticles& particles, IndexRange range) {
    constexpr std::size_t most = 8;
    Charges charges;
    for (std::size_t i = range.first; i < range.first + range.count; ++i) {
        const SceneParticle particle = particles[i];
        if (charges.size() == most && !charges.contains(particle.charge)) continue;
        Lightest& lightest = charges[particle.charge];
        lightest.mass = std::min(lightest.mass, particle.mass);
        const double inverse = inverse_mass(particle);
        lightest.next = std::max(lightest.next, std::min(lightest.inverse, inverse));
        lightest.inverse = std::max(lightest.inverse, inverse);
    }
    return charges;
}

void add_pairs(const PairTerm& term, const SceneParticles& particles, Bonds& bonds) {
    const std::string first = term.between.empty() ? "all" : term.between.front();
    const std::string second = term.between.size() == 2 ? term.between[1] : first;
    const IndexRange range = particles.named(first);
    if (range.count < 2 && second == first) return;
    const Charges some = charges_of(particles, range), others = charges_of(particles, particles.named(second));
    for (const auto& [charge, one] : some) {
        for (const auto& [other_charge, other] : others) {
            const auto well = pair_well(term, {one.mass, other.mass, charge, other_charge});
            const bool same = second == first && charge == other_charge;
            if (well)
                bonds.add(well->distance, well->stiffness, one.inverse + (same ? one.next : other.inverse),
                          bond_width(term));
        }
    }
}

}  // namespace

SceneFacts facts_of(const Scene& scene) {
    const SceneParticles particles(scene, SceneParticles::Ask::places);
    const SceneDamping damping = damping_of(scene, particles);
    Bonds bonds;
    add_springs(scene, particles, bonds);
    for (const PairTerm& term : scene.pairs) add_pairs(term, particles, bonds);
    return {.mass = common_mass(particles).value_or(0),
            .drag = damping.largest,
            .damping = damping.is_of_each(),
            .dashpots = damping.dashpots,
            .bond = bonds.shortest(),
            .bond_width = bonds.narrowest(),
            .pair_frequency = bonds.frequency(),
            .lists_pairs = std::any_of(scene.pairs.begin(), scene.pairs.end(),
                                       [](const PairTerm& term) { return term.cutoff.has_value(); })};
}

}  // namespace steplab
