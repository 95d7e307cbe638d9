#pragma once

#include "ui/context.hpp"
#include "ui/keys.hpp"

#include <string>

namespace steplab::ui {

/// Does what a key or its button asks for.
void perform(const Context& context, Action action);
/// Performs the actions whose keys were pressed in this frame, unless ImGui itself uses the keyboard.
void perform_pressed_keys(const Context& context);

/// "one step on (Right)": the tooltip of a button.
std::string help_of(Action action);

/// The camera goes to where the scene opens.
void reset_view(const Context& context);

}  // namespace steplab::ui
