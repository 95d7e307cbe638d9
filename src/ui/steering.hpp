// The keyboard in place of the pointer: from widget to widget, from panel to panel.
#pragma once

#include "ui/context.hpp"

#include <string_view>

namespace steplab::ui {

/// The keyboard goes to the next panel that is shown, to the first one if it was in none.
void steer_on(const Context& context);
/// True if the keyboard is in the panel of this name.
bool is_steered(const Context& context, std::string_view panel);
/// Page up and down scroll the panel of this name, which is being drawn, if the keyboard is in it; or if it is in none
/// and `otherwise`.
void scroll_by_keys(const Context& context, std::string_view panel, bool otherwise);
/// A press of a button of the mouse takes the place of the keyboard. To be called before the panels are drawn.
void leave_to_pointer(const Context& context);
/// Frames the widget that the keyboard is at, over all else.
void draw_steering(const Context& context);

}  // namespace steplab::ui
