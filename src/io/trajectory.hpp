#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "io/ordered_writer.hpp"
#include "io/trajectory_format.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace steplab {

/// Writes the frames of a run. Frames are copied, then encoded and written on threads of their own while the run
/// continues.
class TrajectoryWriter {
public:
    /// `particles`: those to write, ascending; empty means all. `file` must outlive the writer.
    TrajectoryWriter(OutputFile& file, TrajectoryFormat format, RunDescription run, std::vector<std::size_t> particles);

    /// Adds the next frame of the run: of the whole scene, or of the chosen particles alone. Waits while many blocks
    /// are still to be written. Throws what writing threw since the last call.
    void add(const Frame& frame);
    /// Writes all frames added so far to the file.
    void flush();
    /// Writes the end of the file after the last frame. The file itself is not committed.
    void finish();

private:
    /// A chunk on its way into the file.
    struct Chunk {
        std::uint64_t first_frame = 0;
        std::size_t bytes = 0;
    };
    void submit();
    void write_description(const FrameBlock& block);

    OutputFile& file_;
    TrajectoryFormat format_;
    RunDescription run_;
    ParticleChoice particles_;
    std::uint64_t frames_ = 0;
    std::size_t description_bytes_ = 0;  ///< bytes before the first chunk
    std::deque<Chunk> chunks_;           ///< a deque, so that a thread can set one while others are added
    std::shared_ptr<FrameBlock> block_;  // std::function wants what it holds to be copyable
    OrderedWriter writer_;
};

}  // namespace steplab
