#pragma once

#include "io/columns.hpp"
#include "io/frame_block.hpp"
#include "io/text_trajectory.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// Where a frame of a text is: its bytes, the lines before it, and what its head says.
struct FoundFrame {
    std::uint64_t begin = 0, end = 0, line = 0;
    FrameBlock::Moment moment = {};
    std::uint64_t rows = 0;
};

/// Finds the frames of a text from its lines, without reading their rows.
class FrameFinder {
public:
    /// A line without its end, its first byte and that of the next line, and the lines before it.
    struct Line {
        std::string_view text;
        std::uint64_t begin = 0, end = 0, number = 0;
        /// Throws FileError: the number of the line, the reason.
        [[noreturn]] void fail(const std::string& reason) const;
    };

    virtual ~FrameFinder() = default;
    /// Takes the next line and adds the frames that are complete with it or before it. Throws FileError if nothing
    /// behind this line can be read.
    virtual void take(const Line& line, std::vector<FoundFrame>& found) = 0;
    /// True if a last line, of which the end is missing, may be the last row of a frame.
    virtual bool may_end_with(std::string_view line) const = 0;
    /// The frame that is complete because the text ends here.
    virtual std::optional<FoundFrame> at_end() { return std::nullopt; }
    /// True between the first and the last line of a frame.
    virtual bool within() const = 0;
    /// Reads a frame from its bytes alone.
    virtual std::unique_ptr<TextTrajectory> reader(TextInput frame) const = 0;
};

/// For a text that begins like this. Throws FileError if it is none of those that are known.
std::unique_ptr<FrameFinder> frame_finder(TextInput& text);

std::unique_ptr<FrameFinder> dump_finder();
std::unique_ptr<FrameFinder> xyz_finder();
std::unique_ptr<FrameFinder> csv_finder();

/// The whole word as a number. Throws FileError.
template <class Number>
Number number_of(const FrameFinder::Line& line, std::string_view word);

}  // namespace steplab
