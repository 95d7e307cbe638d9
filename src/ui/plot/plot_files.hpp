#pragma once

#include "ui/plot/plot.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace steplab::ui {

/// Writes the numbers of a plot beside the other files of the current folder and says where, or why it could not.
void save_table(const Context& context, const Plot& plot);
/// Asks the program for a picture of the part of the window the plot is in.
void save_picture(const Context& context, const Plot& plot, const Area& area);

/// The first of "steplab-NAME-1.END", "steplab-NAME-2.END" ... that does not exist in the folder: nothing is
/// overwritten.
std::string free_name(const std::filesystem::path& folder, std::string_view name, std::string_view end);

}  // namespace steplab::ui
