#include "io/whole_frames.hpp"

#include <utility>

namespace steplab {

namespace {

template <class Value>
void append_part(const std::vector<Value>& from, std::size_t first, std::size_t count, std::vector<Value>& to) {
    if (from.empty()) return;
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

void WholeFrames::add(const FrameBlock& block) {
    for (std::size_t moment = 0; moment < block.moments.size(); ++moment) {
        append(block, moment);
        if (frame_.rows < block.frame_rows) continue;
        visit_(frame_);
        frame_ = FrameBlock();
    }
}

void WholeFrames::append(const FrameBlock& block, std::size_t moment) {
    if (frame_.rows == 0) {
        frame_.scene = block.scene;
        frame_.first_frame = block.first_frame + moment;
        frame_.frame_rows = block.frame_rows;
        frame_.moments = {block.moments[moment]};
    }
    append_part(block.particles, 0, block.rows, frame_.particles);
    append_part(block.roles, 0, block.rows, frame_.roles);
    append_part(block.masses, 0, block.rows, frame_.masses);
    append_part(block.types, 0, block.rows, frame_.types);
    if (moment == 0 && block.rows == block.frame_rows) frame_.values = block.values;
    for (const auto vectors : {&FrameBlock::positions, &FrameBlock::displacements, &FrameBlock::velocities})
        append_part(block.*vectors, moment * block.rows, block.rows, frame_.*vectors);
    frame_.rows += block.rows;
}

}  // namespace steplab
