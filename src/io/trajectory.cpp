#include "io/trajectory.hpp"

#include "io/trajectory_chunk.hpp"
#include "io/trajectory_description.hpp"
#include "io/trajectory_layout.hpp"
#include "io/trajectory_text.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

/// Rows that a thread encodes at once: half a megabyte of text, which stays in its cache.
std::size_t rows_in_block(TrajectoryFormat format) {
    return format == TrajectoryFormat::trajectory ? trajectory::most_rows : 4096;
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(OutputFile& file, TrajectoryFormat format, RunDescription run,
                                   std::vector<std::size_t> particles)
    : file_(file), format_(format), run_(std::move(run)), writer_(file) {
    if (!particles.empty()) particles_ = std::make_shared<const std::vector<std::size_t>>(std::move(particles));
    file.at_program_end(format == TrajectoryFormat::trajectory ? UnfinishedFile::AtEnd::kept
                                                               : UnfinishedFile::AtEnd::kept_in_lines);
    if (format == TrajectoryFormat::csv) file.write(csv_header);
}

void TrajectoryWriter::add(const Frame& frame) {
    const std::size_t all = FrameBlock::rows_of(frame, particles_);
    const std::size_t most = rows_in_block(format_);
    for (std::size_t done = 0; done < all;) {
        const std::size_t rows = std::min(all - done, most);
        if (block_ && block_->positions.size() + rows > most) submit();
        if (!block_) block_ = std::make_shared<FrameBlock>(FrameBlock{.particles = particles_, .first_frame = frames_});
        block_->append(frame, done, rows);
        done += rows;
    }
    ++frames_;
}

void TrajectoryWriter::submit() {
    if (!block_) return;
    const std::shared_ptr<const FrameBlock> block = std::exchange(block_, nullptr);
    if (format_ == TrajectoryFormat::trajectory) {
        if (chunks_.empty()) write_description(*block);
        Chunk& chunk = chunks_.emplace_back(Chunk{block->first_frame, 0});
        writer_.submit([block, &chunk](std::string& bytes, std::string& scratch) {
            trajectory::append_chunk(bytes, scratch, *block);
            chunk.bytes = bytes.size();
        });
    } else {
        const auto append = format_ == TrajectoryFormat::csv ? append_csv : append_xyz;
        writer_.submit([block, append](std::string& text, std::string&) { append(text, *block); });
    }
}

void TrajectoryWriter::write_description(const FrameBlock& block) {
    using namespace trajectory;
    const std::string json = description_json(run_, block);
    const std::string begin = std::string(signature) + head_bytes({.kind = BlockKind::description}, json) + json;
    file_.write(begin);
    description_bytes_ = begin.size();
}

void TrajectoryWriter::flush() {
    submit();
    writer_.drain();
}

void TrajectoryWriter::finish() {
    using namespace trajectory;
    flush();
    if (chunks_.empty()) return;
    std::vector<IndexEntry> entries;
    std::uint64_t place = description_bytes_;
    for (const Chunk& chunk : chunks_) {
        entries.push_back({place, chunk.first_frame});
        place += chunk.bytes;
    }
    const std::string index = index_content(entries);
    file_.write(head_bytes({.kind = BlockKind::index, .first_frame = frames_}, index) + index + ending(place));
}

}  // namespace steplab
