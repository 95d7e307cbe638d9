#pragma once

#include "core/appearance.hpp"
#include "ui/plot/choice.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace steplab::ui {

/// Lengths that a drag changes, in units of the layout.
struct PanelSizes {
    static constexpr double least_width = 260, usual_width = 300, most_width = 520;
    static constexpr double least_height = 120, most_height = 800;

    double panel_width = usual_width;
    std::optional<double> plots_height = {};  ///< none: in proportion to the window
    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

/// What a picture or a film from the window shows.
struct PictureChoice {
    bool scene_alone = false;       ///< else the whole window
    bool caption = false;           ///< below it: scene, method, dt and time of every run
    std::string film = ".mp4";      ///< ending of the files of films
    std::string caption_text = {};  ///< of this window alone; empty: that of the runs
    friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};
inline constexpr std::array<std::string_view, 4> film_endings = {".mp4", ".webm", ".gif", ".png"};

/// What a person chose about the window and what it shows: kept from one window to the next.
struct ViewChoices {
    double scale = 1;  ///< of the interface, beside that of the display
    Background background = Background::dark;
    Colouring colouring = Colouring::role;
    bool springs = true;
    bool grid = true;
    bool trail = false;
    bool velocities = false;
    bool forces = false;
    std::optional<bool> panel = {};  ///< shown or not; none: where the window has room
    PanelSizes sizes = {};
    std::vector<PlotChoice> plots = PlotsState{}.shown;
    int width = 1280;  ///< of the window
    int height = 800;
    PictureChoice picture = {};
};

/// Scales of the interface that the keys go through.
inline constexpr std::array<double, 9> interface_scales = {0.75, 0.9, 1, 1.1, 1.25, 1.5, 1.75, 2, 2.5};

}  // namespace steplab::ui
