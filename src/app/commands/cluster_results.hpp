#pragma once

#include "io/lammps/lammps_export.hpp"
#include "io/lammps/lammps_output.hpp"
#include "io/summary.hpp"
#include "sim/run/run_description.hpp"

#include <string>
#include <vector>

namespace steplab {

/// Writes the trajectory of a run of LAMMPS in a folder, up to a step, to a file of steplab, or to standard output (-).
/// Throws FileError, also unless it has each moment of that time once.
void write_cluster_rows(const RunDescription& run, const LammpsTime& time, const std::string& folder,
                        const RunResult& until, const std::string& out);

/// What export_to_lammps() says of the files in a folder. Throws UsageError where they are not those of this run and
/// time, FileError where there are none.
LammpsExport check_is_export(const RunDescription& run, const LammpsTime& time, const std::string& folder);

/// A run of LAMMPS as one of steplab's. It diverged where steplab's own run would have been said to: at the first
/// energy that is no number or impossible (energy_is_possible()).
RunSummary cluster_summary(const RunDescription& run, std::uint64_t steps, std::size_t particles,
                           const std::vector<LammpsEnergy>& energies, double wall_seconds);

}  // namespace steplab
