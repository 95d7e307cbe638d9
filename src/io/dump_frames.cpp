#include "io/dump_frames.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/dump_trajectory.hpp"
#include "io/output_file.hpp"
#include "io/temporary_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

namespace steplab {

namespace {

constexpr std::uint64_t piece_of_dump = std::uint64_t{1} << 20;
/// A line of a dump is shorter.
constexpr std::size_t longest_line_of_dump = std::size_t{1} << 16;

/// The whole word as a number; none if it is not one.
template <class Number>
std::optional<Number> number_in(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    Number value{};
    const auto result = std::from_chars(line.data(), line.data() + line.size(), value);
    if (result.ec != std::errc{} || result.ptr != line.data() + line.size()) return std::nullopt;
    return value;
}

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

}  // namespace

bool DumpFrames::reads(const std::string& file) { return DumpTrajectory::begins(TextInput(InputFile(file)).peek(8)); }

/// A compressed text is restored to where it needs no name.
std::shared_ptr<InputFile> DumpFrames::opened(const std::string& file) {
    InputFile given(file);
    if (compression_in(given.read(0, 4)) == Compression::none) return std::make_shared<InputFile>(std::move(given));
    TextInput text(std::move(given));
    const TemporaryFolder folder;
    const std::string path = folder.file("dump");
    OutputFile out(path);
    for (std::string part; !(part = std::string(text.peek(piece_of_dump))).empty(); text.drop(part.size())) {
        check_interruption();
        out.write(part);
    }
    out.commit();
    return std::make_shared<InputFile>(path);
}

DumpFrames::DumpFrames(const std::string& file) : name_(file), file_(opened(file)) {
    while (index_.empty() && has_more()) {
        check_interruption();
        stuck_ = !look_at_piece();
    }
    if (!index_.empty()) return;
    throw FileError(fmt::format("cannot read '{}': {}", shown(name_),
                                broken_.empty() ? "it holds no whole frame of a LAMMPS dump" : broken_));
}

bool DumpFrames::look_on(std::uint64_t bytes) {
    const std::uint64_t frames_before = frames();
    const std::string fault_before = fault();
    if (file_->grow()) stuck_ = false;
    for (const std::uint64_t end = place_ + bytes; has_more() && place_ < end;) stuck_ = !look_at_piece();
    return frames() != frames_before || fault() != fault_before;
}

double DumpFrames::looked_through() const {
    if (!has_more()) return 1;
    return static_cast<double>(place_) / static_cast<double>(file_->size());
}

/// What lies behind the last whole line is looked at again once there is more.
std::string DumpFrames::fault() const {
    if (!broken_.empty()) return broken_;
    if (has_more() || (!within_ && place_ == file_->size())) return {};
    return fmt::format("line {}: the file ends within a frame: it is truncated, or not written yet", lines_ + 1);
}

/// The whole lines of it; false if there is none.
bool DumpFrames::look_at_piece() {
    const std::string text = file_->read(place_, piece_of_dump);
    std::size_t begin = 0;
    while (broken_.empty()) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) break;
        take_line(std::string_view(text).substr(begin, end - begin));
        ++lines_;
        place_ += end + 1 - begin;
        begin = end + 1;
    }
    if (begin == 0 && text.size() > longest_line_of_dump && broken_.empty())
        broken_ = fmt::format("line {}: it is too long for a LAMMPS dump", lines_ + 1);
    return begin > 0;
}

void DumpFrames::take_line(std::string_view line) {
    if (next_ == Next::item) return take_item(line);
    if (next_ == Next::step || next_ == Next::rows) {
        const auto value = number_in<std::uint64_t>(line);
        if (!value)
            broken_ = fmt::format("line {}: \"{}\" is not a number that can stand here", lines_ + 1, shown(line));
        (next_ == Next::step ? entry_.moment.step : frame_rows_) = value.value_or(0);
    }
    if (next_ == Next::time) time_ = number_in<double>(line);
    if (--left_ > 0) return;
    const bool whole = next_ == Next::atoms;
    next_ = Next::item;
    if (whole) end_frame();
}

void DumpFrames::take_item(std::string_view line) {
    constexpr std::string_view begin = "ITEM: ";
    if (!line.starts_with(begin)) {
        const bool empty = line.find_first_not_of(" \t\r") == std::string_view::npos;
        if (!empty) broken_ = fmt::format("line {}: a frame of a LAMMPS dump begins with ITEM: TIMESTEP", lines_ + 1);
        return;
    }
    line.remove_prefix(begin.size());
    while (line.ends_with('\r')) line.remove_suffix(1);
    if (!within_) entry_ = {place_, lines_, {}}, frame_rows_ = 0, time_.reset();
    within_ = true;
    left_ = 1;
    if (line == "TIMESTEP") {
        next_ = Next::step;
    } else if (line == "TIME") {
        next_ = Next::time;
    } else if (line == "NUMBER OF ATOMS") {
        next_ = Next::rows;
    } else if (line.starts_with("ATOMS")) {
        next_ = Next::atoms;
        left_ = frame_rows_;
        if (frame_rows_ == 0) broken_ = fmt::format("line {}: a frame has no atoms", lines_ + 1);
    } else {
        next_ = Next::other;
        left_ = line.starts_with("BOX BOUNDS") ? 3 : 1;
    }
}

void DumpFrames::end_frame() {
    within_ = false;
    entry_.moment.time = time_.value_or(static_cast<double>(entry_.moment.step));
    const std::uint64_t number = index_.size() + 1;
    if (!index_.empty() && frame_rows_ != rows_)
        broken_ = fmt::format("line {}: frame {} has {} atoms, the ones before {}", entry_.line + 1, number,
                              frame_rows_, rows_);
    if (!index_.empty() && entry_.moment.step < index_.back().moment.step)
        broken_ = fmt::format("line {}: frame {} is of step {}, the one before of step {}", entry_.line + 1, number,
                              entry_.moment.step, index_.back().moment.step);
    if (!broken_.empty()) return;
    rows_ = frame_rows_;
    index_.push_back(entry_);
}

FrameBlock DumpFrames::block(std::uint64_t number, std::vector<std::uint64_t>& types) const {
    const Entry& entry = index_.at(number);
    DumpTrajectory text(TextInput(name_, file_, entry.place, entry.line));
    FrameBlock block;
    text.next(block);
    types = text.types();
    return block;
}

void DumpFrames::frame(std::uint64_t number, Frame& out) const {
    std::vector<std::uint64_t> types;
    FrameBlock read = block(number, types);
    out.step = read.moments.front().step;
    out.time = index_[number].moment.time;
    out.precision = Precision::double_;
    out.positions = std::move(read.positions);
    out.velocities = std::move(read.velocities);
    out.velocities.resize(out.positions.size());
    out.displacements.clear();
    Shape shape;
    shape.roles.assign(out.positions.size(), Role::moving);
    shape.masses = std::move(read.masses);
    shape.groups = groups_of(types);
    shape.box = read.scene.box;
    shape.corner = read.scene.corner;
    out.shape = std::make_shared<const Shape>(std::move(shape));
}

std::vector<std::size_t> DumpFrames::particles(std::uint64_t number) const {
    std::vector<std::uint64_t> types;
    FrameBlock read = block(number, types);
    if (read.particles.empty()) {
        for (std::size_t row = 0; row < read.rows; ++row) read.particles.push_back(row);
    }
    return std::move(read.particles);
}

}  // namespace steplab
