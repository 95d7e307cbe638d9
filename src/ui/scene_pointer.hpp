#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// The mouse over the scene: orbit, pan, zoom to the pointer, pick and pull particles. Only what ImGui's own windows
/// leave to it.
void use_pointer(const Context& context);

}  // namespace steplab::ui
