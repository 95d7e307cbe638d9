#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

struct ColouringName {
    render::Colouring colouring;
    ComboItem item;
};

std::vector<ComboItem> colouring_items() {
    return {
        {.id = id(render::Colouring::role), .name = "role", .tooltip = "moving, fixed, kicked, bullet"},
        {.id = id(render::Colouring::speed), .name = "speed"},
        {.id = id(render::Colouring::kinetic_energy), .name = "kinetic energy"},
        {.id = id(render::Colouring::displacement), .name = "displacement"},
        {.id = id(render::Colouring::strain), .name = "strain of the springs"},
    };
}

void draw_colouring(const Context& context, render::Style& style) {
    const RowPlaces places = row_places(context);
    row_label(context, "colour by", "what the colours tell", ImGui::GetFrameHeight());
    ImGui::SameLine(places.control);
    const auto items = colouring_items();
    auto chosen = static_cast<std::size_t>(style.colouring);
    if (combo(context, "colouring", items, chosen, places.right - places.control)) {
        style.colouring = static_cast<render::Colouring>(chosen);
    }
}

void draw_background(const Context& context, render::Style& style) {
    const RowPlaces places = row_places(context);
    row_label(context, "background", {});
    ImGui::SameLine(places.control);
    auto chosen = static_cast<std::size_t>(style.background);
    if (segmented(context, "background", render::background_ids, chosen, places.right - places.control,
                  row_height(context))) {
        style.background = static_cast<render::Background>(chosen);
    }
}

}  // namespace

void draw_show_panel(const Context& context) {
    render::Style& style = context.stage.style;
    heading(context, "SHOW");
    draw_colouring(context, style);
    draw_background(context, style);
    check_row(context, "springs", "springs", style.springs);
    ImGui::SameLine(row_places(context).control);
    check_row(context, "grid", "grid and axes", style.grid);
    draw_ensemble_rows(context);
}

}  // namespace steplab::ui
