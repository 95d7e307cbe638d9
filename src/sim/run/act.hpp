#pragma once

#include "core/field.hpp"
#include "core/lattice.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <variant>

namespace steplab {

// What a person does to the state of a run between two steps.

/// A particle is taken to a place and stands still there.
struct Pull {
    std::size_t particle = 0;
    Vec3 position;
    friend bool operator==(const Pull&, const Pull&) = default;
};

/// A particle gets this velocity besides its own.
struct Kick {
    std::size_t particle = 0;
    Vec3 velocity;
    friend bool operator==(const Kick&, const Kick&) = default;
};

/// All velocities are turned round: without drag the motion goes back to where it came from.
struct TurnRound {
    friend bool operator==(const TurnRound&, const TurnRound&) = default;
};

using Act = std::variant<Pull, Kick, TurnRound>;

/// True if it does something where particles have these roles: fixed ones stay where they are.
bool acts(const Act& act, const Shape& shape);
/// True if it does work.
bool does_work(const Act& act);

/// Carries it out on a state, of which displacements are from these reference positions.
template <class T>
void apply(const Act& act, const Lattice& reference, State<T>& state) {
    auto& [displacement, velocity] = state;
    if (const auto* const pull = std::get_if<Pull>(&act)) {
        displacement.set(pull->particle, pull->position - reference.at(pull->particle));
        velocity.set(pull->particle, {});
    } else if (const auto* const kick = std::get_if<Kick>(&act)) {
        velocity.x()[kick->particle] += static_cast<T>(kick->velocity.x);
        velocity.y()[kick->particle] += static_cast<T>(kick->velocity.y);
        velocity.z()[kick->particle] += static_cast<T>(kick->velocity.z);
    } else {
        for (T& component : velocity.flat()) component = -component;
    }
}

}  // namespace steplab
