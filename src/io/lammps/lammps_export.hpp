#pragma once

#include "sim/run/run_description.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace steplab {

/// What of the length of a run LAMMPS is told.
struct LammpsTime {
    std::uint64_t steps = 0;
    std::uint64_t every = 0;  ///< steps between two moments of the trajectory; 0: its start and its end
};

/// What was written, for people and for reading it back.
struct LammpsExport {
    std::size_t particles = 0;
    std::uint64_t bonds = 0;
    double table_error = 0;  ///< largest error of a force by table, in parts of it or of that below; 0: there is none
    double neighbour_force = 0, neighbour_acceleration = 0;  ///< the largest between neighbours, by table
    double reach = 0;                                        ///< the distance beyond which LAMMPS ends the run; 0: none
    std::vector<std::string> notes = {};                     ///< what is different there
};

/// The names of the files in the folder of an export, and of what LAMMPS writes beside them.
namespace lammps_files {
inline constexpr const char* data = "scene.data";
inline constexpr const char* input = "in.scene";
inline constexpr const char* script = "run.sh";
inline constexpr const char* tables = "scene.table";
inline constexpr const char* bond_tables = "bonds.table";
inline constexpr const char* trajectory = "trajectory.dump";
inline constexpr const char* log = "log.lammps";
inline constexpr const char* screen = "screen.lammps";  ///< what it prints
}  // namespace lammps_files

/// Writes the scene of a run, as the run starts it, for LAMMPS into a folder, which is made if it is missing:
/// particles, bonds and box as data, an input script that runs it by velocity Verlet, and a script that starts it on
/// several ranks. Beside the scene itself it needs the memory of a buffer. Throws UsageError for what LAMMPS has
/// nothing for, naming it, and FileError.
LammpsExport export_to_lammps(const RunDescription& run, const LammpsTime& time, const std::string& folder);

}  // namespace steplab
