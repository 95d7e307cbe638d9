#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace steplab {

/// Throws UsageError for a folder of which Slurm cannot write an output file, because of its full name.
void check_slurm_folder(const std::string& folder);

/// Writes the batch file for Slurm that runs LAMMPS in an exported folder on so many ranks, and returns its name.
/// Throws UsageError as check_slurm_folder() does, and FileError.
std::string write_slurm_file(const std::string& folder, std::string_view title, std::uint64_t ranks);

}  // namespace steplab
