#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab {

/// Writes the batch file for Slurm that runs LAMMPS in an exported folder on so many ranks, and returns its name.
/// Throws FileError.
std::string write_slurm_file(const std::string& folder, std::string_view title, std::uint64_t ranks);

}  // namespace steplab
