#pragma once

#include "render/style.hpp"

#include <imgui.h>

#include <cstddef>
#include <span>

namespace steplab::ui {

/// The colour of a run of the session (RunView::swatch).
ImU32 run_ink(render::Background theme, std::size_t swatch);

/// A horizontal line in the style of a run (plot::line_of_run()). Pixels of the display.
void draw_run_line(ImDrawList& list, ImVec2 from, float width, std::size_t swatch, ImU32 ink, float thickness);

/// A line through these points in dashes and gaps of so many thicknesses in turn.
void draw_dashes(ImDrawList& list, std::span<const ImVec2> points, std::span<const float> dashes, ImU32 ink,
                 float thickness);

}  // namespace steplab::ui
