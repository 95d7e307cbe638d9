#pragma once

#include "io/lammps/lammps_scene.hpp"

#include <string>

namespace steplab {

/// What acts on particles from outside, as lines of an input script of LAMMPS: drag, accelerations and potentials.
/// Throws UsageError where there is more than LAMMPS has groups for.
std::string outside_lines(const LammpsScene& scene);
/// The potential energy of what such lines define, as a formula of LAMMPS.
std::string outside_energy(const std::string& lines);

}  // namespace steplab
