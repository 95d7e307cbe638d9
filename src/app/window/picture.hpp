#pragma once

#include "render/camera.hpp"
#include "render/imgui_renderer.hpp"
#include "ui/display.hpp"

#include <string>

struct ImDrawData;

namespace steplab {

/// Writes the content of the window, or `part` of it if that is not empty, as a PNG. Throws FileError, GraphicsError.
void write_panels(const render::ImguiRenderer& renderer, const ImDrawData& data, render::PictureSize size,
                  const ui::PixelRect& part, const std::string& file);

}  // namespace steplab
