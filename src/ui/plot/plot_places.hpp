#pragma once

#include "ui/widgets/layout.hpp"

#include <cstddef>
#include <vector>

namespace steplab::ui {

/// Where the chosen plots stand. Where not all of them have room, above them a line for tabs.
struct PlotPlaces {
    Area tabs;                ///< empty: all are shown
    std::size_t first = 0;    ///< number of the first one that is shown
    std::vector<Area> plots;  ///< of those that are shown
};

/// Places for `count` plots: `columns` next to each other at most, in as many rows as an area has the height for.
/// `first`: the one that is shown first where not all are; of those at the end, as many as there is room for.
/// `unit`: pixels per unit of the layout.
PlotPlaces plot_places(const Area& area, std::size_t count, std::size_t columns, std::size_t first, float unit);

}  // namespace steplab::ui
