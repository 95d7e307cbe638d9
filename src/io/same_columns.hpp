#pragma once

#include "io/columns.hpp"
#include "io/frame_block.hpp"

#include <optional>
#include <string>
#include <utility>

namespace steplab {

/// The columns of the frames of one text, for a file that names its columns once: all frames have to have those of the
/// first one.
class SameColumns {
public:
    /// `columns`: those that are wanted; with `values`, all others that frames have.
    SameColumns(Columns columns, bool values) : wanted_(std::move(columns)), values_(values) {}
    /// Throws FileError naming the frame, which is the next one, and what it has.
    void check(const std::string& file, const FrameBlock& frame);

private:
    std::string names_in(const FrameBlock& frame) const;

    Columns wanted_;
    bool values_;
    std::optional<std::string> first_ = {};
};

}  // namespace steplab
