#pragma once

#include "io/frame_block.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace steplab {

/// A frame as a VTK file of points (`.vtp`, XML as text), all numbers so that they read back exactly: particles as
/// vertices with their numbers, and velocities, displacements, masses and roles where they are known.
std::string vtp_text(const FrameBlock& frame);

/// Frames as files for ParaView: NAME.pvd names one NAME/000000.vtp for each frame, with its time.
class VtkSeries {
public:
    /// Makes the folder beside the file. Throws FileError.
    explicit VtkSeries(const std::string& pvd);
    /// Writes the file of a whole frame. Throws FileError.
    void add(const FrameBlock& frame);
    /// Writes the .pvd itself.
    void finish();

private:
    std::filesystem::path pvd_, folder_;
    std::vector<double> times_;
};

}  // namespace steplab
