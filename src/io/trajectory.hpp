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

/// Writes the frames of a run. What is handed over is copied; it is made into bytes, and these are written, on threads
/// of their own while the run goes on.
class TrajectoryWriter {
public:
    /// `particles`: which ones, ascending; empty means all. `file` must outlive the writer.
    TrajectoryWriter(OutputFile& file, TrajectoryFormat format, RunDescription run, std::vector<std::size_t> particles);

    /// Frames of one run, in their order: of the whole scene, or of the chosen particles alone. Waits while much is
    /// still to be written. Throws what writing threw since.
    void add(const Frame& frame);
    /// Everything added so far goes to the file.
    void flush();
    /// No frame will follow: what belongs at the end goes to the file too. The file itself is not committed.
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
    std::size_t description_bytes_ = 0;  ///< what stands before the first chunk
    std::deque<Chunk> chunks_;           ///< a deque, so that a thread can set one while others are added
    std::shared_ptr<FrameBlock> block_;  // std::function wants what it holds to be copyable
    OrderedWriter writer_;
};

}  // namespace steplab
