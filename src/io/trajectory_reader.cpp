#include "io/trajectory_reader.hpp"

#include "core/error.hpp"
#include "io/trajectory_chunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

using namespace trajectory;

TrajectoryReader::TrajectoryReader(std::string file) : file_(std::move(file)) {
    const std::string begin = file_.read(0, signature.size());
    if (!begin.starts_with(signature.substr(0, signature_without_version)))
        fail("it is not a trajectory file of steplab");
    if (begin != signature) fail("its format version is not supported; it may be of a newer steplab");
    read_description();
    const auto place =
        parse_ending(file_.read(file_.size() - std::min(file_.size(), std::uint64_t{ending_bytes}), ending_bytes));
    if (!place || !read_index(*place)) search(first_chunk_);
}

void TrajectoryReader::read_description() {
    const auto head = parse_head(file_.read(signature.size(), BlockHead::bytes));
    const std::uint64_t place = signature.size() + BlockHead::bytes;
    const auto content = head && head->kind == BlockKind::description ? content_of(*head, place) : std::nullopt;
    if (!content) fail("it is truncated or damaged at its beginning");
    try {
        description_ = parse_description(*content, (file_.size() / BlockHead::bytes) * most_rows);
    } catch (const std::exception&) {
        fail("the description of its run is not valid");
    }
    first_chunk_ = place + content->size();
}

bool TrajectoryReader::read_index(std::uint64_t place) {
    const auto head = parse_head(file_.read(place, BlockHead::bytes));
    if (!head || head->kind != BlockKind::index) return false;
    const auto content = content_of(*head, place + BlockHead::bytes);
    auto entries = content ? parse_index(*content) : std::nullopt;
    if (!entries || entries->empty()) return false;
    index_ = std::move(*entries);
    frames_ = head->first_frame;
    complete_ = true;
    return true;
}

void TrajectoryReader::search(std::uint64_t place) {
    complete_ = false;
    std::uint64_t rows = 0;  // of the current frame
    while (const auto head = parse_head(file_.read(place, BlockHead::bytes))) {
        if (head->kind == BlockKind::index) {
            read_index(place);
            return;
        }
        const auto content = content_of(*head, place + BlockHead::bytes);
        const bool follows = head->kind == BlockKind::frames && head->first_frame == frames_ && head->first_row == rows;
        if (!content || !follows) return;
        index_.push_back({place, frames_});
        rows += head->rows;
        if (rows == description_.rows) frames_ += head->frames, rows = 0;
        place += BlockHead::bytes + content->size();
    }
}

std::optional<std::string> TrajectoryReader::content_of(const BlockHead& head, std::uint64_t place) const {
    if (place > file_.size() || head.content_bytes > file_.size() - place) return std::nullopt;
    std::string content = file_.read(place, head.content_bytes);
    if (content.size() != head.content_bytes || hash_of(content) != head.content_hash) return std::nullopt;
    return content;
}

void TrajectoryReader::frame(std::uint64_t number, Frame& out) {
    const auto after = std::upper_bound(index_.begin(), index_.end(), number,
                                        [](std::uint64_t n, const IndexEntry& entry) { return n < entry.first_frame; });
    if (number >= frames_ || after == index_.begin()) fail(fmt::format("it has no frame {}", number));
    const std::uint64_t first_frame = std::prev(after)->first_frame;
    auto entry = after;
    while (entry != index_.begin() && std::prev(entry)->first_frame == first_frame) --entry;
    out.precision = description_.precision;
    out.shape = description_.shape;
    out.positions.clear();
    out.velocities.clear();
    for (; out.positions.size() < description_.rows; ++entry) {
        if (entry == index_.end()) fail(fmt::format("frame {} is not complete", number));
        append_rows(chunk(static_cast<std::size_t>(entry - index_.begin()), number), number, out);
    }
}

void TrajectoryReader::append_rows(const FrameBlock& block, std::uint64_t frame, Frame& out) const {
    if (block.first_row != out.positions.size() || block.rows > description_.rows - out.positions.size())
        fail(fmt::format("frame {} is not complete", frame));
    const std::size_t moment = frame - block.first_frame;
    out.step = block.moments[moment].step;
    out.time = block.moments[moment].time;
    const auto append = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
        const auto begin = from.begin() + static_cast<std::ptrdiff_t>(moment * block.rows);
        to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(block.rows));
    };
    append(block.positions, out.positions);
    append(block.velocities, out.velocities);
}

const FrameBlock& TrajectoryReader::chunk(std::size_t entry, std::uint64_t frame) {
    if (!read_ || read_entry_ != entry) {
        read_.reset();
        const std::uint64_t place = index_[entry].place;
        const auto head = parse_head(file_.read(place, BlockHead::bytes));
        const auto content =
            head && head->kind == BlockKind::frames ? content_of(*head, place + BlockHead::bytes) : std::nullopt;
        if (content) read_ = parse_chunk(*head, *content, description_.precision);
        read_entry_ = entry;
    }
    if (!read_ || frame < read_->first_frame || frame - read_->first_frame >= read_->moments.size())
        fail(fmt::format("it is damaged; frame {} of {} cannot be read", frame, frames_));
    return *read_;
}

RunDescription TrajectoryReader::run() const {
    try {
        return parse_run(description_.run);
    } catch (const std::exception& error) {
        fail(fmt::format("its run, written by {}, cannot be read: {}", description_.program, error.what()));
    }
}

void TrajectoryReader::fail(const std::string& what) const {
    throw FileError(fmt::format("cannot read '{}': {}", file_.name(), what));
}

}  // namespace steplab
