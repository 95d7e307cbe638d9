// The caption of a picture: what it shows, in a strip below it.
#pragma once

#include "ui/caption_text.hpp"
#include "ui/context.hpp"

#include <string>
#include <vector>

namespace steplab::ui {

/// A line of a caption.
struct CaptionLine {
    std::string text;
    std::optional<std::size_t> swatch = {};  ///< of the run whose line is drawn before it
};
std::vector<CaptionLine> caption_lines(const Caption& caption, const SessionView& session);

/// The height of its strip in pixels: in a film the same for every picture.
float caption_height(const Theme& theme, const Caption& caption, const SessionView& session);

/// Draws it in its strip. Lines that are too wide are drawn smaller.
void draw_caption(const Context& context, const Caption& caption, const Area& strip);

}  // namespace steplab::ui
