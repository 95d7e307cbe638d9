#pragma once

#include "io/frame_block.hpp"

#include <cstddef>
#include <functional>
#include <utility>

namespace steplab {

/// Blocks of several frames, or of a part of one, as frames that are whole: for formats that say at the beginning of a
/// frame what is in all of it. Memory is that of a frame and a block.
class WholeFrames {
public:
    using Visit = std::function<void(const FrameBlock& frame)>;

    explicit WholeFrames(Visit visit) : visit_(std::move(visit)) {}
    /// In their order.
    void add(const FrameBlock& block);

private:
    void append(const FrameBlock& block, std::size_t moment);

    Visit visit_;
    FrameBlock frame_;
};

}  // namespace steplab
