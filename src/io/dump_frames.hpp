#pragma once

#include "core/frame.hpp"
#include "io/frame_block.hpp"
#include "io/input_file.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// The frames of a LAMMPS dump in any order. Where each begins is found once, from front to back and in pieces, also of
/// a file to which another program is still writing; a frame is read when it is asked for. Memory is that of a frame
/// and of some bytes for each. A compressed file is first restored in the folder for temporary files.
class DumpFrames {
public:
    /// True if the file, or what is compressed in it, begins as a dump does.
    static bool reads(const std::string& file);

    /// Finds the first frame. Throws FileError if there is none that is whole, Interrupted.
    explicit DumpFrames(const std::string& file);

    /// Looks through about so many bytes more, and what was written since. True if there are other frames() or another
    /// fault() now.
    bool look_on(std::uint64_t bytes);
    /// True if there is more to be looked through at once.
    bool has_more() const { return !stuck_ && broken_.empty() && place_ < file_->size(); }
    /// The part of the file that was looked through.
    double looked_through() const;

    std::uint64_t frames() const { return index_.size(); }
    /// Atoms of each frame.
    std::uint64_t rows() const { return rows_; }
    /// Why there are no more frames behind these; empty if the file ends with a whole one, or is not looked through.
    std::string fault() const;
    FrameBlock::Moment moment(std::uint64_t number) const { return index_[number].moment; }
    /// The frame with this number, counted from 0: its shape has roles, types as groups, and the box if it is along the
    /// axes. Throws FileError naming the line if it is damaged.
    void frame(std::uint64_t number, Frame& out) const;
    /// Numbers of the atoms of a frame, less 1, by rows.
    std::vector<std::size_t> particles(std::uint64_t number) const;

private:
    struct Entry {
        std::uint64_t place = 0, line = 0;  ///< of its first byte; lines before it
        FrameBlock::Moment moment;
    };
    /// What the next line is.
    enum class Next { item, step, time, rows, other, atoms };

    static std::shared_ptr<InputFile> opened(const std::string& file);
    bool look_at_piece();
    void take_line(std::string_view line);
    void take_item(std::string_view line);
    void end_frame();
    FrameBlock block(std::uint64_t number, std::vector<std::uint64_t>& types) const;

    std::string name_;
    std::shared_ptr<InputFile> file_;
    std::vector<Entry> index_;
    std::uint64_t rows_ = 0;
    // where it stands in the file
    std::uint64_t place_ = 0, lines_ = 0;
    Next next_ = Next::item;
    std::uint64_t left_ = 0;  ///< lines of this kind
    Entry entry_;             ///< of the frame that is looked at
    std::uint64_t frame_rows_ = 0;
    bool within_ = false;  ///< in a frame
    bool stuck_ = false;   ///< the last line is not written to its end
    std::optional<double> time_;
    std::string broken_;  ///< why nothing behind it is looked at
};

}  // namespace steplab
