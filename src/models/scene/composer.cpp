#include "models/scene/composer.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
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
    const BuiltInPotential* const named = built_in_potential(term.potential);
    if (!named) throw UsageError("the potential of a pair force can only be a built-in one so far, not an expression");
    ComposedPairs pairs;
    pairs.potential = named->potential;
    for (const BuiltInPotential::Value& value : named->values) {
        if (const auto given = term.values.find(std::string(value.name)); given != term.values.end())
            pairs.*value.member = given->second.value;
    }
    if (term.cutoff) pairs.cutoff = term.cutoff->value;
    const std::string first = term.between.empty() ? "all" : term.between.front();
    pairs.first = indices(particles.named(first));
    if (term.between.size() == 2 && term.between[1] != first) pairs.second = indices(particles.named(term.between[1]));
    return pairs;
}

/// Where springs hold particles near their positions, displacements are counted from these.
bool counts_from_positions(const Scene& scene) {
    return scene.pairs.empty() && !scene.springs.empty() && scene.box.value() == Vec3{};
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
                          .cubic = term.cubic.value};
    if (from_positions) spring.rest = rest;
    const bool at_rest = from_positions && !term.length;  // exactly, whatever the root was rounded to
    spring.stretch = at_rest ? 0 : dot(spring.rest, spring.rest) - spring.length * spring.length;
    return spring;
}

void add_springs(const Scene& scene, const SceneParticles& particles, Composition& composition) {
    for (const SpringTerm& term : scene.springs) {
        if (term.damping.value != 0) throw UsageError("dashpots (damping of springs) cannot be stepped so far");
        each_spring(particles, term, [&](const ScenePair& pair) {
            composition.springs.push_back(
                spring_of(term, pair, particles, composition.box, counts_from_positions(scene)));
        });
    }
}

/// One vector where all are equal, none where all are zero.
void add_gravity(const Scene& scene, const SceneParticles& particles, Composition& composition) {
    std::vector<Vec3> sum(particles.count());
    for (const FieldTerm& field : scene.fields) {
        if (!field.potential.empty()) throw UsageError("the potential of a field cannot be stepped so far");
        if (!field.gravity) continue;
        const std::vector<std::string> all{"all"};
        for (const std::string& name : field.particles.empty() ? all : field.particles) {
            const IndexRange range = particles.named(name);
            for (std::size_t i = range.first; i < range.first + range.count; ++i)
                sum[i] = sum[i] + field.gravity->value();
        }
    }
    const bool equal = std::all_of(sum.begin(), sum.end(), [&](Vec3 a) { return a == sum.front(); });
    if (equal) sum.resize(sum.front() == Vec3{} ? 0 : 1);
    composition.accelerations = std::move(sum);
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
    if (!charged) composition.charges.assign(composition.charges.size(), 0.0);
    if (!held) composition.fixed.clear();
}

}  // namespace

const BuiltInPotential* built_in_potential(std::string_view name) {
    using Potential = ComposedPairs::Potential;
    static const std::array potentials{
        BuiltInPotential{"morse",
                         Potential::morse,
                         {{"D", &ComposedPairs::depth}, {"k", &ComposedPairs::k}, {"r0", &ComposedPairs::r0}}},
        BuiltInPotential{"lennard-jones",
                         Potential::lennard_jones,
                         {{"epsilon", &ComposedPairs::epsilon}, {"sigma", &ComposedPairs::sigma}}},
        BuiltInPotential{"gravity",
                         Potential::gravity,
                         {{"G", &ComposedPairs::strength}, {"softening", &ComposedPairs::softening, false}}},
        BuiltInPotential{"coulomb",
                         Potential::coulomb,
                         {{"K", &ComposedPairs::strength}, {"softening", &ComposedPairs::softening, false}}}};
    const auto found =
        std::find_if(potentials.begin(), potentials.end(), [&](const auto& p) { return p.name == name; });
    return found == potentials.end() ? nullptr : &*found;
}

Composition composed(const Scene& scene, const SceneParticles& particles) {
    Composition composition;
    composition.box = scene.box.value();
    add_particles(particles, counts_from_positions(scene), composition);
    add_springs(scene, particles, composition);
    for (const PairTerm& term : scene.pairs) composition.pairs.push_back(pairs_of(term, particles));
    add_gravity(scene, particles, composition);
    return composition;
}

double rate_of_drag(const Scene& scene, const SceneParticles& particles) {
    double drag = 0;
    for (const FieldTerm& field : scene.fields) {
        if (!field.drag || field.drag->value == 0) continue;
        std::size_t covered = 0;
        for (const std::string& name : field.particles) covered += particles.named(name).count;
        if (!field.particles.empty() && covered < particles.count())
            throw UsageError("drag on some of the particles only cannot be stepped so far");
        drag += field.drag->value;
    }
    for (std::size_t i = 1; i < particles.count() && drag > 0; ++i) {
        if (particles[i].mass != particles[0].mass)
            throw UsageError("drag on particles of different masses cannot be stepped so far");
    }
    return drag / particles[0].mass;
}

}  // namespace steplab
