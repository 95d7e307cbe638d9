#pragma once

#include "ui/context.hpp"
#include "ui/keys.hpp"

namespace steplab::ui {

/// The icons of the buttons, drawn as shapes: sharp at every scale and independent of fonts.
enum class Icon { restart, step_back, play, play_back, loop, pause, step_forward, menu, save };

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 ink);

/// How prominent a button is: the most used one, the others, and those that stand out only under the pointer.
enum class ButtonStyle { accent, plain, quiet };

/// A square button with an icon.
bool icon_button(const Context& context, std::string_view widget, Icon icon, std::string_view tooltip,
                 ButtonStyle style = ButtonStyle::plain, bool enabled = true);

}  // namespace steplab::ui
