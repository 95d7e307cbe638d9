#pragma once

#include "core/frame.hpp"

namespace steplab::render {

/// Interpolates between a frame (fraction 0) and a later one of the same particles (1) by cubic Hermite curves through
/// their positions and velocities. For smooth pictures of slow runs only: between 0 and 1, `out` is no result of the
/// run. The particles of an ensemble are placed relative to those of the run, with offsets that change linearly.
void between(const Frame& from, const Frame& to, double fraction, Frame& out);

}  // namespace steplab::render
