#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// The mouse over the scene: orbit, pan, zoom towards the pointer, select and pull particles. Ignores the mouse over
/// ImGui's windows.
void use_pointer(const Context& context);

}  // namespace steplab::ui
