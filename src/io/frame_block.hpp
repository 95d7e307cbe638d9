#pragma once

#include "core/frame.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace steplab {

/// Which particles of a scene are written, ascending; null: all.
using ParticleChoice = std::shared_ptr<const std::vector<std::size_t>>;

/// Rows of a trajectory, one per particle and moment, as they are handed to a thread that writes them: several whole
/// frames, or a piece of one that is too large for a block.
struct FrameBlock {
    struct Moment {
        std::uint64_t step = 0;
        double time = 0;
    };

    ParticleChoice particles = {};
    Precision precision = Precision::double_;
    std::shared_ptr<const Shape> shape = {};
    std::uint64_t first_frame = 0;  ///< the number of the first moment's frame among those written, from 0
    std::size_t frame_rows = 0;     ///< of a whole frame
    std::size_t first_row = 0;      ///< within the frame; 0 unless this is a piece
    std::size_t rows = 0;           ///< of each moment in here
    std::vector<Moment> moments = {};
    std::vector<Vec3> positions = {};  ///< moment by moment
    std::vector<Vec3> velocities = {};

    /// The rows of a frame: of all its particles, or of the chosen ones. A frame of as many particles as were chosen
    /// holds just these.
    static std::size_t rows_of(const Frame& frame, const ParticleChoice& particles);
    /// Copies rows of a frame.
    void append(const Frame& frame, std::size_t first, std::size_t count);

    /// The number a particle has in its scene, by its row in a whole frame.
    std::size_t particle(std::size_t row) const { return particles ? (*particles)[row] : row; }
    Role role(std::size_t row) const { return shape->roles[shape->roles.size() == frame_rows ? row : particle(row)]; }
};

}  // namespace steplab
