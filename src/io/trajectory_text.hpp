#pragma once

#include "io/columns.hpp"
#include "io/frame_block.hpp"

#include <string>
#include <string_view>

namespace steplab {

/// "step,time,particle,x,y,z\n"
std::string csv_header(const Columns& columns);
/// Appends the lines of a block as CSV; `begin` precedes each. Numbers are the shortest that read back exactly in the
/// run's precision. The block has the vectors of these columns.
void append_csv(std::string& text, const FrameBlock& block, const Columns& columns, std::string_view begin = "");

/// Throws UsageError unless they are whole vectors, the position among them: all that extended XYZ can hold.
void check_xyz_columns(const Columns& columns);
/// The same as extended XYZ; a block that begins a frame has the frame's head. Masses, and momenta from them, are in
/// double: kinetic energies of other programs then are the run's. Columns that are not known are left out.
void append_xyz(std::string& text, const FrameBlock& block, const Columns& columns);

}  // namespace steplab
