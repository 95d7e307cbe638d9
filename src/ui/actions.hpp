#pragma once

#include "ui/context.hpp"
#include "ui/keys.hpp"

#include <string>

namespace steplab::ui {

/// Performs the action of a key or a button.
void perform(const Context& context, Action action);
/// Performs the actions whose keys were pressed in this frame, unless ImGui itself uses the keyboard.
void perform_pressed_keys(const Context& context);

/// The tooltip of a button: "one step forward (Right)".
std::string help_of(Action action);

/// Moves the camera to where it is when the scene opens.
void reset_view(const Context& context);

}  // namespace steplab::ui
