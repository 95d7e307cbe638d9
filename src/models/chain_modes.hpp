#pragma once

#include "models/model.hpp"

#include <memory>
#include <vector>

namespace steplab {

/// A line of equal masses and springs, its first particle fixed or not, its last one kicked along the line.
struct ChainModes {
    std::size_t count = 2;  ///< particles, a fixed one included
    bool first_fixed = true;
    long double k_over_m = 1;
    long double drag = 0;  ///< gamma = c / m

    /// Number of modes: moving particles.
    std::size_t modes() const { return first_fixed ? count - 1 : count; }
    /// Angular frequency of mode j = 1 .. modes(); mode 1 of a free chain is its translation, frequency 0.
    double frequency(std::size_t j) const;
    /// Product of the amplitudes of mode j at a particle and at the last particle, normalised over the moving
    /// particles.
    double shape(std::size_t j, std::size_t particle) const;
    double highest_frequency() const { return frequency(modes()); }
};

/// The longitudinal motion in closed form (docs/exact.md), valid while neighbours do not pass each other.
std::shared_ptr<const ExactSolution> chain_solution(const ChainModes& modes, double v0);

}  // namespace steplab
