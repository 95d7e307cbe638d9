#include "io/trajectory.hpp"

#include "core/error.hpp"
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

FrameParts parts_needed(TrajectoryFormat format, trajectory::Version version, const Columns& columns) {
    if (format != TrajectoryFormat::trajectory) return parts_of(columns);
    const bool displacements = version == trajectory::Version::displacements;
    return {.positions = !displacements, .displacements = displacements};
}

}  // namespace

void check_columns(TrajectoryFormat format, const Columns& columns) {
    if (columns.empty()) return;
    if (format == TrajectoryFormat::xyz) check_xyz_columns(columns);
    if (format == TrajectoryFormat::trajectory)
        throw UsageError("--columns selects those of CSV and XYZ; a trajectory file holds all of them");
}

TrajectoryWriter::TrajectoryWriter(OutputFile& file, TrajectoryFormat format, RunDescription run, RowOptions rows)
    : file_(file),
      format_(format),
      run_(std::move(run)),
      columns_(std::make_shared<const Columns>(rows.columns.empty() ? usual_columns() : rows.columns)),
      needs_(parts_needed(format, version_, *columns_)),
      writer_(file) {
    check_columns(format, rows.columns);
    if (!rows.particles.empty())
        particles_ = std::make_shared<const std::vector<std::size_t>>(std::move(rows.particles));
    file.at_program_end(format == TrajectoryFormat::trajectory ? UnfinishedFile::AtEnd::kept
                                                               : UnfinishedFile::AtEnd::kept_in_lines);
    if (format == TrajectoryFormat::csv) file.write(csv_header(*columns_));
}

void TrajectoryWriter::add(const Frame& frame) {
    if (format_ == TrajectoryFormat::trajectory && description_.empty())
        description_ = description_json(run_, scene_of(frame), trajectory::row_list(frame, particles_));
    const std::size_t all = FrameBlock::rows_of(frame, particles_);
    const std::size_t most = rows_in_block(format_);
    for (std::size_t done = 0; done < all;) {
        const std::size_t rows = std::min(all - done, most);
        if (block_ && block_->all_rows() + rows > most) submit();
        if (!block_) block_ = std::make_shared<FrameBlock>(FrameBlock{.first_frame = frames_});
        block_->append(frame, needs_, particles_, done, rows);
        done += rows;
    }
    ++frames_;
}

void TrajectoryWriter::describe(trajectory::Version version, std::string description) {
    version_ = version;
    description_ = std::move(description);
    needs_ = parts_needed(format_, version_, *columns_);
}

void TrajectoryWriter::add(FrameBlock block) {
    block.complete(needs_);
    if ((needs_.displacements && block.displacements.empty()) || (needs_.positions && block.positions.empty()))
        throw FileError("the rows lack positions or displacements, which this format holds");
    if (block.first_row + block.rows == block.frame_rows) frames_ = block.first_frame + block.moments.size();
    block_ = std::make_shared<FrameBlock>(std::move(block));
    submit();
}

void TrajectoryWriter::submit() {
    if (!block_) return;
    const std::shared_ptr<const FrameBlock> block = std::exchange(block_, nullptr);
    if (format_ == TrajectoryFormat::trajectory) {
        if (chunks_.empty()) write_description();
        Chunk& chunk = chunks_.emplace_back(Chunk{block->first_frame, 0});
        writer_.submit([block, &chunk, version = version_](std::string& bytes, std::string& scratch) {
            trajectory::append_chunk(bytes, scratch, *block, version);
            chunk.bytes = bytes.size();
        });
    } else {
        const bool csv = format_ == TrajectoryFormat::csv;
        writer_.submit([block, columns = columns_, csv](std::string& text, std::string&) {
            if (csv) {
                append_csv(text, *block, *columns);
            } else {
                append_xyz(text, *block, *columns);
            }
        });
    }
}

void TrajectoryWriter::write_description() {
    using namespace trajectory;
    const std::string begin =
        signature(version_) + head_bytes({.kind = BlockKind::description}, description_) + description_;
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
