#pragma once

#include "core/shape.hpp"
#include "io/frame_block.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace steplab {

/// A frame as a VTK file of points (`.vtp`, XML as text), all numbers so that they read back exactly: particles as
/// vertices with their numbers, and velocities, displacements, masses and roles where they are known; the
/// springs of a shape of as many particles as lines, but for those to the image of a particle.
std::string vtp_text(const FrameBlock& frame, const Shape& shape = {});

/// Frames as files for ParaView: NAME.pvd names one NAME/000000.vtp for each frame, with its time.
class VtkSeries {
public:
    /// Makes the folder beside the file. Throws FileError.
    explicit VtkSeries(const std::string& pvd);
    /// From now on frames have these springs.
    void join(const Shape& shape) { shape_ = shape; }
    /// Writes the file of a whole frame. Throws FileError.
    void add(const FrameBlock& frame);
    /// Writes the .pvd itself.
    void finish();

private:
    std::filesystem::path pvd_, folder_;
    Shape shape_;
    std::vector<double> times_;
};

}  // namespace steplab
