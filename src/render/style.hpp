#pragma once

#include "core/appearance.hpp"
#include "core/particle_list.hpp"
#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::render {

using steplab::Background;
using steplab::background_ids;
using steplab::Colouring;
using steplab::colouring_ids;

/// How several runs of a scene are drawn: the others as ghosts around the leading one, or each in a tile of its own.
enum class RunLayout : std::uint8_t { ghosts, split };

inline constexpr std::array<std::string_view, 2> run_layout_ids = {"ghosts", "split"};
constexpr std::string_view id(RunLayout layout) { return run_layout_ids[static_cast<std::size_t>(layout)]; }

using Trails = std::vector<std::vector<Vec3>>;

/// Of displacements and of the distances between runs: beyond it a rounding error of double fills the scene.
inline constexpr double most_magnified = 1e15;

/// Options of drawing a scene.
struct Style {
    Colouring colouring = Colouring::role;
    /// Name of a column of ParticleValues: particles are coloured by it, not by `colouring`, in frames that have it.
    std::string column = {};
    Background background = Background::dark;
    bool springs = true;
    bool grid = true;                          ///< ground grid, axes with their numbers, and the small xyz cross
    bool legend = true;                        ///< for the colour scale, if there is one
    bool velocities = false;                   ///< as arrows
    bool forces = false;                       ///< as arrows, if the frame has them
    bool oscillation = false;                  ///< the fastest one, as arrows, if the frame has it
    std::optional<std::size_t> selected = {};  ///< particle to mark
    ParticleList selected_too = {};            ///< others to mark
    /// Where it and particles selected before have been, the newest place of each last; null: not drawn.
    std::shared_ptr<const Trails> trails = {};
    /// Factor by which displacements from the rest positions are drawn: what frames are asked to have as `magnified`.
    double displacements = 1;
    double mass = 1;  ///< of each particle; for its kinetic energy
    /// Value at the upper end of the colour scale; none: the next nice number above the largest value of the frame.
    std::optional<double> scale_maximum = {};
    RunLayout layout = RunLayout::ghosts;  ///< of runs beside the leading one, if there are any
    /// Factor by which ghosts are farther from the particles of the leading run than their runs say.
    double magnify = 1;
    /// Colour of moving particles that are coloured by role; 0: the usual one. Set where ghosts are beside them.
    std::size_t swatch = 0;
    double pixel_scale = 1;  ///< pixels per unit of the layout: scales text and lines
    /// Of particles that are but dots, a fair sample of about so many is drawn; 0: all of them.
    std::size_t most_dots = 0;
    /// The picture is shown so many times as wide as it is drawn. As many particles as pixels are left out of those
    /// that are but dots.
    int enlarged = 1;

    friend bool operator==(const Style&, const Style&) = default;
};

}  // namespace steplab::render
