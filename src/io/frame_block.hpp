#pragma once

#include "core/frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace steplab {

/// The particles of a scene that are written, ascending; null: all.
using ParticleChoice = std::shared_ptr<const std::vector<std::size_t>>;

/// Rows of a trajectory, one per particle and frame, to be written by another thread: several whole frames, or a part
/// of one that is too large for a block.
struct FrameBlock {
    struct Moment {
        std::uint64_t step = 0;
        double time = 0;
    };

    ParticleChoice particles = {};
    Precision precision = Precision::double_;
    std::shared_ptr<const Shape> shape = {};
    std::uint64_t first_frame = 0;  ///< the number of the first frame among those written, from 0
    std::size_t frame_rows = 0;     ///< rows of a whole frame
    std::size_t first_row = 0;      ///< within the frame; 0 unless this is a part of one
    std::size_t rows = 0;           ///< of each frame in this block
    std::vector<Moment> moments = {};
    std::vector<Vec3> positions = {};  ///< frame by frame
    std::vector<Vec3> velocities = {};

    /// The number of rows of a frame: all its particles, or the chosen ones.
    static std::size_t rows_of(const Frame& frame, const ParticleChoice& particles);
    /// Copies rows of a frame, which holds the whole scene or the chosen particles alone.
    void append(const Frame& frame, std::size_t first, std::size_t count);

    /// The number in its scene of the particle in this row of a whole frame.
    std::size_t particle(std::size_t row) const { return particles ? (*particles)[row] : row; }
    Role role(std::size_t row) const { return shape->roles[shape->roles.size() == frame_rows ? row : particle(row)]; }
};

}  // namespace steplab
