#pragma once

#include "core/frame.hpp"
#include "io/columns.hpp"
#include "io/frame_block.hpp"
#include "io/ordered_writer.hpp"
#include "io/trajectory_format.hpp"
#include "io/trajectory_layout.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace steplab {

/// What of a run is written.
struct RowOptions {
    std::vector<std::size_t> particles = {};  ///< ascending; empty: all
    Columns columns = {};                     ///< empty: the usual ones; a trajectory file always has all of them
};

/// Throws UsageError for columns that this format does not hold.
void check_columns(TrajectoryFormat format, const Columns& columns);

/// Writes the frames of a run. Frames are copied, then encoded and written on threads of their own while the run
/// continues.
class TrajectoryWriter {
public:
    /// `file` must outlive the writer.
    TrajectoryWriter(OutputFile& file, TrajectoryFormat format, RunDescription run, RowOptions rows = {});

    /// What a frame has to hold for add().
    const FrameParts& needs() const { return needs_; }
    /// Adds the next frame of the run, of the whole scene. Waits while many blocks are still to be written. Throws what
    /// writing threw since the last call.
    void add(const Frame& frame);

    /// The description of a trajectory file whose blocks follow: as that file has it.
    void describe(trajectory::Version version, std::string description);
    /// Adds the next rows of a file that has what needs() names, all frames in their order. Throws as add(frame) does.
    void add(FrameBlock block);

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
    void write_description();

    OutputFile& file_;
    TrajectoryFormat format_;
    RunDescription run_;
    ParticleChoice particles_;
    std::shared_ptr<const Columns> columns_;
    trajectory::Version version_ = trajectory::Version::displacements;
    FrameParts needs_;         ///< follows from the members above
    std::string description_;  ///< JSON; empty until the first frame
    std::uint64_t frames_ = 0;
    std::size_t description_bytes_ = 0;  ///< bytes before the first chunk
    std::deque<Chunk> chunks_;           ///< a deque, so that a thread can set one while others are added
    std::shared_ptr<FrameBlock> block_;  // std::function wants what it holds to be copyable
    OrderedWriter writer_;
};

}  // namespace steplab
