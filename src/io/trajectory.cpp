#include "io/trajectory.hpp"

#include "io/trajectory_text.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

/// Rows made by one thread at once: half a megabyte of text, which stays in its cache.
constexpr std::size_t rows_in_block = 4096;

}  // namespace

TrajectoryWriter::TrajectoryWriter(OutputFile& file, TrajectoryFormat format, std::vector<std::size_t> particles)
    : format_(format), writer_(file) {
    if (!particles.empty()) particles_ = std::make_shared<const std::vector<std::size_t>>(std::move(particles));
    if (format == TrajectoryFormat::csv) file.write(csv_header);
}

void TrajectoryWriter::add(const Frame& frame) {
    const std::size_t all = FrameBlock::rows_of(frame, particles_);
    for (std::size_t done = 0; done < all;) {
        const std::size_t rows = std::min(all - done, rows_in_block);
        if (block_ && block_->positions.size() + rows > rows_in_block) submit();
        if (!block_) block_ = std::make_shared<FrameBlock>(FrameBlock{.particles = particles_});
        block_->append(frame, done, rows);
        done += rows;
    }
}

void TrajectoryWriter::submit() {
    if (!block_) return;
    writer_.submit([block = std::exchange(block_, nullptr),
                    append = format_ == TrajectoryFormat::csv ? append_csv : append_xyz](std::string& text) {
        append(text, *block);
    });
}

void TrajectoryWriter::flush() {
    submit();
    writer_.drain();
}

}  // namespace steplab
