#pragma once

#include "io/scene_problems.hpp"
#include "io/scene_reader.hpp"
#include "models/scene/scene.hpp"
#include "models/scene/scene_particles.hpp"

namespace steplab {

// What is wrong with the blocks of a scene file together, each at the key or the name that is wrong: `table` is that of
// the block. All of it is added to the problems.

/// A block of particles that has the name of an earlier one; names of groups that there are not, whatever is wrong with
/// the blocks of these groups.
void check_groups(const toml::table& root, SceneProblems& problems);

void check_names(const toml::table& table, const SceneParticles& particles, SceneProblems& problems);
void check_springs(const toml::table& table, const SpringTerm& term, const SceneParticles& particles,
                   SceneProblems& problems);
void check_pairs(const toml::table& table, const PairTerm& term, Vec3 box, const SceneParticles& particles,
                 SceneProblems& problems);

/// More particles than any method can run in the memory there was.
void check_memory(const std::vector<const toml::table*>& blocks, const Scene& scene, const SceneReading& how);

}  // namespace steplab
