#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// A window over the scene that fits its content. It is open while this object lives.
class Card {
public:
    /// `anchor`: position of the point `pivot` of the card (0,0 top left .. 1,1 bottom right); `edge`: colour of the
    /// border.
    Card(const Context& context, const char* name, ImVec2 anchor, ImVec2 pivot, float width, ImU32 edge);
    ~Card();
    Card(const Card&) = delete;
    Card& operator=(const Card&) = delete;
};

/// The close button in the top right corner of the card; true when clicked.
bool close_cross(const Context& context, std::string_view widget);

/// The width of a card in pixels: `units` of the layout, or less if the scene is narrower.
float card_width(const Context& context, float units);

}  // namespace steplab::ui
