#pragma once

#include "ui/context.hpp"
#include "ui/keys.hpp"

namespace steplab::ui {

/// The signs on the buttons of the bar, drawn as shapes: sharp at every scale and in no need of a font.
enum class Icon { restart, step_back, play, pause, step_forward, menu, save };

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 ink);

/// How a button draws the eye: the one that is most used, the others, and those that only show when pointed at.
enum class ButtonStyle { accent, plain, quiet };

/// A square button with a sign.
bool icon_button(const Context& context, std::string_view widget, Icon icon, std::string_view tooltip,
                 ButtonStyle style = ButtonStyle::plain, bool enabled = true);

}  // namespace steplab::ui
