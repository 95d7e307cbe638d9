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

/// Level of detail of a particle: a dot has one colour, a point is round and lit, a body is a full shape.
enum class Detail : std::uint8_t { dot, point, body };
inline constexpr std::size_t details = 3;

/// The level of detail for a ball of `radius` pixels.
Detail detail_of(double radius);

/// `count` consecutive particles from `first` on.
struct IndexRange {
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const IndexRange&, const IndexRange&) = default;
};

/// The particles of a frame as vertices in the order of the run, and the choice of those to draw, in blocks of
/// consecutive particles. Nothing is sorted: a block is drawn as a whole, or not at all if it is outside the view.
class ParticleBlocks {
public:
    static constexpr std::size_t block_size = 256;

    /// Computes the vertices (see vertex()) of the positions. Those that cannot be drawn are moved behind the camera.
    void place(const Frame& frame, const Projection& projection);

    std::span<const glm::vec3> vertices() const { return vertices_; }
    /// The box around all positions that can be drawn; the origin if there are none.
    const Bounds& bounds() const { return bounds_; }
    /// Moves the vertex of a particle behind the camera, so that it is not drawn.
    void hide(std::size_t particle) { vertices_[particle] = unseen_; }

    /// The particles to draw at each level of detail if they are balls of `radius`. The nearest particle of a block
    /// determines the level of the whole block.
    std::array<std::vector<IndexRange>, details> choose(const Projection& projection, const Tile& tile,
                                                        PictureSize part, double radius) const;
    /// Marks the parts of the picture that balls of `radius` of these particles cover, or of one of `one_of` of them.
    void mark(const Projection& projection, std::span<const IndexRange> ranges, double radius, Occupancy& taken,
              std::size_t one_of = 1) const;

private:
    struct Box {
        glm::vec3 low, high;
    };

    /// The box around the positions of a block; none if none of them can be drawn.
    std::optional<Bounds> place_block(const Frame& frame, const Projection& projection, std::size_t first,
                                      std::size_t count);

    std::vector<glm::vec3> vertices_;
    std::vector<std::optional<Box>> boxes_;  ///< of each block's vertices
    Bounds bounds_;
    glm::vec3 unseen_{};
};

}  // namespace steplab::render
