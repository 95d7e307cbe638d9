#pragma once

#include "io/frame_block.hpp"

#include <string>
#include <string_view>

namespace steplab {

inline constexpr std::string_view csv_header = "step,time,particle,x,y,z,vx,vy,vz\n";

/// Appends the lines of a block as CSV. Numbers are the shortest that read back exactly in the run's precision.
void append_csv(std::string& text, const FrameBlock& block);
/// The same as extended XYZ; a block that begins a frame has the frame's head.
void append_xyz(std::string& text, const FrameBlock& block);

}  // namespace steplab
