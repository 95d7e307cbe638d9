#pragma once

#include <cstdint>

namespace steplab {

/// Where a method could not go on: no step that it can take meets its tolerance, or solves its equations. Plain data.
struct OwnStop {
    double time = 0;  ///< since the start of the segment; of methods with steps of dt, since the start of the step
    double step = 0;  ///< the last one it tried
    /// The two particles with a force between them that are nearest to each other, and their distance in metres; twice
    /// the same particle in scenes without such forces.
    std::uint32_t first = 0, second = 0;
    double distance = 0;
};

}  // namespace steplab
