#pragma once

#include "io/columns.hpp"
#include "io/frame_block.hpp"
#include "io/text_input.hpp"

#include <cstdint>
#include <memory>
#include <string_view>

namespace steplab {

/// Reads the frames of a CSV or XYZ file as steplab writes them, also compressed, from front to back. Holds one frame.
class TextTrajectory {
public:
    /// An XYZ file of another program need not say Step and Time, may have any box, and its Properties may be missing:
    /// a species and a position then. It may have momenta instead of velocities; each row has its mass.
    enum class From { steplab, any_program };

    /// Throws FileError if the file cannot be read or begins like neither.
    static std::unique_ptr<TextTrajectory> open(InputFile file);
    static std::unique_ptr<TextTrajectory> open(TextInput input, From from);
    virtual ~TextTrajectory() = default;

    /// Those that the file has; of a dump, whose frames name their own, those of the frame that was read last.
    const Columns& columns() const { return columns_; }
    /// Throws FileError if one of these is not among them.
    void require(const Columns& columns) const;
    /// The next frame; false at the end of the file. Throws FileError naming the line.
    bool next(FrameBlock& frame);

protected:
    explicit TextTrajectory(TextInput input) : input_(std::move(input)) {}
    virtual bool read(FrameBlock& frame) = 0;

    /// Appends zeros for a row to each vector of which the file has a component.
    void add_row(FrameBlock& frame) const;
    /// Sets a number of the last row.
    void set(FrameBlock& frame, Column column, std::string_view word) const;
    template <class Number>
    Number number(std::string_view word) const;

    TextInput input_;
    Columns columns_;

private:
    std::uint64_t frames_ = 0;
};

/// The kinds of text that are read.
enum class TextFormat { csv, xyz, dump };
/// That of a text of which nothing was taken yet. Throws FileError if it begins like none of them.
TextFormat format_of(TextInput& input, TextTrajectory::From from);

/// "step,time,particle" and columns. Its first line is not yet read.
std::unique_ptr<TextTrajectory> csv_trajectory(TextInput input);
/// Lines of it behind the first one, which names these columns.
std::unique_ptr<TextTrajectory> csv_trajectory(TextInput rows, Columns columns);
/// Extended XYZ.
std::unique_ptr<TextTrajectory> xyz_trajectory(TextInput input, TextTrajectory::From from);

}  // namespace steplab
