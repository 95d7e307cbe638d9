#pragma once

#include "plot/layout.hpp"

#include <span>
#include <vector>

namespace steplab::plot {

/// A vertical line in the frame of a plot, and its label.
struct MomentLine {
    const Moment* moment;
    float pixel = 0;
    Box label;  ///< empty where it has no room
};

/// The lines of a plot's moments that its frame shows, in their order. Labels stand at the foot of the frame, in the
/// lowest of up to three rows that is free, right of their lines or left of them where the frame ends. The last ones
/// choose first: what was done last explains what one sees now.
std::vector<MomentLine> moment_lines(const Plot& plot, const Layout& layout, const Lettering& lettering);

/// Pixels at the foot of the frame that their labels take.
float height_of_labels(std::span<const MomentLine> lines, const Box& frame);

/// The lines that a pointer in the frame is at, within a few pixels.
std::vector<const Moment*> moments_at(const Plot& plot, const Axes& axes, float pointer, float reach);

}  // namespace steplab::plot
