#include "models/scene/composer.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "models/potentials/list.hpp"
#include "models/scene/potential_expression.hpp"
#include "models/scene/spring_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

std::vector<std::uint32_t> indices(IndexRange range) {
    std::vector<std::uint32_t> all(range.count);
    for (std::size_t i = 0; i < range.count; ++i) all[i] = static_cast<std::uint32_t>(range.first + i);
    return all;
}

ComposedPairs pairs_of(const PairTerm& term, const SceneParticles& particles) {
    ComposedPairs pairs = pair_force_of(term, particles[0].mass);
    const std::string first = term.between.empty() ? "all" : term.between.front();
    pairs.first = indices(particles.named(first));
    if (term.between.size() == 2 && term.between[1] != first) pairs.second = indices(particles.named(term.between[1]));
    return pairs;
}

/// Where springs hold particles near their positions, displacements are counted from these.
bool counts_from_positions(const Scene& scene) {
    return !scene.has_potentials() && !scene.springs.empty() && scene.box.value() == Vec3{};
}

ComposedSpring spring_of(const SpringTerm& term, const ScenePair& pair, const SceneParticles& particles, Vec3 box,
                         bool from_positions) {
    const auto nearest = [](double d, double period) {
        return period > 0 ? d - period * std::nearbyint(d / period) : d;
    };
    const Vec3 apart = particles[pair.second].position - particles[pair.first].position;
    const Vec3 rest{nearest(apart.x, box.x), nearest(apart.y, box.y), nearest(apart.z, box.z)};
    ComposedSpring spring{.first = static_cast<std::uint32_t>(pair.first),
                          .second = static_cast<std::uint32_t>(pair.second),
                          .length = term.length ? term.length->value : length(rest),
                          .k = term.k.value,
                          .quadratic = term.quadratic.value,
                          .cubic = term.cubic.value,
                          .damping = term.damping.value};
    if (from_positions) spring.rest = rest;
    const bool at_rest = from_positions && !term.length;  // exactly, whatever the root was rounded to
    spring.stretch = at_rest ? 0 : dot(spring.rest, spring.rest) - spring.length * spring.length;
    return spring;
}

/// The potential of a term of springs, and the pairs that these join.
ComposedPairs pairs_of(const SpringTerm& term, const SceneParticles& particles) {
    ComposedPairs pairs = pair_force_of(*term.potential, particles[0].mass);
    each_spring(particles, term, [&](const ScenePair& pair) {
        const auto [lower, upper] = std::minmax(pair.first, pair.second);
        pairs.listed.push_back({static_cast<std::uint32_t>(lower), static_cast<std::uint32_t>(upper)});
    });
    for (const auto& ends : pairs.listed) pairs.first.insert(pairs.first.end(), ends.begin(), ends.end());
    std::sort(pairs.first.begin(), pairs.first.end());
    pairs.first.erase(std::unique(pairs.first.begin(), pairs.first.end()), pairs.first.end());
    return pairs;
}

SpringTerm dashpots_of(SpringTerm term) {
    term.potential.reset();
    term.k = term.quadratic = term.cubic = 0;
    return term;
}

void add_springs(const Scene& scene, const SceneParticles& particles, Composition& composition) {
    for (const SpringTerm& term : scene.springs) {
        if (term.potential) composition.pairs.push_back(pairs_of(term, particles));
        if (term.potential && term.damping.value == 0) continue;
        const SpringTerm law = term.potential ? dashpots_of(term) : term;
        each_spring(particles, term, [&](const ScenePair& pair) {
            composition.springs.push_back(
                spring_of(law, pair, particles, composition.box, counts_from_positions(scene)));
        });
    }
}

/// Calls f(i) once for every particle of a field.
template <class F>
void each_particle(const FieldTerm& field, const SceneParticles& particles, F f) {
    std::vector<bool> taken(particles.count(), field.particles.empty());
    for (const std::string& name : field.particles) {
        const IndexRange range = particles.named(name);
        std::fill_n(taken.begin() + static_cast<std::ptrdiff_t>(range.first), range.count, true);
    }
    for (std::size_t i = 0; i < taken.size(); ++i) {
        if (taken[i]) f(i);
    }
}

/// One vector where all are equal, none where all are zero.
void add_gravity(const Scene& scene, const SceneParticles& particles, Composition& composition) {
    std::vector<Vec3> sum(particles.count());
    for (const FieldTerm& field : scene.fields) {
        if (!field.gravity) continue;
        each_particle(field, particles, [&](std::size_t i) { sum[i] = sum[i] + field.gravity->value(); });
    }
    const bool equal = std::all_of(sum.begin(), sum.end(), [&](Vec3 a) { return a == sum.front(); });
    if (equal) sum.resize(sum.front() == Vec3{} ? 0 : 1);
    composition.accelerations = std::move(sum);
}

void add_fields(const Scene& scene, const SceneParticles& particles, Composition& composition) {
    for (const FieldTerm& field : scene.fields) {
        if (field.potential.empty()) continue;
        ComposedField composed = expression_of(field, composition.mass);
        each_particle(field, particles, [&](std::size_t i) {
            if (!particles[i].fixed) composed.particles.push_back(static_cast<std::uint32_t>(i));
        });
        composition.fields.push_back(std::move(composed));
    }
}

void add_particles(const SceneParticles& particles, bool from_positions, Composition& composition) {
    composition.count = particles.count();
    composition.mass = particles[0].mass;
    bool equal = true, charged = false, held = false;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const SceneParticle particle = particles[i];
        composition.masses.push_back(particle.mass / composition.mass);
        composition.charges.push_back(particle.charge);
        composition.fixed.push_back(particle.fixed ? 1 : 0);
        if (from_positions) composition.reference.push_back(particle.position);
        equal = equal && particle.mass == composition.mass;
        charged = charged || particle.charge != 0;
        held = held || particle.fixed;
    }
    if (equal) composition.masses.clear();
    if (!charged) composition.charges.clear();
    if (!held) composition.fixed.clear();
}

}  // namespace

ComposedPairs pair_force_of(const PairTerm& term, double unit) {
    ComposedPairs pairs;
    if (const PotentialInfo* const named = built_in_potential(term.potential)) {
        pairs.potential = term.potential;
        for (const PotentialInfo::Parameter& parameter : named->parameters) {
            const auto given = term.values.find(std::string(parameter.name));
            pairs.values.push_back(given == term.values.end() ? 0 : given->second.value);
        }
    } else {
        pairs.expression = expression_of(term, unit);
    }
    if (term.cutoff) pairs.cutoff = term.cutoff->value;
    return pairs;
}

Composition composed(const Scene& scene, const SceneParticles& particles) {
    Composition composition;
    composition.box = scene.box.value();
    add_particles(particles, counts_from_positions(scene), composition);
    add_springs(scene, particles, composition);
    for (const PairTerm& term : scene.pairs) composition.pairs.push_back(pairs_of(term, particles));
    add_gravity(scene, particles, composition);
    add_fields(scene, particles, composition);
    return composition;
}

namespace {

/// A bound of the rates at which dashpots alone damp: of two particles c (1/m1 + 1/m2), within a long chain 4 c / m.
/// With the matrix of the forces in dashpots that their own motions make (Gershgorin), whose diagonal is that of two
/// particles, and in which two dashpots c and c' on one particle of mass m have at most sqrt(c c') / m in common.
double dashpot_rate(const Scene& scene, const SceneParticles& particles) {
    std::vector<double> roots(particles.count());  // sum of sqrt(c) over a particle's dashpots, divided by its mass
    const auto each = [&](auto f) {
        for (const SpringTerm& term : scene.springs) {
            if (term.damping.value == 0) continue;
            const double root = std::sqrt(term.damping.value);
            each_spring(particles, term, [&](const ScenePair& pair) { f(root, pair.first, pair.second); });
        }
    };
    each([&](double root, std::size_t first, std::size_t second) {
        for (const std::size_t i : {first, second}) {
            if (!particles[i].fixed) roots[i] += root / particles[i].mass;
        }
    });
    double largest = 0;
    each([&](double root, std::size_t first, std::size_t second) {
        largest = std::max(largest, root * (roots[first] + roots[second]));
    });
    return largest;
}

}  // namespace

SceneDamping damping_of(const Scene& scene, const SceneParticles& particles) {
    SceneDamping damping;
    std::vector<double> rates(particles.count());
    for (const FieldTerm& field : scene.fields) {
        if (!field.drag) continue;
        each_particle(field, particles, [&](std::size_t i) { rates[i] += field.drag->value / particles[i].mass; });
    }
    bool equal = true;
    double first = -1;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (particles[i].fixed) continue;
        if (first < 0) first = rates[i];
        equal = equal && rates[i] == first;
        damping.largest = std::max(damping.largest, rates[i]);
    }
    damping.dashpots = std::any_of(scene.springs.begin(), scene.springs.end(),
                                   [](const SpringTerm& term) { return term.damping.value != 0; });
    equal = equal && !damping.dashpots;
    if (damping.dashpots) damping.largest += dashpot_rate(scene, particles);
    if (equal) {
        damping.drag = std::max(first, 0.0);
    } else {
        damping.rates = std::move(rates);
    }
    return damping;
}

}  // namespace steplab
