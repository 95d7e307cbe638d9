#pragma once

#include "core/frame.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <vector>

namespace steplab {

/// A frame of a run whose positions and velocities another program computed, or a file holds: its shape, masses and
/// reference positions are those of the scene.
class RunFrame {
public:
    explicit RunFrame(const RunDescription& run);

    /// Puts a moment in place of the last one; of all particles of the scene. `wanted`: what else is to be in the
    /// frame.
    const Frame& at(std::uint64_t step, double time, std::vector<Vec3>& positions, std::vector<Vec3>& velocities,
                    const FrameParts& wanted);
    std::size_t particles() const { return frame_.shape->rest.size(); }

private:
    Frame frame_;
};

}  // namespace steplab
