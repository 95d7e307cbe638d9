#pragma once

#include <filesystem>
#include <string>

namespace steplab::docs {

/// For every file of results in the folder (scripts/benchmark.sh writes them): where it was measured, a table of
/// steplab beside the best peer of each row with the goal, and one beside LAMMPS. Throws std::runtime_error if a file
/// is none.
std::string speed_tables(const std::filesystem::path& folder);

}  // namespace steplab::docs
