#pragma once

#include "core/frame.hpp"
#include "render/bounds.hpp"
#include "render/occupancy.hpp"
#include "render/scene_renderer.hpp"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab::render {

/// How much of its shape a particle shows: a dot is of one colour, a point is round and lit, a body is all there.
enum class Detail : std::uint8_t { dot, point, body };
inline constexpr std::size_t details = 3;

/// How much of a ball of `radius` pixels is seen.
Detail detail_of(double radius);

/// Particles first, first + 1, ...
struct IndexRange {
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// The particles of a frame as vertices, in the order that the run has them in; and what is to be drawn of them, by
/// blocks of particles that follow each other. Nothing is sorted: a block is drawn whole or, outside the view, not at
/// all.
class ParticleBlocks {
public:
    static constexpr std::size_t block_size = 256;

    /// Makes vertices (see vertex()) of the positions. Those that cannot be drawn are put behind the eye.
    void place(const Frame& frame, const Projection& projection);

    std::span<const glm::vec3> vertices() const { return vertices_; }
    /// The box of all positions that can be drawn; the origin alone if there are none.
    const Bounds& bounds() const { return bounds_; }
    /// Puts a particle's vertex behind the eye, where nothing is drawn.
    void hide(std::size_t particle) { vertices_[particle] = unseen_; }

    /// The particles to draw in each detail if they are balls of `radius`. A block near enough for a body is drawn as
    /// bodies, one near enough for points as points.
    std::array<std::vector<IndexRange>, details> choose(const Projection& projection, const Tile& tile,
                                                        PictureSize part, double radius) const;
    /// Marks where balls of `radius` of these particles are seen.
    void mark(const Projection& projection, std::span<const IndexRange> ranges, double radius, Occupancy& taken) const;

private:
    struct Box {
        glm::vec3 low, high;
    };

    /// The box of the block's positions; none if none of them can be drawn.
    std::optional<Bounds> place_block(const Frame& frame, const Projection& projection, std::size_t first,
                                      std::size_t count);

    std::vector<glm::vec3> vertices_;
    std::vector<std::optional<Box>> boxes_;  ///< of each block's vertices
    Bounds bounds_;
    glm::vec3 unseen_{};
};

}  // namespace steplab::render
