#pragma once

#include "io/lammps/lammps_run.hpp"
#include "io/summary.hpp"
#include "sim/run/run_description.hpp"

#include <string>
#include <vector>

namespace steplab {

/// Writes the trajectory of a run of LAMMPS in a folder, up to a step, to a file of steplab, or to standard output (-).
/// Throws FileError.
void write_cluster_rows(const RunDescription& run, const std::string& folder, const RunResult& until,
                        const std::string& out);

/// A run of LAMMPS as one of steplab's. It diverged where steplab's own run would have been said to: at the first
/// energy that is no number or impossible (energy_is_possible()).
RunSummary cluster_summary(const RunDescription& run, std::uint64_t steps, std::size_t particles,
                           const std::vector<LammpsEnergy>& energies, double wall_seconds);

}  // namespace steplab
