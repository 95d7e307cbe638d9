#pragma once

#include "plot/free_corner.hpp"
#include "plot/plot.hpp"
#include "ui/plot/exact_curve.hpp"
#include "ui/plot/scene_laws.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::ui {

/// What a plot of the window shows.
enum class PlotKind {
    energy_error,
    energies,
    error,
    displacement,
    position,
    velocity,
    phase,
    spectrum,
    momentum,
    speeds,
    pairs,
    spread,
    costs,
    times
};

struct PlotKindInfo {
    PlotKind kind;
    std::string_view id;    ///< its widget, and in the names of its files
    std::string_view name;  ///< in the menu
    std::string_view what;
};
inline constexpr std::array plot_kinds{
    PlotKindInfo{PlotKind::energy_error, "energy error", "energy error",
                 "E - E0, signed, relative to E0: a method that keeps the energy wobbles, one that does not drifts"},
    PlotKindInfo{PlotKind::energies, "energies", "energies", "kinetic, potential and total energy"},
    PlotKindInfo{PlotKind::error, "position error", "position error",
                 "largest distance of a particle from the exact solution or the reference, for each run"},
    PlotKindInfo{PlotKind::displacement, "displacement", "displacement",
                 "of the selected particles, along the axis in which the first one moves most"},
    PlotKindInfo{PlotKind::position, "position", "position", "of the selected particles, along the same axis"},
    PlotKindInfo{PlotKind::velocity, "velocity", "velocity", "of the selected particles, along the same axis"},
    PlotKindInfo{PlotKind::phase, "phase portrait", "phase portrait",
                 "velocity of the selected particles over their displacements: a closed curve where nothing is lost"},
    PlotKindInfo{
        PlotKind::spectrum, "spectrum", "spectrum",
        "how strongly the selected particles vibrate at which frequency, beside the normal modes of the scene"},
    PlotKindInfo{PlotKind::momentum, "momentum", "momentum", "|P - P0| of all particles together"},
    PlotKindInfo{PlotKind::speeds, "speeds", "speeds", "how many particles have which speed now"},
    PlotKindInfo{PlotKind::pairs, "pair potential", "pair potential",
                 "potential and force between two particles over their distance, and the distances of pairs now"},
    PlotKindInfo{PlotKind::spread, "ensemble spread", "ensemble spread",
                 "largest distance of a particle of the ensemble from where it is in the run"},
    PlotKindInfo{PlotKind::costs, "speed against error", "speed against error",
                 "all methods on this scene: what error a number of force evaluations buys"},
    PlotKindInfo{
        PlotKind::times, "time against error", "time against error",
        "all methods on this scene: what error computing time buys, on this machine beside all else that runs"},
};

/// Its id as a word of a command line: "energy-error".
inline std::string plot_word(const PlotKindInfo& info) {
    std::string word(info.id);
    std::replace(word.begin(), word.end(), ' ', '-');
    return word;
}

/// Speed or time against error: what is scanned for them is the same.
constexpr bool shows_costs(PlotKind kind) { return kind == PlotKind::costs || kind == PlotKind::times; }

/// True if nothing of the scene but its particles is needed for it.
constexpr bool is_of_particles(PlotKind kind) {
    return kind == PlotKind::displacement || kind == PlotKind::position || kind == PlotKind::spectrum ||
           kind == PlotKind::velocity || kind == PlotKind::phase || kind == PlotKind::speeds;
}
constexpr bool shows_velocities(PlotKind kind) {
    return kind == PlotKind::velocity || kind == PlotKind::phase || kind == PlotKind::speeds;
}

/// The name of a kind.
const PlotKindInfo& info_of(PlotKind kind);

/// A plot that is shown.
struct PlotChoice {
    PlotKind kind = PlotKind::energy_error;
    plot::Scale scale = plot::Scale::linear;         ///< of the axis up
    plot::Scale across_scale = plot::Scale::linear;  ///< of the axis across
    std::optional<Range> up = {};                    ///< of the axis up, where it was moved; none: that of the data
    std::optional<Range> across = {};                ///< the same of the axis across, where that is not time

    /// True if both show the same, wherever their axes were moved.
    friend bool operator==(const PlotChoice& a, const PlotChoice& b) {
        return a.kind == b.kind && a.scale == b.scale && a.across_scale == b.across_scale;
    }
};

/// A plot of this kind with the scale that suits it: errors of methods differ by powers of ten.
inline PlotChoice default_choice(PlotKind kind) {
    const bool logarithmic = shows_costs(kind) || kind == PlotKind::error || kind == PlotKind::spectrum;
    const auto scale_if = [](bool log) { return log ? plot::Scale::logarithmic : plot::Scale::linear; };
    return {kind, scale_if(logarithmic), scale_if(shows_costs(kind))};
}

/// The plots below the scene.
/// A plot that is drawn on its own, for a picture of it.
struct PicturedPlot {
    std::string name = {};
    plot::Box area = {};
};

struct PlotsState {
    static constexpr std::size_t most = plot_kinds.size();

    std::vector<PlotChoice> shown{{PlotKind::energy_error}, {PlotKind::displacement}};
    std::size_t first = 0;             ///< the one that is shown first where not all have room
    std::optional<Range> window = {};  ///< of time, which all of them show; none: their own
    std::optional<bool> scanned = {};  ///< whether costs were asked for
    std::optional<bool> sampled = {};  ///< whether samples were asked for
    SceneLaws laws = {};
    std::array<ExactCurve, Sample::most_particles> exact = {};  ///< of tracked particles, in their order
    std::map<std::string, plot::Corner> legends = {};           ///< where they stand, by the plot's name
    std::optional<PicturedPlot> pictured = {};                  ///< drawn beyond the edge of the window, too
};

}  // namespace steplab::ui
