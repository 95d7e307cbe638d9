#include "io/dump_text.hpp"

#include "io/number_append.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace steplab {

namespace {

void append_numbers(std::string& text, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
        text += ' ';
        append_number(text, number);
    }
}

std::array<double, 3> components(Vec3 vector) { return {vector.x, vector.y, vector.z}; }

void append_flags(std::string& text, const std::array<bool, 3>& periodic) {
    for (const bool along : periodic) text += along ? " pp" : " ff";
}

/// As LAMMPS has it: the first edge along x, the second in the plane of x and y; with other edges as they are.
void append_cell(std::string& text, const Cell& cell) {
    const auto& [a, b, c] = cell.edges;
    const std::array<double, 3> low = components(cell.corner);
    const bool is_restricted = a.y == 0 && a.z == 0 && b.z == 0 && a.x > 0 && b.y > 0 && c.z > 0;
    text += is_restricted ? "ITEM: BOX BOUNDS xy xz yz" : "ITEM: BOX BOUNDS abc origin";
    append_flags(text, cell.periodic);
    const std::array<double, 3> sides{a.x, b.y, c.z}, tilts{b.x, c.x, c.y};
    const std::array<double, 3> least{std::min({0.0, b.x, c.x, b.x + c.x}), std::min(0.0, c.y), 0};
    const std::array<double, 3> most{std::max({0.0, b.x, c.x, b.x + c.x}), std::max(0.0, c.y), 0};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = cell.edges[i];
        const auto [first, second, third] =
            is_restricted ? std::array{low[i] + least[i], low[i] + sides[i] + most[i], tilts[i]} : components(edge);
        text += '\n';
        append_number(text, first);
        append_numbers(text, {second, third});
        if (!is_restricted) append_numbers(text, {low[i]});
    }
}

void append_box(std::string& text, const FrameBlock& frame) {
    if (frame.scene.cell) return append_cell(text, *frame.scene.cell);
    const auto sides = components(frame.scene.box), corner = components(frame.scene.corner);
    text += "ITEM: BOX BOUNDS";
    append_flags(text, {sides[0] > 0, sides[1] > 0, sides[2] > 0});
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = corner[axis], high = corner[axis] + sides[axis];
        if (sides[axis] == 0) low = high = components(frame.positions.front())[axis];
        for (const Vec3 position : frame.positions) {
            if (sides[axis] > 0) break;
            low = std::min(low, components(position)[axis]);
            high = std::max(high, components(position)[axis]);
        }
        text += '\n';
        append_number(text, low);
        append_numbers(text, {high});
    }
}

/// The type of a particle of another program's file, or one for each role.
std::uint64_t type_of(const FrameBlock& frame, std::size_t row) {
    if (!frame.types.empty()) return frame.types[row];
    return frame.roles.empty() ? 1 : 1 + static_cast<std::uint64_t>(frame.roles[row]);
}

/// Those that do not have the name of a column that every dump of ours has, nor say once more where particles are: such
/// columns would be read in place of, or together with, the positions that are written.
std::vector<const ParticleValues*> further_columns(const FrameBlock& frame) {
    constexpr std::array<std::string_view, 21> own{"id", "type", "mass", "x",   "y",  "z",  "xu",
                                                   "yu", "zu",   "vx",   "vy",  "vz", "xs", "ys",
                                                   "zs", "xsu",  "ysu",  "zsu", "ix", "iy", "iz"};
    std::vector<const ParticleValues*> columns;
    for (const ParticleValues& column : frame.values) {
        if (std::find(own.begin(), own.end(), column.name) == own.end()) columns.push_back(&column);
    }
    return columns;
}

void append_columns(std::string& text, const FrameBlock& frame, const std::vector<const ParticleValues*>& further) {
    const bool unwrapped = frame.scene.box != Vec3{} || frame.scene.cell;
    text += unwrapped ? "\nITEM: ATOMS id type xu yu zu" : "\nITEM: ATOMS id type x y z";
    if (!frame.velocities.empty()) text += " vx vy vz";
    if (!frame.masses.empty()) text += " mass";
    for (const ParticleValues* const column : further) text += ' ' + column->name;
    text += '\n';
}

}  // namespace

void append_dump(std::string& text, const FrameBlock& frame) {
    const bool moving = !frame.velocities.empty();
    const std::vector<const ParticleValues*> further = further_columns(frame);
    if (!frame.scene.units.empty()) text += fmt::format("ITEM: UNITS\n{}\n", frame.scene.units);
    text += "ITEM: TIME\n";
    append_number(text, frame.moments.front().time);
    text += fmt::format("\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", frame.moments.front().step, frame.rows);
    append_box(text, frame);
    append_columns(text, frame, further);
    for (std::size_t row = 0; row < frame.rows; ++row) {
        text += fmt::format("{} {}", frame.particle(row) + 1, type_of(frame, row));
        const Vec3 position = frame.positions[row];
        append_numbers(text, {position.x, position.y, position.z});
        if (moving) append_numbers(text, {frame.velocities[row].x, frame.velocities[row].y, frame.velocities[row].z});
        if (!frame.masses.empty()) append_numbers(text, {frame.masses[row]});
        for (const ParticleValues* const column : further) append_numbers(text, {column->values[row]});
        text += '\n';
    }
}

}  // namespace steplab
