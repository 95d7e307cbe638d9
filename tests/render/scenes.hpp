#pragma once

#include "core/frame.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace steplab::test {

/// A frame at rest of particles at these places with these roles, without springs.
inline Frame particles_at(std::vector<Vec3> places, std::vector<Role> roles = {}, double spacing = 1) {
    auto shape = std::make_shared<Shape>();
    shape->spacing = spacing;
    shape->rest = places;
    shape->roles = roles.empty() ? std::vector<Role>(places.size(), Role::moving) : std::move(roles);
    Frame frame;
    frame.velocities.resize(places.size());
    frame.positions = std::move(places);
    frame.shape = shape;
    return frame;
}

/// The same with periodic boundary conditions, seen in the box from a corner on.
inline Frame periodic(std::vector<Vec3> places, double period, Vec3 corner) {
    Frame frame = particles_at(std::move(places));
    auto shape = std::make_shared<Shape>(*frame.shape);
    shape->box = {period, period, period};
    shape->corner = corner;
    shape->rest = shape->expected = {corner, corner + Vec3{period, period, period}};
    shape->rest.resize(frame.positions.size(), corner);
    frame.shape = shape;
    return frame;
}

/// The same with a spring from each particle to the next, of the length it has.
inline Frame string_of(std::vector<Vec3> places) {
    Frame frame = particles_at(std::move(places));
    auto shape = std::make_shared<Shape>(*frame.shape);
    for (std::uint32_t i = 0; i + 1 < frame.positions.size(); ++i) {
        shape->springs.push_back({i, i + 1, length(frame.positions[i + 1] - frame.positions[i])});
    }
    frame.shape = shape;
    return frame;
}

}  // namespace steplab::test
