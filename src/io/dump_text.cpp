#include "io/dump_text.hpp"

#include "io/number_append.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>

namespace steplab {

namespace {

void append_numbers(std::string& text, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
        text += ' ';
        append_number(text, number);
    }
}

std::array<double, 3> components(Vec3 vector) { return {vector.x, vector.y, vector.z}; }

void append_box(std::string& text, const FrameBlock& frame) {
    const auto sides = components(frame.scene.box), corner = components(frame.scene.corner);
    text += "ITEM: BOX BOUNDS";
    for (const double side : sides) text += side > 0 ? " pp" : " ff";
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

}  // namespace

void append_dump(std::string& text, const FrameBlock& frame) {
    const bool unwrapped = frame.scene.box != Vec3{}, moving = !frame.velocities.empty();
    text += "ITEM: TIME\n";
    append_number(text, frame.moments.front().time);
    text += fmt::format("\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\n", frame.moments.front().step, frame.rows);
    append_box(text, frame);
    text += unwrapped ? "\nITEM: ATOMS id type xu yu zu" : "\nITEM: ATOMS id type x y z";
    text += moving ? " vx vy vz\n" : "\n";
    for (std::size_t row = 0; row < frame.rows; ++row) {
        const int type = frame.roles.empty() ? 1 : 1 + static_cast<int>(frame.roles[row]);
        text += fmt::format("{} {}", frame.particle(row) + 1, type);
        const Vec3 position = frame.positions[row];
        append_numbers(text, {position.x, position.y, position.z});
        if (moving) append_numbers(text, {frame.velocities[row].x, frame.velocities[row].y, frame.velocities[row].z});
        text += '\n';
    }
}

}  // namespace steplab
