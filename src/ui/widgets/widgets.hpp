#pragma once

#include "ui/context.hpp"

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab::ui {

/// The columns of a row of the side panel, in pixels from the left edge of its window.
struct RowPlaces {
    float control = 0;  ///< where the slider, menu or switch begins
    float value = 0;    ///< where the value begins
    float right = 0;    ///< where the row ends
};
/// `value`: for which there has to be room, if it is longer than usual.
RowPlaces row_places(const Context& context, std::string_view value = {});
/// The height of a row with a slider or a switch.
float row_height(const Context& context);

/// The side of an item on which its tooltip is placed if there is room.
enum class Beside { below, right };
/// Shows `text` beside the last item while the pointer is over it, so that the item stays readable; nothing if it is
/// empty.
void tooltip(const Context& context, std::string_view text);
/// The same, and below it what the terms in `shown` mean, which the item shows: with_explanations().
void term_tooltip(const Context& context, std::string_view text, std::string_view shown);
/// The same as tooltip() beside a larger place that the last item belongs to.
void tooltip_beside(const Context& context, const WidgetRect& item, std::string_view text,
                    Beside first = Beside::below);
/// The same beside a place of the scene, while the pointer is there and over no panel.
void tooltip_in_scene(const Context& context, const WidgetRect& place, std::string_view text);
/// The top left corner of a box that lies on the display and beside an item: below or above, right or left of it, the
/// first of these with room. All lengths in pixels.
ImVec2 place_beside(const WidgetRect& item, ImVec2 size, ImVec2 display, float gap, Beside first);

/// In a menu that is open: closes it when Escape is pressed.
void close_if_asked(const Context& context);

/// Draws text that ends at `right` (pixels of the display), vertically centred at `y`.
void text_right(float right, float y, std::string_view text, ImU32 ink);
/// Draws text that begins at `left`, vertically centred at `y`.
void text_left(float left, float y, std::string_view text, ImU32 ink);

/// The heading of a section, "SCENE", with space above.
void heading(const Context& context, std::string_view text);
/// With line breaks in place of some of its separators, " · ", where it is wider than that in the present font.
std::string in_lines(const std::string& text, float width);
/// With line breaks in place of blanks where it is wider than that in the present font. ImGui would break numbers at
/// their decimal points, too.
std::string in_words(std::string_view text, float width);
/// The text, or as much of its beginning as has room before "…" in the present font.
std::string shortened(std::string_view text, float width);
/// The name on the tab that was made last, in its middle; that of a chosen one is underlined.
void draw_tab_name(const Context& context, std::string_view name, bool chosen);
/// A paragraph in the small font, wrapped at the edge of the panel.
void explanation(const Context& context, std::string_view text, ImU32 ink = colour::text_dim);
/// How many lines such a paragraph has.
int lines_of_explanation(const Context& context, std::string_view text);
/// A paragraph that changes while a run goes on: of at least so many lines, so that what is below stays where it is.
void changing_explanation(const Context& context, std::string_view text, int lines, ImU32 ink = colour::text_dim);
/// The largest font in which a text has room, or the smallest one.
ImFont* font_with_room(const Context& context, std::string_view text, float width);
/// The label of a row, vertically centred; `height` 0: that of a row with a slider.
void row_label(const Context& context, std::string_view label, std::string_view tooltip, float height = 0);
/// "kinetic          0.213 J"
void reading_row(const Context& context, std::string_view label, std::string_view value, std::string_view tooltip = {});

/// A check box with a label. True when clicked; `on` then has the new state. `mixed`: of what it stands for, some are
/// on and some are not; a click puts all on.
bool check_row(const Context& context, std::string_view widget, std::string_view label, bool& on, bool mixed = false);

/// A switch that shows all choices. True if another one was chosen. `help`: its tooltip, with the terms of the choices.
bool segmented(const Context& context, std::string_view widget, std::span<const std::string_view> choices,
               std::size_t& chosen, float width, float height, std::string_view help = {});

/// An item of a drop-down menu: its name and, dimmed at the right, a remark.
struct ComboItem {
    std::string_view id;  ///< also the name of its widget: "method/rk4"
    std::string_view name;
    std::string remark = {};
    std::string tooltip = {};
    std::string_view group = {};  ///< a heading above the first of successive items of a group
    std::string refusal = {};     ///< why it cannot be chosen: it is grey, and says so; empty: it can
};
/// A box that shows the chosen item and opens a menu of all items. True if another one was chosen.
bool combo(const Context& context, std::string_view widget, std::span<const ComboItem> items, std::size_t& chosen,
           float width);

/// The items of a menu that is open, as combo() draws them. The one that was clicked.
std::optional<std::size_t> item_list(const Context& context, std::string_view widget, std::span<const ComboItem> items,
                                     std::optional<std::size_t> shown);
/// The size of the menu that is opened next, which has them.
void size_item_list(const Context& context, std::span<const ComboItem> items, float least_width = 0);

/// A box like that of combo() for choices that are made elsewhere. True when clicked.
bool choice_box(const Context& context, std::string_view widget, std::string_view name, float width);

/// How ImGui carries the name of an OpenGL texture.
ImTextureID texture_id(std::uint32_t name);

/// A window without frame that fills an area, until the end of the block.
class StripWindow {
public:
    StripWindow(const Context& context, const char* name, const Area& area);
    ~StripWindow();
    StripWindow(const StripWindow&) = delete;
    StripWindow& operator=(const StripWindow&) = delete;
};

/// A cross that takes away what it stands beside. True when clicked.
bool cross_button(const Context& context, std::string_view widget);

/// A button with a text; `accent` highlights it.
bool text_button(const Context& context, std::string_view widget, std::string_view text, bool accent = false,
                 float width = 0);

}  // namespace steplab::ui
