#include "io/trajectory_reader.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/trajectory_chunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace steplab {

using namespace trajectory;

bool TrajectoryReader::reads(const InputFile& file) { return file.read(0, magic.size()) == magic; }

TrajectoryReader::TrajectoryReader(InputFile file) : file_(std::move(file)) {
    if (!reads(file_)) fail("it is not a trajectory file of steplab");
    const auto version = parse_signature(file_.read(0, signature_bytes));
    if (!version) fail("its format version is not supported; it may be of a newer steplab");
    version_ = *version;
    read_description();
    const auto place =
        parse_ending(file_.read(file_.size() - std::min(file_.size(), std::uint64_t{ending_bytes}), ending_bytes));
    if (!place || !read_index(*place)) search(first_chunk_);
}

void TrajectoryReader::read_description() {
    const auto head = parse_head(file_.read(signature_bytes, BlockHead::bytes));
    const std::uint64_t place = signature_bytes + BlockHead::bytes;
    auto content = head && head->kind == BlockKind::description ? content_of(*head, place) : std::nullopt;
    if (!content) fail("it is truncated or damaged at its beginning");
    try {
        description_ = parse_description(*content, version_);
    } catch (const std::exception&) {
        fail("the description of its run is not valid");
    }
    first_chunk_ = place + content->size();
    description_text_ = std::move(*content);
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

/// The content if it is there, whole and unchanged. Files may claim to be large where they hold nothing (sparse files):
/// they are read in pieces up to the first one of zeros, which no content has.
std::optional<std::string> TrajectoryReader::content_of(const BlockHead& head, std::uint64_t place) const {
    constexpr std::uint64_t piece = std::uint64_t{1} << 20;
    if (place > file_.size() || head.content_bytes > file_.size() - place) return std::nullopt;
    if (head.kind == BlockKind::frames && head.content_bytes > most_content_bytes()) return std::nullopt;
    std::string content;
    try {
        while (content.size() < head.content_bytes) {
            const auto part = file_.read(place + content.size(), std::min(piece, head.content_bytes - content.size()));
            const bool hole = part.size() == piece && part.find_first_not_of('\0') == std::string::npos;
            if (part.empty() || hole) return std::nullopt;
            content += part;
        }
    } catch (const std::bad_alloc&) {
        fail("there is not enough memory for it");
    }
    if (hash_of(content) != head.content_hash) return std::nullopt;
    return content;
}

FrameBlock TrajectoryReader::block_after(std::size_t entry, std::uint64_t& frame, std::uint64_t& row) {
    if (entry >= index_.size()) fail(fmt::format("frame {} is not complete", frame));
    chunk(entry, frame);
    FrameBlock block = std::move(*read_);
    read_.reset();
    const bool whole = row == 0 && block.rows == description_.rows;
    if (block.first_frame != frame || block.first_row != row || block.rows > description_.rows - row ||
        (!whole && block.moments.size() != 1) || block.moments.size() > frames_ - frame)
        fail(fmt::format("frame {} is not complete", frame));
    row = whole ? 0 : (row + block.rows) % description_.rows;
    if (row == 0) frame += block.moments.size();
    return block;
}

/// Of the chunks that hold this frame.
std::size_t TrajectoryReader::first_entry(std::uint64_t frame) const {
    const auto after = std::upper_bound(index_.begin(), index_.end(), frame,
                                        [](std::uint64_t n, const IndexEntry& entry) { return n < entry.first_frame; });
    if (frame >= frames_ || after == index_.begin()) fail(fmt::format("it has no frame {}", frame));
    const std::uint64_t first_frame = std::prev(after)->first_frame;
    auto entry = after;
    while (entry != index_.begin() && std::prev(entry)->first_frame == first_frame) --entry;
    return static_cast<std::size_t>(entry - index_.begin());
}

FrameBlock::Moment TrajectoryReader::moment(std::uint64_t number) {
    const FrameBlock& block = chunk(first_entry(number), number);
    return block.moments[number - block.first_frame];
}

void TrajectoryReader::frame(std::uint64_t number, Frame& out) {
    auto entry = index_.begin() + static_cast<std::ptrdiff_t>(first_entry(number));
    const std::uint64_t first_frame = entry->first_frame;
    for (auto* vectors : {&out.positions, &out.displacements, &out.velocities}) vectors->clear();
    Shape shape;
    shape.box = scene().box;
    shape.corner = scene().corner;
    for (; out.velocities.size() < description_.rows; ++entry) {
        if (entry == index_.end() || entry->first_frame != first_frame)
            fail(fmt::format("frame {} is not complete", number));
        const FrameBlock& block = chunk(static_cast<std::size_t>(entry - index_.begin()), number);
        append_rows(block, number, out);
        shape.roles.insert(shape.roles.end(), block.roles.begin(), block.roles.end());
        shape.masses.insert(shape.masses.end(), block.masses.begin(), block.masses.end());
    }
    out.precision = scene().precision;
    out.reference = scene().reference.value_or(Lattice());
    out.mass = scene().mass;
    out.values.reset();
    out.cell.reset();
    out.shape = std::make_shared<const Shape>(std::move(shape));
}

void TrajectoryReader::append_rows(const FrameBlock& block, std::uint64_t frame, Frame& out) const {
    if (block.first_row != out.velocities.size()) fail(fmt::format("frame {} is not complete", frame));
    const std::size_t moment = frame - block.first_frame;
    out.step = block.moments[moment].step;
    out.time = block.moments[moment].time;
    const auto append = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
        if (from.empty()) return;
        const auto begin = from.begin() + static_cast<std::ptrdiff_t>(moment * block.rows);
        to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(block.rows));
    };
    append(block.positions, out.positions);
    append(block.displacements, out.displacements);
    append(block.velocities, out.velocities);
}

/// The chunk with all that is known of its rows, positions too.
const FrameBlock& TrajectoryReader::chunk(std::size_t entry, std::uint64_t frame) {
    if (!read_ || read_entry_ != entry) {
        read_.reset();
        const std::uint64_t place = index_[entry].place;
        const auto head = parse_head(file_.read(place, BlockHead::bytes));
        const auto content =
            head && head->kind == BlockKind::frames ? content_of(*head, place + BlockHead::bytes) : std::nullopt;
        if (content) read_ = parse_chunk(*head, *content, description_.scene.precision, version_);
        read_entry_ = entry;
        if (read_ && !complete_rows(*read_)) read_.reset();
    }
    if (!read_ || frame < read_->first_frame || frame - read_->first_frame >= read_->moments.size())
        fail(fmt::format("it is damaged; frame {} of {} cannot be read", frame, frames_));
    return *read_;
}

/// False if a frame has no such rows.
bool TrajectoryReader::complete_rows(FrameBlock& block) const {
    if (block.first_row > description_.rows || block.rows > description_.rows - block.first_row) return false;
    block.scene = description_.scene;
    block.frame_rows = description_.rows;
    description_.list.name(block);
    block.complete({.positions = true});
    return true;
}

void TrajectoryReader::require(const Columns& columns) const {
    if (version_ == Version::positions && parts_of(columns).displacements)
        fail("it holds no displacements (ux, uy, uz): its format is version 1, which has positions alone");
}

RunDescription TrajectoryReader::run() const {
    try {
        return parse_run(description_.run);
    } catch (const std::exception& error) {
        fail(fmt::format("its run, written by {}, cannot be read: {}", shown(description_.program),
                         shown(error.what())));
    }
}

void TrajectoryReader::fail(const std::string& what) const {
    throw FileError(fmt::format("cannot read '{}': {}", shown(file_.name()), what));
}

}  // namespace steplab
