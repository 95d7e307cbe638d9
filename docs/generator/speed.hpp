#pragma once

#include <filesystem>
#include <string>

namespace steplab::docs {

/// For every file of results in the folder (written by scripts/benchmark.sh): the machine, then tables of times against
/// peers with the goals, of ensembles, scaling, limits of the machine and times to an error. Throws std::runtime_error
/// if a file cannot be understood.
std::string speed_tables(const std::filesystem::path& folder);

}  // namespace steplab::docs
