#pragma once

#include "plot/plot.hpp"

#include <span>
#include <vector>

namespace steplab::plot {

/// A corner of a plot's frame in which a card lies over the curves.
enum class Corner { top_right, top_left, bottom_right, bottom_left };

/// A card of this size in a corner; `above`: pixels below it that stay free at the foot of the frame.
Box card_in(const Box& frame, Corner corner, float width, float height, float above);

/// Pixels of a line from point to point that lie in a box.
float length_within(std::span<const Point> line, const Box& box);

/// The corner where a card of this size covers least of the lines; their highest peak, if there is one, counts as a
/// line around the card. It is the present one unless another covers less than half as much and is better by `worth`
/// pixels, or covers nothing while the present one hides the newest part of a line: a card makes way for a curve that
/// grows into it, but does not go to and fro while curves oscillate.
Corner free_corner(std::span<const std::vector<Point>> lines, const Box& frame, const Box& card, float above,
                   Corner present, float worth);

}  // namespace steplab::plot
