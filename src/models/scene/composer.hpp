#pragma once

#include "models/forces/composition.hpp"
#include "models/scene/scene_particles.hpp"

#include <vector>

namespace steplab {

/// The forces of any scene, for the composed layout. Throws UsageError for an expression that is too long.
Composition composed(const Scene& scene, const SceneParticles& particles);

/// The force of a term without its particles. Masses and energies of an expression are in units of the mass `unit`.
/// Throws UsageError for an expression that is too long.
ComposedPairs pair_force_of(const PairTerm& term, double unit);

/// What acts against velocities.
struct SceneDamping {
    double drag = 0;            ///< rate gamma = c / m, where it is the same for all particles and nothing else damps
    std::vector<double> rates;  ///< else that of each particle
    double largest = 0;         ///< a bound of the rates at which motions are damped, dashpots included
    bool dashpots = false;

    /// Dashpots, or drag that differs between particles.
    bool is_of_each() const { return !rates.empty(); }
};
SceneDamping damping_of(const Scene& scene, const SceneParticles& particles);

}  // namespace steplab
