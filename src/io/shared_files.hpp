#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steplab {

/// Where files that come with the program lie, such as "scenes" or "pictures": the installed folder first, then that of
/// the source.
std::vector<std::filesystem::path> shared_folders(const std::string& name);

/// A file in the first of these folders that has it; empty if none has.
std::filesystem::path shared_file(const std::string& folder, const std::string& name);

/// The names, without ending, of the files with this ending in the first of these folders that has any, in order.
std::vector<std::string> shared_names(const std::string& folder, const std::string& ending);

}  // namespace steplab
