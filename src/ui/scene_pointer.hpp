#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// The mouse over the scene: orbit, pan, zoom to the pointer, pick. Only what ImGui's own windows leave to it.
void move_camera(const Context& context);

}  // namespace steplab::ui
