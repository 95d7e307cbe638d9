#pragma once

#include "core/precision.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace steplab {

/// What one moment of a run looks like from outside. Plain data: the drawing, the files and the panels see nothing
/// else.
struct Frame {
    std::uint64_t step = 0;
    double time = 0;
    Precision precision = Precision::double_;
    std::vector<Vec3> positions;   ///< absolute; each number is one the run's precision holds
    std::vector<Vec3> velocities;  ///< of the same moment
    /// Where the particles are in runs that go beside this one, at the same step: run after run. None: there are none.
    std::vector<Vec3> ensemble;
    std::shared_ptr<const Shape> shape;

    /// Where a particle is seen.
    Vec3 seen(std::size_t particle) const { return shape->seen(positions[particle]); }
};

}  // namespace steplab
