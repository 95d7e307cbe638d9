#include "sim/run/pair_law.hpp"

#include "models/forces/pair_potential.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <variant>

namespace steplab {

namespace {

/// What of a plan its pair forces are made of.
struct PairSource {
    double unit = 1;  ///< of mass
    std::vector<double> masses, charges;
    std::vector<ComposedPairs> pairs;
};

ComposedPairs morse_of(const PairForces& forces, double cutoff) {
    ComposedPairs pairs;
    pairs.potential = "morse";
    pairs.values = {forces.depth, forces.k, forces.r0};
    pairs.cutoff = cutoff;
    pairs.first.resize(forces.count);
    std::iota(pairs.first.begin(), pairs.first.end(), 0u);
    return pairs;
}

struct SourceOf {
    PairSource operator()(const PairForces& forces) const { return {forces.mass, {}, {}, {morse_of(forces, 0)}}; }
    PairSource operator()(const NearPairForces& forces) const {
        return {forces.mass, {}, {}, {morse_of(forces, forces.cutoff)}};
    }
    PairSource operator()(const ComposedForces& forces) const {
        return {forces.terms->mass, forces.terms->masses, forces.terms->charges, forces.terms->pairs};
    }
    template <class Other>
    PairSource operator()(const Other&) const {
        return {};
    }
};

std::uint32_t first_of(const ComposedPairs& pairs) {
    return pairs.listed.empty() ? pairs.first.front() : pairs.listed.front()[0];
}
std::uint32_t second_of(const ComposedPairs& pairs) {
    if (!pairs.listed.empty()) return pairs.listed.front()[1];
    return pairs.second.empty() ? pairs.first.at(1) : pairs.second.front();
}

/// Of the first pair of the force.
PairProperties<double> properties_of(const PairSource& source, const ComposedPairs& pairs) {
    const auto of = [](const std::vector<double>& values, std::uint32_t particle, double otherwise) {
        return values.empty() ? otherwise : values[particle];
    };
    const std::uint32_t first = first_of(pairs), second = second_of(pairs);
    return {of(source.masses, first, 1), of(source.masses, second, 1), of(source.charges, first, 0),
            of(source.charges, second, 0)};
}

std::string name_of(const ComposedPairs& pairs) {
    std::string name = pairs.potential.empty() ? "expression" : pairs.potential;
    if (!takes_properties(pairs)) return name;
    return fmt::format("{} of particles {} and {}", name, first_of(pairs), second_of(pairs));
}

/// Where a minimum below 0 shows what the force is like, around that; else over the distances that the scene has at its
/// start.
void find_range(PairLaw& law, double spacing, double farthest) {
    double well = 0, depth = 0;
    for (double r = 1e-2 * spacing; r < 1e2 * spacing; r *= 1.01) {
        if (const double energy = law.energy(r); energy < depth) {
            depth = energy;
            well = r;
        }
    }
    const bool has_well = well > 1.02e-2 * spacing && law.energy(0.97 * well) > depth;
    law.farthest = law.cutoff > 0 ? law.cutoff : has_well ? 4 * well : 1.2 * farthest;
    law.closest = 0.02 * law.farthest;
    if (!has_well) return;
    law.closest = well;
    while (law.closest > 0.02 * well && law.energy(law.closest) < -depth) law.closest *= 0.99;
}

PairLaw law_of(const PairSource& source, const ComposedPairs& pairs) {
    const auto potential = std::make_shared<const PairPotential<double>>(pairs, source.unit);
    const PairProperties<double> properties = properties_of(source, pairs);
    const auto within = [cutoff = pairs.cutoff](double r) { return cutoff <= 0 || r < cutoff; };
    PairLaw law;
    law.name = name_of(pairs);
    law.cutoff = pairs.cutoff;
    law.first = pairs.first;
    law.second = pairs.second;
    law.listed = pairs.listed;
    law.energy = [=, unit = source.unit](double r) {
        return within(r) ? unit * potential->energy(r * r, properties) : 0;
    };
    law.force = [=, unit = source.unit](double r) {
        return within(r) ? unit * r * potential->factor(r * r, properties) : 0;
    };
    return law;
}

/// Particles from everywhere in the scene, without the pattern of its rows.
std::vector<std::uint32_t> spread_over(std::span<const std::uint32_t> particles, std::size_t count) {
    constexpr double golden = 0.6180339887498949;
    std::vector<std::uint32_t> chosen;
    for (std::size_t k = 0; k < count; ++k) {
        const double part = std::fmod(static_cast<double>(k) * golden, 1.0);
        chosen.push_back(particles[static_cast<std::size_t>(part * static_cast<double>(particles.size()))]);
    }
    return chosen;
}

std::vector<double> thinned(std::vector<double> values, std::size_t most) {
    std::sort(values.begin(), values.end());
    if (values.size() <= most) return values;
    std::vector<double> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(values[i * values.size() / most]);
    return kept;
}

}  // namespace

std::vector<PairLaw> pair_laws(const RunDescription& description) {
    const Plan plan = plan_of(description);
    const PairSource source = std::visit(SourceOf(), plan.forces);
    const Shape shape = model_of(description).shape(description.scene);
    Frame start;
    start.shape = std::make_shared<const Shape>(shape);
    for (std::size_t i = 0; i < plan.reference.count; ++i)
        start.positions.push_back(plan.reference.at(i) + plan.start[i].displacement);
    std::vector<PairLaw> laws;
    for (const ComposedPairs& pairs : source.pairs) {
        if (pairs.first.size() < (pairs.second.empty() ? 2u : 1u)) continue;
        laws.push_back(law_of(source, pairs));
        const std::vector<double> distances = distances_now(laws.back(), start, 1000);
        find_range(laws.back(), shape.spacing, distances.empty() ? shape.spacing : distances.back());
    }
    return laws;
}

namespace {

constexpr std::size_t most_computed = 30'000;  // in about a millisecond

std::vector<double> listed_distances(const PairLaw& law, const Frame& frame) {
    const std::size_t step = law.listed.size() / most_computed + 1;
    std::vector<double> distances;
    for (std::size_t k = 0; k < law.listed.size(); k += step) {
        const auto [i, j] = law.listed[k];
        distances.push_back(length(frame.shape->nearest(frame.positions[j] - frame.positions[i])));
    }
    return distances;
}

}  // namespace

std::vector<double> distances_now(const PairLaw& law, const Frame& frame, std::size_t most) {
    if (!law.listed.empty()) return thinned(listed_distances(law, frame), most);
    const std::vector<std::uint32_t>& partners = law.second.empty() ? law.first : law.second;
    const std::size_t centres = std::min(law.first.size(), std::max<std::size_t>(1, most_computed / partners.size()));
    const bool all = centres == law.first.size();
    std::vector<double> distances;
    for (const std::uint32_t i : all ? law.first : spread_over(law.first, centres)) {
        for (const std::uint32_t j : partners) {
            if (i == j || (all && law.second.empty() && j < i)) continue;
            const double distance = length(frame.shape->nearest(frame.positions[j] - frame.positions[i]));
            if (law.cutoff <= 0 || distance < law.cutoff) distances.push_back(distance);
        }
    }
    return thinned(std::move(distances), most);
}

}  // namespace steplab
