#include "core/entry.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "render/colouring.hpp"
#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

std::vector<ComboItem> colouring_items() {
    return {
        {.id = id(render::Colouring::role),
         .name = "role",
         .tooltip = "of the particle: moving, fixed, kicked or bullet"},
        {.id = id(render::Colouring::speed), .name = "speed [m/s]"},
        {.id = id(render::Colouring::kinetic_energy), .name = "kinetic energy [J]", .tooltip = "of each particle"},
        {.id = id(render::Colouring::displacement), .name = "displacement [m]", .tooltip = "from the rest position"},
        {.id = id(render::Colouring::strain),
         .name = "strain of the springs",
         .tooltip = "relative elongation: length / rest length - 1"},
        {.id = id(render::Colouring::group), .name = "group", .tooltip = "of particles in the scene's file"},
    };
}

/// The columns of the file that is played, behind the quantities that all frames have.
struct ColumnItems {
    std::vector<std::string> ids, names;

    explicit ColumnItems(const Frame& frame) {
        if (!frame.values) return;
        for (const ParticleValues& column : *frame.values) {
            ids.push_back(std::string(render::column_prefix) + column.name);
            names.push_back(shown(column.name));
        }
    }
    void append_to(std::vector<ComboItem>& items) const {
        for (std::size_t i = 0; i < ids.size(); ++i)
            items.push_back({.id = ids[i], .name = names[i], .tooltip = "a column of the file", .group = "columns"});
    }
    /// The number of the one that is shown among all items, of which so many come before these.
    std::size_t chosen(const Frame& frame, const render::Style& style, std::size_t before) const {
        const auto found = std::find(ids.begin(), ids.end(), render::colour_word(frame, style));
        return found == ids.end() ? static_cast<std::size_t>(style.colouring)
                                  : before + static_cast<std::size_t>(found - ids.begin());
    }
};

void draw_colouring(const Context& context, render::Style& style) {
    const RowPlaces places = row_places(context);
    row_label(context, "colour by", "quantity that the colours of the particles or springs show",
              ImGui::GetFrameHeight());
    ImGui::SameLine(places.control);
    auto items = colouring_items();
    const std::size_t quantities = items.size();
    const ColumnItems columns(context.view.frame);
    columns.append_to(items);
    std::size_t chosen = columns.chosen(context.view.frame, style, quantities);
    if (!combo(context, "colouring", items, chosen, places.right - places.control)) return;
    const bool is_column = chosen >= quantities;
    style.column = is_column ? (*context.view.frame.values)[chosen - quantities].name : "";
    if (!is_column) style.colouring = static_cast<render::Colouring>(chosen);
}

void draw_background(const Context& context, render::Style& style) {
    const RowPlaces places = row_places(context);
    row_label(context, "theme",
              "colours of the scene, the panels and saved pictures: dark for screens, light for print");
    ImGui::SameLine(places.control);
    auto chosen = static_cast<std::size_t>(style.background);
    if (segmented(context, "background", render::background_ids, chosen, places.right - places.control,
                  row_height(context))) {
        style.background = static_cast<render::Background>(chosen);
    }
}

void draw_following(const Context& context) {
    constexpr std::array<std::string_view, 3> choices{"nothing", "particle", "centre"};
    const RowPlaces places = row_places(context);
    row_label(context, "follow",
              "the camera goes with the selected particle, or with the centre of mass of all that are not fixed");
    ImGui::SameLine(places.control);
    auto chosen = static_cast<std::size_t>(context.state.following);
    if (segmented(context, "follow", choices, chosen, places.right - places.control, row_height(context)))
        context.state.following = static_cast<render::Following>(chosen);
}

constexpr ParameterInfo displacements_info{.name = "displacements",
                                           .unit = "",
                                           .minimum_included = false,
                                           .maximum = render::most_magnified,
                                           .default_value = 1,
                                           .what = "how many times as large as they are displacements are drawn"};

void draw_displacements(const Context& context, const render::Style& style) {
    slider_row(context,
               {.widget = "displacements",
                .label = "magnify",
                .tooltip = "how many times as large as they are displacements from the rest positions are "
                           "drawn: small motion is seen",
                .value_text = rounded_text(style.displacements),
                .entry_text = typed(style.displacements),
                .value = style.displacements,
                .default_value = 1,
                .range = {1, 1e6, true, false},
                .style = {},
                .set = [&](double value) { magnify(context, value); },
                .set_text = [&](std::string_view text) { magnify(context, parse_value(displacements_info, text)); }});
}

/// What is drawn: a row of the scene, a row of its motion.
void draw_parts(const Context& context, render::Style& style) {
    const float second = row_places(context).control;
    check_row(context, "springs", "springs", style.springs);
    tooltip(context, "draw the springs");
    ImGui::SameLine(second);
    check_row(context, "grid", "grid and axes", style.grid);
    tooltip(context, "draw the ground grid and the axes in metres");
    check_row(context, "trail", "trail", context.state.trail);
    tooltip(context, "draw where the selected particle has been; select others to see theirs too");
    ImGui::SameLine(second);
    check_row(context, "velocities", "velocities", style.velocities);
    tooltip(context, "draw the velocity of each particle as an arrow");
    if (context.session.playback && !context.session.playback->measured) return;
    ImGui::SameLine(second + context.px(104));
    if (check_row(context, "forces", "forces", style.forces)) context.events.send(event::ShowForces{style.forces});
    tooltip(context, "draw the force on each particle as an arrow, drag and damping included");
    if (context.session.playback) return;
    check_row(context, "oscillation", "fastest oscillation", context.state.oscillation);
    tooltip(context,
            "draw the fastest oscillation of the scene as it is now, which sets the stability limit: how far each "
            "particle moves in it");
}

}  // namespace

void draw_show_panel(const Context& context) {
    render::Style& style = context.stage.style;
    heading(context, "DISPLAY");
    draw_colouring(context, style);
    draw_background(context, style);
    draw_following(context);
    draw_displacements(context, style);
    draw_parts(context, style);
    if (!context.session.playback) draw_ensemble_rows(context);
}

}  // namespace steplab::ui
