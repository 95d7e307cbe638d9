#pragma once

#include <filesystem>
#include <string>

namespace steplab {

/// A page of docs/ as it came with the program, installed or in the source; empty if there is none.
std::filesystem::path page_file(const std::string& name);

/// Opens a file with the desktop's program for it. False if the desktop has no way to (xdg-open).
bool open_on_desktop(const std::filesystem::path& file);

}  // namespace steplab
