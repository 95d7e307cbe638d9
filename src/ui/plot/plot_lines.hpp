#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

#include <imgui.h>

#include <vector>

namespace steplab::ui {

/// Pixels of a curve's line.
float thickness_of(const Context& context);
void draw_line(ImDrawList& list, const std::vector<ImVec2>& corners, plot::Line line, ImU32 ink, float thickness);
/// Dots at points.
void draw_marks(ImDrawList& list, const std::vector<ImVec2>& corners, ImU32 ink, float radius);
/// A translucent colour for what lies within a band.
ImU32 area_ink(const Context& context, const plot::Band& band);

}  // namespace steplab::ui
