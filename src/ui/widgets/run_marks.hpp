#pragma once

#include "render/style.hpp"

#include <imgui.h>

#include <cstddef>

namespace steplab::ui {

/// The colour of a run of the session, the leading one being number 0.
ImU32 run_ink(render::Background theme, std::size_t run);

/// A horizontal line in colour and style of a run: solid, dashed, dotted, dash-dotted, so that runs are told apart
/// without colours too. Pixels of the display.
void draw_run_line(ImDrawList& list, ImVec2 from, float width, std::size_t run, ImU32 ink, float thickness);

}  // namespace steplab::ui
