#pragma once

#include "core/frame.hpp"
#include "session/played_frames.hpp"

#include <memory>

namespace steplab {

/// The shape of the rows of a file that does not hold all particles of a scene: at rest where they are in its `first`
/// frame. The motion is expected to reach the box around them in the middle and at the end of what is known of the file
/// so far; of very many rows that is not looked at.
std::shared_ptr<const Shape> played_shape(PlayedFrames& frames, const Frame& first);

}  // namespace steplab
