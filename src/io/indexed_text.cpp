#include "io/indexed_text.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "io/scene_file.hpp"
#include "io/text_input.hpp"
#include "io/text_trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace steplab {

namespace {

constexpr std::uint64_t piece_of_text = std::uint64_t{1} << 20;

constexpr const char* unknown_scene =
    "steplab = 1\n"
    "title = \"Particles of a file\"\n"
    "teaches = \"Positions and velocities of a file that does not describe its run.\"\n"
    "[[particles]]\n"
    "position = [0, 0, 0]\n";

/// As groups, numbered as they first appear; none if all are of one.
std::vector<std::uint16_t> groups_of(const std::vector<std::uint64_t>& types) {
    constexpr std::size_t most = 65535;
    std::map<std::uint64_t, std::uint16_t> known;
    std::vector<std::uint16_t> groups;
    for (const std::uint64_t type : types) {
        const auto next = static_cast<std::uint16_t>(std::min(known.size(), most));
        groups.push_back(known.emplace(type, next).first->second);
    }
    return known.size() > 1 ? groups : std::vector<std::uint16_t>{};
}

std::shared_ptr<const Shape> shape_of(FrameBlock& block) {
    Shape shape;
    shape.roles = std::move(block.roles);
    shape.roles.resize(block.rows, Role::moving);
    shape.masses = std::move(block.masses);
    shape.groups = groups_of(block.types);
    shape.box = block.scene.box;
    shape.corner = block.scene.corner;
    return std::make_shared<const Shape>(std::move(shape));
}

}  // namespace

RunDescription unknown_run(const std::string& file) {
    return describe(scene_from({{.name = "", .content = unknown_scene}}, file));
}

IndexedText::IndexedText(const std::string& file) : name_(file) {
    open(InputFile(file));
    while (index_.size() < 2 && has_more()) {
        check_interruption();
        look_at_piece();
    }
    if (!index_.empty()) return;
    if (!damaged_.empty()) throw FileError(damaged_);
    throw FileError(fmt::format("cannot read '{}': {}", shown(name_), fault().empty() ? "it holds no frame" : fault()));
}

void IndexedText::open(InputFile given) {
    TextInput begin(InputFile(given.name()));
    finder_ = frame_finder(begin);
    if (compression_in(given.read(0, 4)) == Compression::none) {
        file_ = std::make_shared<InputFile>(std::move(given));
    } else {
        restored_.emplace(std::move(given));
        file_ = restored_->file();
    }
}

bool IndexedText::look_on(std::uint64_t bytes) {
    const std::uint64_t frames_before = frames();
    const std::string fault_before = fault();
    if (!restored_ && file_->grow()) {
        grown_ = true;
        stuck_ = false;
    }
    for (const std::uint64_t end = place_ + bytes; has_more() && place_ < end;) look_at_piece();
    return frames() != frames_before || fault() != fault_before;
}

double IndexedText::looked_through() const {
    if (!has_more()) return 1;
    if (is_restoring()) return restored_->part();
    return static_cast<double>(place_) / static_cast<double>(file_->size());
}

/// What lies behind the last whole line is looked at again once there is more.
std::string IndexedText::fault() const {
    if (!broken_.empty()) return broken_;
    if (has_more()) return {};
    if (!damaged_.empty()) return damaged_;
    if (!finder_->within() && place_ == file_->size()) return {};
    return fmt::format("line {}: the file ends within a frame: it is truncated, or not written yet", lines_ + 1);
}

FrameBlock::Moment IndexedText::moment(std::uint64_t number) const {
    FrameBlock::Moment moment = index_[number].moment;
    const bool has_times = index_.size() < 2 || index_[0].moment.time != index_[1].moment.time;
    if (!has_times) moment.time = static_cast<double>(moment.step);
    return moment;
}

/// The whole lines of it; false if there is none.
bool IndexedText::look_at_piece() {
    restore_piece();
    const std::string text = file_->read(place_, piece_of_text);
    std::size_t begin = 0;
    for (std::size_t end = 0; broken_.empty() && (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        take_line(std::string_view(text).substr(begin, end - begin));
        place_ += end + 1 - begin;
        ++lines_;
    }
    if (begin == 0 && text.size() > longest_text_line && broken_.empty())
        broken_ = fmt::format("line {}: it is too long for a text of particles", lines_ + 1);
    stuck_ = begin == 0;
    if (broken_.empty() && !is_restoring() && (stuck_ || place_ == file_->size())) look_at_end();
    return begin > 0;
}

/// What cannot be restored ends the file, of which all before is there.
void IndexedText::restore_piece() {
    if (!is_restoring()) return;
    try {
        restored_->restore(piece_of_text);
    } catch (const FileError& error) {
        damaged_ = error.what();
    }
}

/// A file that is not being written may have a last line without an end, and its last frame ends with it.
void IndexedText::look_at_end() {
    if (grown_) return;
    const std::string last = file_->read(place_, longest_text_line);
    if (!last.empty() && damaged_.empty() && finder_->may_end_with(last)) {
        take_line(last);
        place_ += last.size();
        open_ = true;
    }
    if (const auto frame = finder_->at_end()) add(*frame);
}

void IndexedText::take_line(std::string_view text) {
    if (std::exchange(open_, false)) {  // the end of a line that was taken
        index_.back().end = std::max(index_.back().end, place_ + text.size());
        return;
    }
    const std::uint64_t end = place_ + text.size() + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    try {
        found_.clear();
        finder_->take({text, place_, end, lines_}, found_);
        for (const FoundFrame& frame : found_) {
            if (broken_.empty()) add(frame);
        }
    } catch (const FileError& error) {
        broken_ = error.what();
    }
}

void IndexedText::add(const FoundFrame& frame) {
    if (!index_.empty() && frame.rows != rows()) {
        broken_ = fmt::format("line {}: frame {} has {} rows, the ones before {}", frame.line + 1, index_.size() + 1,
                              frame.rows, rows());
        return;
    }
    index_.push_back(frame);
}

FrameBlock IndexedText::block(std::uint64_t number) const {
    const FoundFrame& at = index_.at(number);
    const auto text = finder_->reader(TextInput(name_, file_, at.begin, at.end, at.line));
    text->require({Column::x, Column::y, Column::z});
    FrameBlock block;
    text->next(block);
    return block;
}

void IndexedText::frame(std::uint64_t number, Frame& out) const {
    FrameBlock read = block(number);
    const FrameBlock::Moment at = moment(number);
    out.step = at.step;
    out.time = at.time;
    out.precision = read.scene.precision;
    out.mass = read.scene.mass;
    out.cell = read.scene.cell;
    out.positions = std::move(read.positions);
    out.velocities = std::move(read.velocities);
    out.velocities.resize(out.positions.size());
    out.displacements.clear();
    out.values.reset();
    if (!read.values.empty()) out.values = std::make_shared<const std::vector<ParticleValues>>(std::move(read.values));
    out.shape = shape_of(read);
}

std::vector<std::size_t> IndexedText::particles(std::uint64_t number) const {
    FrameBlock read = block(number);
    if (!read.particles.empty()) return std::move(read.particles);
    std::vector<std::size_t> rows(read.rows);
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
}

}  // namespace steplab
