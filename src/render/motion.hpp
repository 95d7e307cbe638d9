#pragma once

#include "core/frame.hpp"

namespace steplab::render {

/// Makes `out` the moment a fraction (0 .. 1) of the way from one frame to a later one of the same particles, on the
/// cubic curves that have the positions and velocities of both (Hermite). For pictures of slow runs only, so that ten
/// steps a second do not look like ten: at 0 and 1 they are the frames themselves, in between no numbers of the run.
/// The particles of companions keep their places beside those of the run, which change evenly.
void between(const Frame& from, const Frame& to, double fraction, Frame& out);

}  // namespace steplab::render
