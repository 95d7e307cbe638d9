#pragma once

#include "ui/context.hpp"

namespace steplab::ui {

/// A window over the scene that sizes itself to what is in it; begin and end are the life of this object.
class Card {
public:
    /// `anchor`: the place of the card's point `pivot` (0,0 top left .. 1,1 bottom right). `edge` colours its border.
    Card(const Context& context, const char* name, ImVec2 anchor, ImVec2 pivot, float width, ImU32 edge);
    ~Card();
    Card(const Card&) = delete;
    Card& operator=(const Card&) = delete;
};

/// A small cross at the top right corner of the card; true when clicked.
bool close_cross(const Context& context, std::string_view widget);

/// The width of a card that is `units` wide where the scene has room for it.
float card_width(const Context& context, float units);

}  // namespace steplab::ui
