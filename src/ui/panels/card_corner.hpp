#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// A corner of the scene: a point near it, and the part of a card that lies there, (0, 0) top left to (1, 1).
struct CardCorner {
    ImVec2 anchor, pivot;
};
/// The corner in which the card of this name, of the size of its last frame, hides least of the particles that take
/// part in the oscillation of the frame and of the one that blew up first. It stays in the corner that it has where
/// another would show hardly more, and while the pointer is at it.
CardCorner card_corner(const Context& context, const char* card);

}  // namespace steplab::ui
