#pragma once

#include "io/trajectory_reader.hpp"
#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// The frames of a CSV or XYZ file in any order, which a text cannot give: it is read once, from front to back, into a
/// trajectory file without a name in the folder for temporary files.
struct IndexedText {
    TrajectoryReader frames;
    std::string fault;  ///< why the text was read no further; empty if all of it was
};

/// Memory is that of a frame and of the index. Frames of an XYZ file without times are 1 s apart for each step. Throws
/// FileError if the file cannot be read or no whole frame is in it, Interrupted.
IndexedText indexed(InputFile text);

/// What stands for the run of a file that does not describe it: a scene of one particle.
RunDescription unknown_run(const std::string& file);

}  // namespace steplab
