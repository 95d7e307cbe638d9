#include "models/scene/finite_start.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/potentials/list.hpp"
#include "models/scene/composer.hpp"
#include "models/scene/potential_expression.hpp"
#include "models/scene/spring_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab {

namespace {

std::vector<IndexRange> ranges_named(const std::vector<std::string>& names, const SceneParticles& particles) {
    std::vector<IndexRange> ranges;
    ranges.reserve(names.size() + 1);
    for (const std::string& name : names) ranges.push_back(particles.named(name));
    if (ranges.empty()) ranges.push_back({0, particles.count()});
    return ranges;
}

Vec3 start_of(const SceneParticle& particle) { return particle.position + particle.displacement; }

/// Of each set of a pair force: asked for each run of an ensemble, 10 000 pairs take a millisecond.
constexpr std::size_t most_asked = 100;

/// A pair potential that is asked at single distances.
class AskedPotential {
public:
    AskedPotential(const PairTerm& term, Vec3 box) : potential_(pair_force_of(term, 1), 1) {
        space_.box = box;
        if (term.cutoff) cutoff_ = term.cutoff->value;
    }

    double cutoff() const { return cutoff_; }
    bool is_finite(double r, const SceneParticle& one, const SceneParticle& other) const {
        const PairProperties<double> pair{one.mass, other.mass, one.charge, other.charge};
        return std::isfinite(potential_.energy(r * r, pair) + potential_.factor(r * r, pair));
    }
    void check(std::size_t i, const SceneParticle& one, std::size_t j, const SceneParticle& other) const {
        const double r = length(space_.nearest(start_of(other) - start_of(one)));
        const bool acts = r > 0 && (cutoff_ == 0 || r < cutoff_) && !(one.fixed && other.fixed);
        if (acts && !is_finite(r, one, other))
            throw UsageError(fmt::format("the potential is not finite at r = {}, where particles {} and {} start",
                                         exact_text(r), i, j));
    }
    /// At the distances that any scene may have, from nuclei in metres to planets in millimetres.
    bool is_finite_somewhere(const SceneParticle& one, const SceneParticle& other) const {
        const double last = cutoff_ > 0 ? cutoff_ : 1e15;
        for (double r = cutoff_ > 0 ? 1e-9 * cutoff_ : 1e-18; r < last; r *= 1.5) {
            if (is_finite(r, one, other)) return true;
        }
        return false;
    }

private:
    PairPotential<double> potential_;
    Shape space_;
    double cutoff_ = 0;
};

}  // namespace

void check_finite(const FieldTerm& term, const SceneParticles& particles) {
    if (term.potential.empty()) return;
    const FieldPotential<double> potential(expression_of(term, 1).expression);
    for (const IndexRange range : ranges_named(term.particles, particles)) {
        for (std::size_t i = range.first; i < range.first + range.count; ++i) {
            const SceneParticle particle = particles[i];
            if (particle.fixed) continue;  // no field acts on it
            const Vec3 start = start_of(particle);
            const Vector<double> at{start.x, start.y, start.z};
            const Vector<double> force = potential.force(at, particle.mass, particle.charge);
            const double energy = potential.energy(at, particle.mass, particle.charge);
            if (!std::isfinite(energy + force.x + force.y + force.z))
                throw UsageError(fmt::format("the potential is not finite where particle {} starts, at ({}, {}, {})", i,
                                             exact_text(at.x), exact_text(at.y), exact_text(at.z)));
        }
    }
}

void check_finite(const SpringTerm& term, const SceneParticles& particles, Vec3 box) {
    if (!term.potential || built_in_potential(term.potential->potential)) return;
    const AskedPotential potential(*term.potential, box);
    std::size_t asked = 0;
    each_spring(particles, term, [&](const ScenePair& pair) {
        const auto [lower, upper] = std::minmax(pair.first, pair.second);
        const SceneParticle one = particles[lower], other = particles[upper];
        if (asked == 0 && !potential.is_finite_somewhere(one, other))
            throw UsageError("the potential is finite at no distance r");
        if (asked++ < most_asked * most_asked) potential.check(lower, one, upper, other);
    });
}

void check_finite(const PairTerm& term, const SceneParticles& particles, Vec3 box) {
    if (built_in_potential(term.potential)) return;
    const std::vector<IndexRange> ranges = ranges_named(term.between, particles);
    const IndexRange first = ranges.front(), second = ranges.back();
    const AskedPotential potential(term, box);
    const SceneParticle one = particles[first.first], other = particles[second.first + second.count - 1];
    if (potential.cutoff() > 0 && !potential.is_finite(potential.cutoff(), one, other))
        throw UsageError(
            fmt::format("the potential is not finite at its cutoff, r = {}", exact_text(potential.cutoff())));
    if (!potential.is_finite_somewhere(one, other)) throw UsageError("the potential is finite at no distance r");
    const std::size_t step = std::max<std::size_t>(1, first.count / most_asked),
                      other_step = std::max<std::size_t>(1, second.count / most_asked);
    for (std::size_t i = first.first; i < first.first + first.count; i += step) {
        const SceneParticle here = particles[i];
        for (std::size_t j = second.first; j < second.first + second.count; j += other_step) {
            if (i != j) potential.check(i, here, j, particles[j]);
        }
        // neighbours in the order of the scene are mostly those in space
        const std::size_t next = i + 1;
        if (next >= second.first && next < second.first + second.count) potential.check(i, here, next, particles[next]);
    }
}

}  // namespace steplab
