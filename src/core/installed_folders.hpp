#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steplab {

/// Where data of this name lie that were installed with the file that holds this code, in order: beside a program in
/// bin/, a library in lib/ or a module in lib/steplab/, wherever these are; then beside the program that runs.
/// Independent of the working directory.
std::vector<std::filesystem::path> installed_folders(const std::string& name);

}  // namespace steplab
