#include "models/scene/plain_scene.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <variant>

namespace steplab::test {

PlainScene::PlainScene(const Scene& scene) : scene_(scene) {
    for (const ParticleBlock& block : scene.particles) {
        const auto& listed = std::get<ListedParticles>(block.arrangement);
        for (const ListedParticles::Particle& one : *listed.particles) {
            groups_[block.group].push_back(particles_.size());
            PlainParticle particle;
            particle.reference = particle.position = real(one.position);
            particle.velocity = real(one.velocity);
            particle.mass = one.mass;
            particles_.push_back(particle);
        }
    }
    for (const Fix& fix : scene.fixes) {
        PlainParticle& particle = particles_.at(std::stoul(fix.particles.at(0)));
        if (fix.displacement) particle.position = particle.reference + real(fix.displacement->value());
        if (fix.charge) particle.charge = fix.charge->value;
        if (fix.fixed) particle.fixed = *fix.fixed;
        if (particle.fixed) particle.velocity = {};
    }
}

std::vector<std::size_t> PlainScene::named(const std::string& name) const {
    if (name == "all") {
        std::vector<std::size_t> all(count());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }
    const auto group = groups_.find(name);
    return group == groups_.end() ? std::vector<std::size_t>{std::stoul(name)} : group->second;
}

Real3 PlainScene::nearest(Real3 d) const {
    const auto within = [](Real number, Real side) {
        return side > 0 ? number - side * std::round(number / side) : number;
    };
    const Vec3 box = scene_.box.value();
    return {within(d.x, box.x), within(d.y, box.y), within(d.z, box.z)};
}

namespace {

/// A pull of this strength along d (from i to j) on both ends.
void pull_both(PlainForces& sum, std::size_t i, std::size_t j, Real strength, Real size, Real3 d) {
    const Real3 force = (strength / length(d)) * d;
    sum.forces[i] = sum.forces[i] + force;
    sum.forces[j] = sum.forces[j] - force;
    sum.sizes[i] += size;
    sum.sizes[j] += size;
}

/// r |f'|: by how much a function changes where its argument changes by itself.
template <class F>
Real change(F f, Real r) {
    constexpr Real part = 1e-6L;
    return std::abs(f(r * (1 + part)) - f(r * (1 - part))) / (2 * part);
}

}  // namespace

void PlainScene::add_law(const SpringTerm& term, std::size_t i, std::size_t j, PlainForces& sum) const {
    const PlainParticle &a = particles_[i], &b = particles_[j];
    const Real rest = term.length ? Real(term.length->value) : length(nearest(b.reference - a.reference));
    const Real3 d = nearest(b.position - a.position);
    const Real r = length(d), e = r - rest, k = term.k.value, q = term.quadratic.value, c = term.cubic.value;
    const Real stiffness = k + 2 * std::abs(q * e) + 3 * std::abs(c) * e * e;
    pull_both(sum, i, j, k * e + q * e * e + c * e * e * e, stiffness * (r + rest), d);
    sum.energy += k * e * e / 2 + q * e * e * e / 3 + c * e * e * e * e / 4;
    sum.energy_size += std::abs(e) * stiffness * (r + rest);
}

void PlainScene::add_springs(const SpringTerm& term, PlainForces& sum) const {
    for (const auto& [first, second] : term.pairs) {
        const std::size_t i = named(first).front(), j = named(second).front();
        const PlainParticle &a = particles_[i], &b = particles_[j];
        if (a.fixed && b.fixed) continue;
        const Real3 d = nearest(b.position - a.position);
        const Real r = length(d);
        if (term.potential)
            add_pair(*term.potential, std::min(i, j), std::max(i, j), sum);
        else
            add_law(term, i, j, sum);
        const Real opening = dot(b.velocity - a.velocity, d) / r, damping = term.damping.value;
        pull_both(sum, i, j, damping * opening, damping * length(b.velocity - a.velocity), d);
    }
}

void PlainScene::add_pair(const PairTerm& term, std::size_t i, std::size_t j, PlainForces& sum) const {
    const PairFormula& formula = pair_formula(term.potential);
    PlainValues values = formula.values;
    for (const auto& [name, value] : term.values) values[name] = value.value;
    const Real cutoff = term.cutoff ? Real(term.cutoff->value) : 0;
    const PlainParticle &a = particles_[i], &b = particles_[j];
    if (a.fixed && b.fixed) return;
    const Real3 d = nearest(b.position - a.position);
    const Real r = length(d);
    if (cutoff > 0 && r >= cutoff) return;
    const auto energy = [&](Real at) { return formula.energy(at, values, a, b); };
    const auto slope = [&](Real at) { return formula.slope(at, values, a, b); };
    const Real there = cutoff > 0 ? slope(cutoff) : 0, level = cutoff > 0 ? energy(cutoff) : 0;
    Real size = std::abs(slope(r)) + std::abs(there) + change(slope, r);
    if (formula.terms) size += formula.terms(r, values, a, b);
    pull_both(sum, i, j, slope(r) - there, size, d);
    sum.energy += energy(r) - level - (cutoff > 0 ? (r - cutoff) * there : 0);
    sum.energy_size += std::abs(energy(r)) + std::abs(level) + std::abs(there) * cutoff + change(energy, r);
}

void PlainScene::add_pairs(const PairTerm& term, PlainForces& sum) const {
    const std::string first = term.between.empty() ? "all" : term.between[0];
    const std::string second = term.between.size() < 2 ? first : term.between[1];
    for (const std::size_t i : named(first)) {
        for (const std::size_t j : named(second)) {
            if (first != second || j > i) add_pair(term, i, j, sum);
        }
    }
}

void PlainScene::add_field(const FieldTerm& term, PlainForces& sum) const {
    std::vector<std::size_t> taken;
    for (const std::string& name : term.particles) {
        const auto more = named(name);
        taken.insert(taken.end(), more.begin(), more.end());
    }
    if (term.particles.empty()) taken = named("all");
    for (const std::size_t i : taken) {
        const PlainParticle& one = particles_[i];
        if (one.fixed) continue;
        const auto add = [&](Real3 force, Real size) {
            sum.forces[i] = sum.forces[i] + force;
            sum.sizes[i] += size;
        };
        if (term.gravity) {
            const Real3 a = real(term.gravity->value());
            add(one.mass * a, one.mass * length(a));
            sum.energy -= one.mass * dot(a, one.position);
            sum.energy_size += one.mass * length(a) * length(one.position);
        }
        if (term.drag) add(-Real(term.drag->value) * one.velocity, term.drag->value * length(one.velocity));
        for (const FieldFormula& formula : field_formulas()) {
            if (formula.text != term.potential) continue;
            const Real3 slope = formula.slope(one.position, one.mass, one.charge);
            const Real farthest = 1 + length(one.position);
            // cancelling terms are of the size of the slope some way off
            add(Real(-1) * slope, 3 * farthest * farthest * farthest * (one.mass + std::abs(one.charge)));
            sum.energy += formula.energy(one.position, one.mass, one.charge);
            sum.energy_size += farthest * farthest * farthest * farthest * (one.mass + std::abs(one.charge));
        }
    }
}

PlainForces PlainScene::evaluated() const {
    PlainForces sum;
    sum.forces.resize(count());
    sum.sizes.resize(count());
    for (const SpringTerm& term : scene_.springs) add_springs(term, sum);
    for (const PairTerm& term : scene_.pairs) add_pairs(term, sum);
    for (const FieldTerm& term : scene_.fields) add_field(term, sum);
    for (std::size_t i = 0; i < count(); ++i) {
        if (particles_[i].fixed) sum.forces[i] = {};
    }
    return sum;
}

}  // namespace steplab::test
