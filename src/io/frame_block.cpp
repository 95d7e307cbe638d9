#include "io/frame_block.hpp"

namespace steplab {

std::size_t FrameBlock::rows_of(const Frame& frame, const ParticleChoice& particles) {
    return particles ? particles->size() : frame.positions.size();
}

void FrameBlock::append(const Frame& frame, std::size_t first, std::size_t count) {
    precision = frame.precision;
    shape = frame.shape;
    frame_rows = rows_of(frame, particles);
    first_row = first;
    rows = count;
    moments.push_back({frame.step, frame.time});
    const bool contiguous = frame.positions.size() == frame_rows;
    const auto copy = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
        if (contiguous) {
            const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
            to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
        } else {
            for (std::size_t row = first; row < first + count; ++row) to.push_back(from[particle(row)]);
        }
    };
    copy(frame.positions, positions);
    copy(frame.velocities, velocities);
}

}  // namespace steplab
