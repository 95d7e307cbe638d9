#include "models/chain_modes.hpp"
#include "sim/run/fixed_particles.hpp"
#include "sim/run/known_motion.hpp"
#include "sim/run/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace steplab {

namespace {

/// Up to here the modes take milliseconds.
constexpr std::size_t most_by_modes = 300;

bool has_linear_springs_alone(const Composition& terms) {
    return terms.pairs.empty() && terms.fields.empty() &&
           std::all_of(terms.springs.begin(), terms.springs.end(),
                       [](const auto& spring) { return spring.quadratic == 0 && spring.cubic == 0; });
}

/// A spring adds at most k |u_i - u_j|^2 <= 2 k (|u_i|^2 + |u_j|^2), and k |u_i|^2 where its other end is fixed.
double bound(const Composition& terms) {
    std::vector<double> stiffness(terms.count);
    const auto fixed = [&](std::size_t i) { return !terms.fixed.empty() && terms.fixed[i] != 0; };
    for (const ComposedSpring& spring : terms.springs) {
        const double share = fixed(spring.first) || fixed(spring.second) ? 1 : 2;
        stiffness[spring.first] += share * spring.k;
        stiffness[spring.second] += share * spring.k;
    }
    double largest = 0;
    for (std::size_t i = 0; i < terms.count; ++i) {
        const double mass = terms.mass * (terms.masses.empty() ? 1 : terms.masses[i]);
        if (!fixed(i)) largest = std::max(largest, stiffness[i] / mass);
    }
    return std::sqrt(largest);
}

struct Frequency {
    const Plan& plan;
    const Shape& shape;

    std::optional<KnownFrequency> operator()(const LineForces& line) const {
        return KnownFrequency{ChainModes{line.count, line.first_fixed, line.k / line.mass}.highest_frequency()};
    }
    /// Of the infinite grid, as the model mesh has it.
    std::optional<KnownFrequency> operator()(const GridForces& grid) const {
        return KnownFrequency{std::sqrt(8.0) * std::sqrt(grid.k / grid.mass), true};
    }
    std::optional<KnownFrequency> operator()(const ComposedForces& forces) const {
        if (!has_linear_springs_alone(*forces.terms)) return std::nullopt;
        if (forces.count > most_by_modes) return KnownFrequency{bound(*forces.terms), true};
        return KnownFrequency{highest_frequency(modes(LinearisedScene(plan, shape)))};
    }
    template <class Other>
    std::optional<KnownFrequency> operator()(const Other&) const {
        return std::nullopt;
    }
};

}  // namespace

std::optional<KnownFrequency> known_frequency(const Plan& plan, const Shape& shape) {
    return std::visit(Frequency{plan, shape}, plan.forces);
}

}  // namespace steplab
