#include "io/dump_trajectory.hpp"

#include "core/shown.hpp"
#include "io/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace steplab {

namespace {

constexpr std::string_view axes = "xyz";

/// In a given order.
template <class Value>
void reorder(const std::vector<std::size_t>& order, std::vector<Value>& values) {
    if (values.empty()) return;
    std::vector<Value> sorted(values.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = values[order[i]];
    values = std::move(sorted);
}

}  // namespace

DumpTrajectory::DumpTrajectory(TextInput input) : TextTrajectory(std::move(input)) {
    has_head_ = read_head();
    know_columns();
}

/// Each frame names its own.
void DumpTrajectory::know_columns() {
    columns_ = {Column::x, Column::y, Column::z};
    if (velocity_) columns_.insert(columns_.end(), {Column::vx, Column::vy, Column::vz});
}

/// False at the end of the file.
bool DumpTrajectory::read_head() {
    has_step_ = has_rows_ = has_box_ = false;
    time_.reset();
    while (const auto line = input_.line()) {
        if (words_of(*line).empty() && !has_step_) continue;
        constexpr std::string_view begin = "ITEM: ", atoms = "ITEM: ATOMS";
        if (!line->starts_with(begin)) input_.fail("a frame of a LAMMPS dump begins with ITEM: TIMESTEP");
        if (!line->starts_with(atoms)) {
            read_item(line->substr(begin.size()));
            continue;
        }
        if (!has_step_ || !has_rows_ || !has_box_)
            input_.fail("ITEM: ATOMS must follow TIMESTEP, NUMBER OF ATOMS and BOX BOUNDS");
        read_columns(line->substr(atoms.size()));
        moment_.time = time_.value_or(static_cast<double>(moment_.step));
        return true;
    }
    if (has_step_) input_.fail("it ends within the head of a frame");
    return false;
}

void DumpTrajectory::read_item(std::string_view item) {
    if (item == "TIMESTEP") {
        moment_.step = number<std::uint64_t>(numbers_line(1)[0]);
        has_step_ = true;
    } else if (item == "TIME") {
        time_ = number<double>(numbers_line(1)[0]);
    } else if (item == "NUMBER OF ATOMS") {
        rows_ = number<std::uint64_t>(numbers_line(1)[0]);
        if (rows_ == 0) input_.fail("a frame has no atoms");
        has_rows_ = true;
    } else if (item.starts_with("BOX BOUNDS")) {
        read_box(item);
    } else if (item == "UNITS") {
        const auto words = words_of(next_line());
        units_ = words.empty() ? "" : words.front();
    } else {
        next_line();  // of what later versions may add
    }
}

std::string_view DumpTrajectory::next_line() {
    const auto line = input_.line();
    if (!line) input_.fail("it ends within the head of a frame");
    return *line;
}

std::vector<std::string_view> DumpTrajectory::numbers_line(std::size_t least) {
    auto words = words_of(next_line());
    if (words.size() < least) input_.fail(fmt::format("{} numbers belong here", least));
    return words;
}

/// "BOX BOUNDS pp pp ff", with a tilt "BOX BOUNDS xy xz yz pp pp pp", or "BOX BOUNDS abc origin pp pp pp".
void DumpTrajectory::read_box(std::string_view item) {
    const auto words = words_of(item);
    const auto has = [&](std::string_view word) { return std::find(words.begin(), words.end(), word) != words.end(); };
    box_ = {};
    for (std::size_t axis = 0; axis < 3; ++axis)
        box_.periodic[axis] = words.size() >= 5 && words[words.size() - 3 + axis] == "pp";
    has("abc") ? read_edges() : read_bounds(has("xy"));
    const auto& [a, b, c] = box_.edges;
    box_.leans = Vec3{0, a.y, a.z} != Vec3{} || Vec3{b.x, 0, b.z} != Vec3{} || Vec3{c.x, c.y, 0} != Vec3{};
    if (!(a.x >= 0 && b.y >= 0 && c.z >= 0) && !has("abc")) input_.fail("the sides of its box are negative");
    if (box_.leans && !Cell{box_.edges, box_.low, {}}.is_whole()) input_.fail("its box is flat");
    has_box_ = true;
}

/// Of a tilted box the bounds are those of all that leans.
void DumpTrajectory::read_bounds(bool tilted) {
    std::array<double, 3> low{}, high{}, tilt{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto numbers = numbers_line(tilted ? 3 : 2);
        low[axis] = number<double>(numbers[0]);
        high[axis] = number<double>(numbers[1]);
        if (tilted) tilt[axis] = number<double>(numbers[2]);
    }
    const auto [xy, xz, yz] = tilt;
    low[0] -= std::min({0.0, xy, xz, xy + xz});
    high[0] -= std::max({0.0, xy, xz, xy + xz});
    low[1] -= std::min(0.0, yz);
    high[1] -= std::max(0.0, yz);
    box_.low = {low[0], low[1], low[2]};
    box_.edges = {Vec3{high[0] - low[0], 0, 0}, Vec3{xy, high[1] - low[1], 0}, Vec3{xz, yz, high[2] - low[2]}};
}

/// Each line has an edge, and a component of the corner.
void DumpTrajectory::read_edges() {
    std::array<double, 3> low{};
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const auto numbers = numbers_line(4);
        box_.edges[edge] = {number<double>(numbers[0]), number<double>(numbers[1]), number<double>(numbers[2])};
        low[edge] = number<double>(numbers[3]);
    }
    box_.low = {low[0], low[1], low[2]};
}

void DumpTrajectory::put_box(FileScene& scene) const {
    if (box_.leans) {
        scene.cell = Cell{box_.edges, box_.low, box_.periodic};
        return;
    }
    const auto side = [&](std::size_t axis, double length) { return box_.periodic[axis] ? length : 0; };
    scene.box = {side(0, box_.edges[0].x), side(1, box_.edges[1].y), side(2, box_.edges[2].z)};
    scene.corner = box_.low;
}

std::optional<std::size_t> DumpTrajectory::column(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

/// The columns of a vector with this letter, if there are all three.
std::optional<std::array<std::size_t, 3>> DumpTrajectory::vector_of(char letter) const {
    std::array<std::size_t, 3> words{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto found = column(fmt::format("{}{}", letter, axes[axis]));
        if (!found) return std::nullopt;
        words[axis] = *found;
    }
    return words;
}

Vec3 DumpTrajectory::vector_in(const std::array<std::size_t, 3>& words) const {
    return {number<double>(words_[words[0]]), number<double>(words_[words[1]]), number<double>(words_[words[2]])};
}

/// What is unwrapped in the file goes before what has to be.
DumpTrajectory::Coordinate DumpTrajectory::coordinate(char axis) const {
    for (const std::string_view ending : {"u", "su", "", "s"}) {
        const auto word = column(fmt::format("{}{}", axis, ending));
        if (!word) continue;
        Coordinate found{*word, ending.starts_with('s')};
        if (!ending.ends_with('u')) found.image = column(fmt::format("i{}", axis));
        return found;
    }
    input_.fail(fmt::format("its columns have no position along {0}: {0}, {0}u, {0}s or {0}su", axis));
}

void DumpTrajectory::read_columns(std::string_view names) {
    const auto words = words_of(names);
    names_.assign(words.begin(), words.end());
    for (std::size_t axis = 0; axis < 3; ++axis) coordinates_[axis] = coordinate(axes[axis]);
    const auto scaled = [this](std::size_t axis) { return coordinates_[axis].scaled; };
    if (box_.leans && (scaled(0) != scaled(1) || scaled(1) != scaled(2)))
        input_.fail("in a tilted box all coordinates or none are scaled");
    velocity_ = vector_of('v');
    force_ = vector_of('f');
    id_ = column("id");
    type_ = column("type");
    mass_ = column("mass");
    read_other_columns();
}

/// Those that say no more than where an atom is, how it moves and what it is are not among them.
void DumpTrajectory::read_other_columns() {
    std::vector<std::size_t> used;
    for (const auto& [word, scaled, image] : coordinates_) {
        used.push_back(word);
        if (image) used.push_back(*image);
    }
    if (velocity_) used.insert(used.end(), velocity_->begin(), velocity_->end());
    for (const auto& word : {id_, type_, mass_}) {
        if (word) used.push_back(*word);
    }
    values_.clear();
    others_.clear();
    for (std::size_t word = 0; word < names_.size(); ++word) {
        if (std::find(used.begin(), used.end(), word) != used.end()) continue;
        values_.column(names_[word]);
        others_.push_back(word);
    }
}

bool DumpTrajectory::read(FrameBlock& frame) {
    if (std::exchange(used_, true)) has_head_ = read_head();
    if (!has_head_) return false;
    know_columns();
    frame.moments.push_back(moment_);
    put_box(frame.scene);
    frame.scene.units = units_;
    ids_.clear();
    forces_.clear();
    for (std::uint64_t row = 0; row < rows_; ++row) {
        const auto line = input_.line();
        if (!line) input_.fail(fmt::format("it ends after {} of the {} atoms of a frame", row, rows_));
        read_row(frame, *line);
    }
    values_.put_into(frame.values);
    if (id_) sort(frame);
    return true;
}

void DumpTrajectory::read_row(FrameBlock& frame, std::string_view line) {
    split(line, words_);
    if (words_.size() != names_.size())
        input_.fail(fmt::format("it has {} columns; by ITEM: ATOMS it should have {}", words_.size(), names_.size()));
    add_row(frame);
    frame.positions.back() = position();
    if (velocity_ && !frame.velocities.empty()) frame.velocities.back() = vector_in(*velocity_);
    if (force_) forces_.push_back(vector_in(*force_));
    if (id_) ids_.push_back(number<std::uint64_t>(words_[*id_]));
    if (id_ && ids_.back() == 0) input_.fail("ids of atoms count from 1");
    if (type_) frame.types.push_back(number<std::uint64_t>(words_[*type_]));
    if (mass_) frame.masses.push_back(number<double>(words_[*mass_]));
    for (std::size_t other = 0; other < others_.size(); ++other) values_.add(other, words_[others_[other]]);
}

/// Image flags count boxes, of which each is one of its edges further.
Vec3 DumpTrajectory::position() const {
    std::array<double, 3> at{}, edges{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Coordinate& from = coordinates_[axis];
        const double value = number<double>(words_[from.word]);
        if (from.image) edges[axis] = number<double>(words_[*from.image]);
        from.scaled ? edges[axis] += value : at[axis] = value;
    }
    const auto low = [&](std::size_t axis, double of_box) { return coordinates_[axis].scaled ? of_box : at[axis]; };
    Vec3 place{low(0, box_.low.x), low(1, box_.low.y), low(2, box_.low.z)};
    for (std::size_t axis = 0; axis < 3; ++axis) {  // what is not asked for adds no rounding
        if (edges[axis] != 0) place = place + edges[axis] * box_.edges[axis];
    }
    return place;
}

/// By their ids, each of which is there once.
void DumpTrajectory::sort(FrameBlock& frame) {
    std::vector<std::size_t> order(ids_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!std::is_sorted(ids_.begin(), ids_.end()))
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
    reorder(order, ids_);
    if (const auto twice = std::adjacent_find(ids_.begin(), ids_.end()); twice != ids_.end())
        input_.fail(fmt::format("atom {} is twice in the frame that ends here", *twice));
    reorder(order, frame.positions);
    reorder(order, frame.velocities);
    reorder(order, frame.masses);
    reorder(order, frame.types);
    reorder(order, forces_);
    for (ParticleValues& column : frame.values) reorder(order, column.values);
    for (const std::uint64_t id : ids_) frame.particles.push_back(static_cast<std::size_t>(id - 1));
}

}  // namespace steplab
