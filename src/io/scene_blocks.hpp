#pragma once

#include "io/particle_files.hpp"
#include "io/scene_parameters.hpp"
#include "models/scene/scene.hpp"

#include <string>
#include <vector>

namespace steplab {

// The blocks of a scene file, one by one, as they are written. They throw SceneProblem; whether what they name exists
// is a matter of all of them together (scene_reader.cpp).

ParticleBlock particle_block(const toml::table& table, SceneNumbers& numbers, ParticleFiles& files);
Fix fix_of(const toml::table& table, SceneNumbers& numbers);
SpringTerm spring_term(const toml::table& table, SceneNumbers& numbers);
PairTerm pair_term(const toml::table& table, SceneNumbers& numbers);
FieldTerm field_term(const toml::table& table, SceneNumbers& numbers);

Role role_at(const toml::node& node);
/// What the role of a fixed particle in a table means: it is fixed, unless the table says it is not.
bool fixed_by_role(const toml::table& table);

/// One text or a list of texts and whole numbers: names of particles.
std::vector<std::string> texts_of(const toml::node& node);

}  // namespace steplab
