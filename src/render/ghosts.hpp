#pragma once

#include "render/bounds.hpp"
#include "render/lines.hpp"
#include "render/occupancy.hpp"
#include "render/particle_arrays.hpp"
#include "render/particle_blocks.hpp"
#include "render/shot.hpp"
#include "render/shown_runs.hpp"
#include "render/springs.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steplab::render {

/// Where the particles of a run are drawn as ghosts around the leading run: the difference of the two, through the
/// sides of a periodic box where that is shorter, taken `magnify` times.
std::vector<Vec3> ghost_places(const Frame& leading, const Frame& follower, double magnify);

/// Draws the runs beside the leading one in its view: each particle as a translucent mark whose colour and outline say
/// which run it is of, with a thin line from its twin in the leading run; springs as thin rods. What is where the
/// leading run has it is left out, as it would be hidden there.
class Ghosts {
public:
    Ghosts();

    /// `shot`: of the leading run. Marks what ghosts cover in `taken`.
    void prepare(const Shot& shot, ShownRuns followers, Occupancy& taken);
    /// The box around all ghosts that can be drawn; none if there are none.
    const std::optional<Bounds>& bounds() const { return bounds_; }
    /// Springs and lines.
    void draw_lines(const ViewUniforms& view, const Style& style);
    /// The particles; blended, so to be drawn after everything opaque.
    void draw_particles(const ViewUniforms& view, double pixel_scale) const;

private:
    /// One follower.
    struct Ghost {
        Frame frame;  ///< as drawn
        std::size_t swatch = 1;
        ParticleBlocks blocks;
        ParticleArrays particles;
        std::array<std::vector<IndexRange>, details> chosen;  ///< by Detail
        Springs springs;
        std::vector<Rod> links;
        std::vector<std::uint8_t> apart;    ///< one per particle: 1 if it is not where its twin is
        std::vector<std::uint8_t> bent;     ///< the same, if its springs are seen beside those of its twin
        std::vector<VertexColour> colours;  ///< kept to reuse its memory
    };

    void prepare(const Shot& shot, Ghost& ghost, Occupancy& taken);
    static void find_apart(const Shot& shot, Ghost& ghost);
    static void link(const Shot& shot, Ghost& ghost);
    static void colour(const Shot& shot, Ghost& ghost);

    ShaderProgram program_;
    Lines lines_;
    std::vector<std::unique_ptr<Ghost>> ghosts_;  ///< made when first needed
    std::size_t count_ = 0;                       ///< in this picture
    std::optional<Bounds> bounds_;
    float radius_ = 0;  ///< of the largest particle
};

}  // namespace steplab::render
