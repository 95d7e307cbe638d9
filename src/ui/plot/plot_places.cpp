#include "ui/plot/plot_places.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

// Lengths in units of the layout.
constexpr float gap = 10;
constexpr float lowest = 140;
constexpr float tabs_height = 22;

/// So many plots in a row of an area, from edge to edge.
void add_row(std::vector<Area>& plots, const Area& row, std::size_t count, float between) {
    const auto parts = static_cast<float>(count);
    const float width = std::round((row.width - between * (parts + 1)) / parts);
    for (std::size_t i = 0; i < count; ++i)
        plots.push_back({row.x + between + static_cast<float>(i) * (width + between), row.y, width, row.height});
}

}  // namespace

PlotPlaces plot_places(const Area& area, std::size_t count, std::size_t columns, std::size_t first, float unit) {
    const float between = std::round(gap * unit);
    const auto rows_in = [&](float height) {
        return std::max<std::size_t>(1, static_cast<std::size_t>((height - between) / (lowest * unit + between)));
    };
    PlotPlaces places;
    Area room = area;
    if (count > columns * rows_in(area.height)) {
        places.tabs = {area.x + between, area.y + std::round(5 * unit), area.width - 2 * between,
                       std::round(tabs_height * unit)};
        room = {area.x, places.tabs.bottom() - std::round(4 * unit), area.width, 0};
        room.height = area.bottom() - room.y;
    }
    const std::size_t shown = std::min(count, columns * rows_in(room.height));
    places.first = std::min(first, count - shown);
    const std::size_t rows = (shown + columns - 1) / std::max<std::size_t>(1, columns);
    const float height = std::round((room.height - between * static_cast<float>(rows + 1)) / static_cast<float>(rows));
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t in_row = (shown - places.plots.size()) / (rows - row);
        const float y = room.y + between + static_cast<float>(row) * (height + between);
        add_row(places.plots, {room.x, y, room.width, height}, in_row, between);
    }
    return places;
}

}  // namespace steplab::ui
