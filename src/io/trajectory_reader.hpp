#pragma once

#include "core/frame.hpp"
#include "io/columns.hpp"
#include "io/frame_block.hpp"
#include "io/input_file.hpp"
#include "io/trajectory_description.hpp"
#include "io/trajectory_layout.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// Reads the frames of a `.trajectory` file in any order, and only the parts of the file that are needed. Its memory is
/// that of a chunk, of the index and of the description, however many rows the file claims to have.
///
///     TrajectoryReader reader(InputFile("chain.trajectory"));
///     Frame frame;
///     for (std::uint64_t i = 0; i < reader.frames(); ++i) reader.frame(i, frame);
class TrajectoryReader {
public:
    /// True if the file begins as a trajectory does.
    static bool reads(const InputFile& file);

    /// Throws FileError if the file cannot be read or is not a trajectory.
    explicit TrajectoryReader(InputFile file);

    /// The run. Throws FileError if this program does not know its model, method or parameters.
    RunDescription run() const;
    /// The program that wrote the file: "steplab 0.1.0".
    const std::string& program() const { return description_.program; }
    const FileScene& scene() const { return description_.scene; }
    trajectory::Version version() const { return version_; }
    /// The description as it is in the file.
    const std::string& description() const { return description_text_; }
    /// The number of rows of a frame.
    std::uint64_t rows() const { return description_.rows; }

    /// Throws FileError if the file does not hold these columns: its version may be older than they are.
    void require(const Columns& columns) const;

    /// The number of complete frames.
    std::uint64_t frames() const { return frames_; }
    /// False if the end of the file is missing or damaged: frames() are those before it.
    bool complete() const { return complete_; }

    /// Calls visit(block) for the blocks of all complete frames in their order. Throws FileError if one is damaged.
    template <class Visit>
    void each_block(const Visit& visit) {
        std::uint64_t frame = 0, row = 0;
        for (std::size_t entry = 0; frame < frames_; ++entry) visit(block_after(entry, frame, row));
    }

    /// Step and time of the frame with this number. Throws FileError if it is damaged.
    FrameBlock::Moment moment(std::uint64_t number);
    /// The frame with this number, counted from 0, of the rows of the file alone: its shape has only their
    /// roles, masses and the box. Displacements are empty in files of the first version. Throws FileError if it is
    /// damaged.
    void frame(std::uint64_t number, Frame& out);

private:
    void read_description();
    bool read_index(std::uint64_t place);
    /// Finds the chunks without an index, up to the end of the file or its first damage.
    void search(std::uint64_t place);
    std::optional<std::string> content_of(const trajectory::BlockHead& head, std::uint64_t place) const;
    std::size_t first_entry(std::uint64_t frame) const;
    const FrameBlock& chunk(std::size_t entry, std::uint64_t frame);
    /// The block of an entry, which is to begin with this row of this frame; both move behind it.
    FrameBlock block_after(std::size_t entry, std::uint64_t& frame, std::uint64_t& row);
    bool complete_rows(FrameBlock& block) const;
    void append_rows(const FrameBlock& block, std::uint64_t frame, Frame& out) const;
    [[noreturn]] void fail(const std::string& what) const;

    InputFile file_;
    trajectory::Version version_ = trajectory::Version::positions;
    std::string description_text_;
    trajectory::Description description_;
    std::uint64_t first_chunk_ = 0;
    std::vector<trajectory::IndexEntry> index_;
    std::uint64_t frames_ = 0;
    bool complete_ = true;
    std::optional<FrameBlock> read_;  ///< the last chunk that was read
    std::size_t read_entry_ = 0;
};

}  // namespace steplab
