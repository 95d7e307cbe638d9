#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace steplab::ui {

/// Writes the data of a plot to a new file in the current folder, and shows its name or the error.
void save_table(const Context& context, const plot::Plot& plot);
/// The same with its picture as SVG, which needs no window and no screen.
void save_drawing(const Context& context, const plot::Plot& plot);
/// Requests a picture of the plot alone.
void save_snapshot(const Context& context, const plot::Plot& plot);

/// The first of "steplab-NAME-1.END", "steplab-NAME-2.END" ... that does not exist in the folder, so that no file is
/// overwritten.
std::string free_name(const std::filesystem::path& folder, std::string_view name, std::string_view end);

}  // namespace steplab::ui
