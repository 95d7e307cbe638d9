#pragma once

#include "core/precision.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace steplab {

/// The state of a run at one step, as plain data: all that drawing, files and panels use.
struct Frame {
    std::uint64_t step = 0;
    double time = 0;
    Precision precision = Precision::double_;
    std::vector<Vec3> positions;   ///< absolute; numbers of the run's precision
    std::vector<Vec3> velocities;  ///< at the same time
    /// Positions in the runs of the ensemble at the same step, run after run; empty without an ensemble.
    std::vector<Vec3> ensemble;
    std::shared_ptr<const Shape> shape;

    /// The position at which a particle is drawn (Shape::seen).
    Vec3 seen(std::size_t particle) const { return shape->seen(positions[particle]); }
};

}  // namespace steplab
