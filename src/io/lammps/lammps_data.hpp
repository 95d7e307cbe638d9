#pragma once

#include "io/lammps/lammps_scene.hpp"

#include <string>

namespace steplab {

/// "atomic", "charge", "bond" or "full": the least of LAMMPS' atom styles that the scene needs.
std::string atom_style(const LammpsScene& scene);

/// Writes particles, bonds and box as LAMMPS reads them. Every number reads back as the same. Throws FileError.
void write_lammps_data(const LammpsScene& scene, const std::string& title, const std::string& file);

}  // namespace steplab
