#pragma once

#include "io/frame_block.hpp"

#include <string>

namespace steplab {

/// Appends a whole frame as a frame of a LAMMPS dump, all numbers so that they read back exactly. Atoms have the ids of
/// their particles plus 1 and their types; without, the type 1, or that of their role where roles differ. Masses and
/// further values follow. Along axes without periodic
/// boundary conditions the box is what the positions take up.
void append_dump(std::string& text, const FrameBlock& frame);

}  // namespace steplab
