#pragma once

#include "models/scene/scene_particles.hpp"

namespace steplab {

/// Throws UsageError, naming the particle, if the potential of a field or its force is not finite where particles
/// start.
void check_finite(const FieldTerm& term, const SceneParticles& particles);

/// The same of a pair potential that is an expression: where pairs start, of many pairs a part of them, at its cut-off,
/// and whether there is any distance at which it is finite. In a box of these sides, 0: none.
void check_finite(const SpringTerm& term, const SceneParticles& particles, Vec3 box);
void check_finite(const PairTerm& term, const SceneParticles& particles, Vec3 box);

}  // namespace steplab
