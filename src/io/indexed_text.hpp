#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "io/frame_finder.hpp"
#include "io/input_file.hpp"
#include "io/restored_text.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The frames of a CSV or XYZ file or a LAMMPS dump in any order. Where each begins is found once, from front to back
/// and in pieces, also of a file to which another program is still writing; a frame is read when it is asked for.
/// Memory is that of a frame and of some bytes for each. A compressed file is restored in the folder for temporary
/// files, piece by piece too.
class IndexedText {
public:
    /// Finds the first two frames, of which the second tells whether there are times. Throws FileError if there is none
    /// that is whole, Interrupted.
    explicit IndexedText(const std::string& file);

    /// Looks through about so many bytes more, and what was written since. True if there are other frames() or another
    /// fault() now.
    bool look_on(std::uint64_t bytes);
    /// True if there is more to be looked through at once.
    bool has_more() const { return broken_.empty() && (is_restoring() || (!stuck_ && place_ < file_->size())); }
    /// The part of the file that was looked through.
    double looked_through() const;

    std::uint64_t frames() const { return index_.size(); }
    /// Particles of each frame.
    std::uint64_t rows() const { return index_.front().rows; }
    /// True if the first frame has them; else those of frames are 0.
    bool has_velocities() const { return !block(0).velocities.empty(); }
    /// Those of its numbers, by LAMMPS' name of them; empty: not said.
    std::string units() const { return block(0).scene.units; }
    /// Why there are no more frames behind these; empty if the file ends with a whole one, or is not looked through.
    std::string fault() const;
    /// Frames without times are 1 s apart for each step.
    FrameBlock::Moment moment(std::uint64_t number) const;
    /// The frame with this number, counted from 0: its shape has roles, types as groups, and the box if it is along the
    /// axes. Throws FileError naming the line if it is damaged.
    void frame(std::uint64_t number, Frame& out) const;
    /// Numbers of the particles of a frame, by rows.
    std::vector<std::size_t> particles(std::uint64_t number) const;

private:
    void open(InputFile given);
    bool is_restoring() const { return restored_ && !restored_->is_whole() && damaged_.empty(); }
    bool look_at_piece();
    void restore_piece();
    void look_at_end();
    void take_line(std::string_view text);
    void add(const FoundFrame& frame);
    FrameBlock block(std::uint64_t number) const;

    std::string name_;
    std::optional<RestoredText> restored_;
    std::shared_ptr<InputFile> file_;
    std::unique_ptr<FrameFinder> finder_;
    std::vector<FoundFrame> index_, found_;
    // where it stands in the file
    std::uint64_t place_ = 0, lines_ = 0;
    bool stuck_ = false;   ///< the last line is not written to its end
    bool open_ = false;    ///< it was taken nonetheless; what follows belongs to it
    bool grown_ = false;   ///< another program writes the file
    std::string broken_;   ///< why nothing behind it is looked at
    std::string damaged_;  ///< why no more of a compressed file can be restored
};

/// What stands for the run of a file that does not describe it: a scene of one particle.
RunDescription unknown_run(const std::string& file);

}  // namespace steplab
