#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

#include <span>
#include <vector>

namespace steplab::ui {

/// What is written over the curves of a plot, on a card in the corner where it covers least of them: its title, if that
/// has no room above the frame, and for each of several curves a short line in its style and its name. `above`: pixels
/// at the foot of the frame that it leaves free.
void draw_legend(const Context& context, const plot::Plot& plot, const Area& frame,
                 std::span<const std::vector<plot::Point>> lines, float above, bool with_title);

}  // namespace steplab::ui
