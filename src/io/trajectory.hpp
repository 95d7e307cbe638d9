#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "io/ordered_writer.hpp"
#include "io/trajectory_format.hpp"

#include <memory>
#include <vector>

namespace steplab {

/// Writes the frames of a run. What is handed over is copied; text is made of it, and written, on threads of their own,
/// while the run goes on.
class TrajectoryWriter {
public:
    /// `particles`: which ones, ascending; empty means all. `file` must outlive the writer.
    TrajectoryWriter(OutputFile& file, TrajectoryFormat format, std::vector<std::size_t> particles);

    /// Frames of one run, in their order: of the whole scene, or of the chosen particles alone. Waits while much is
    /// still to be written. Throws what writing threw since.
    void add(const Frame& frame);
    /// Everything added so far goes to the file. The file itself is not committed.
    void flush();

private:
    void submit();

    TrajectoryFormat format_;
    ParticleChoice particles_;
    std::shared_ptr<FrameBlock> block_;  // std::function wants what it holds to be copyable
    OrderedWriter writer_;
};

}  // namespace steplab
