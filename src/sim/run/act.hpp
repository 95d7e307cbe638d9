#pragma once

#include "core/field.hpp"
#include "core/lattice.hpp"
#include "core/particle_list.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

namespace steplab {

// What a person does to the state of a run between two steps.

/// A particle is taken to a place and stands still there; others are shifted as far and stand still, too.
struct Pull {
    std::size_t particle = 0;
    Vec3 position;
    ParticleList others = {};
    friend bool operator==(const Pull&, const Pull&) = default;
};

/// A particle, and others with it, get this velocity besides their own.
struct Kick {
    std::size_t particle = 0;
    Vec3 velocity;
    ParticleList others = {};
    friend bool operator==(const Kick&, const Kick&) = default;
};

/// A particle is drawn towards a place for some time, by a critically damped spring that turns its velocity v at x into
/// (v + tau rate^2 (place - x)) / (1 + rate tau)^2, the implicit Euler step: it overshoots at no rate. Others gain the
/// same velocity.
struct Tug {
    std::size_t particle = 0;
    Vec3 position;         ///< the place
    double rate = 1;       ///< angular frequency of the spring without damping [1/s]
    bool goes_on = false;  ///< it continues the tug before it: both are one hold of the particle
    ParticleList others = {};
    double duration = 0;  ///< tau [s], < 0 where time runs backward
    friend bool operator==(const Tug&, const Tug&) = default;
};

/// All velocities are turned round: without drag the motion goes back to where it came from.
struct TurnRound {
    friend bool operator==(const TurnRound&, const TurnRound&) = default;
};

using Act = std::variant<Pull, Kick, Tug, TurnRound>;

/// True if it does something where particles have these roles: all that it is done to move.
bool acts(const Act& act, const Shape& shape);
/// The act on those of its particles that move; nothing where the first does not.
std::optional<Act> on_moving(Act act, const Shape& shape);
/// True if it does work.
bool does_work(const Act& act);
/// True if after the second act nothing is left of the first, just before it: a particle is dragged.
bool overwrites(const Act& later, const Act& earlier);
/// True if a tug continues another, just before it.
bool continues(const Act& later, const Act& earlier);

/// What a tug adds to a component of the velocity, that of the particle being v and the place as far away.
template <class T>
T gained(const Tug& tug, double distance, T displacement, T v) {
    const T tau = static_cast<T>(tug.duration), rate = static_cast<T>(tug.rate), damping = rate * std::abs(tau);
    const T pulled = tau * rate * rate * (static_cast<T>(distance) - displacement);
    return (pulled - damping * (2 + damping) * v) / ((1 + damping) * (1 + damping));
}

/// Adds a vector to those of a particle and others.
template <class T>
void add(std::array<T, 3> vector, std::size_t particle, const ParticleList& others, Field<T>& field) {
    const auto add_to = [&](std::size_t i) {
        field.x()[i] += vector[0];
        field.y()[i] += vector[1];
        field.z()[i] += vector[2];
    };
    add_to(particle);
    for (const std::size_t other : others) add_to(other);
}

template <class T>
void apply(const Pull& pull, const Lattice& reference, State<T>& state) {
    auto& [displacement, velocity] = state;
    const std::size_t i = pull.particle;
    const Vec3 there = pull.position - reference.at(i);
    const std::array<T, 3> way{static_cast<T>(there.x) - displacement.x()[i],
                               static_cast<T>(there.y) - displacement.y()[i],
                               static_cast<T>(there.z) - displacement.z()[i]};
    add(way, i, pull.others, displacement);
    displacement.set(i, there);
    velocity.set(i, {});
    for (const std::size_t other : pull.others) velocity.set(other, {});
}

template <class T>
void apply(const Kick& kick, const Lattice&, State<T>& state) {
    const auto [x, y, z] = kick.velocity;
    add({static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)}, kick.particle, kick.others, state.velocity);
}

template <class T>
void apply(const Tug& tug, const Lattice& reference, State<T>& state) {
    auto& [u, v] = state;
    const std::size_t i = tug.particle;
    const Vec3 there = tug.position - reference.at(i);
    add({gained(tug, there.x, u.x()[i], v.x()[i]), gained(tug, there.y, u.y()[i], v.y()[i]),
         gained(tug, there.z, u.z()[i], v.z()[i])},
        i, tug.others, v);
}

template <class T>
void apply(const TurnRound&, const Lattice&, State<T>& state) {
    for (T& component : state.velocity.flat()) component = -component;
}

/// Carries it out on a state, of which displacements are from these reference positions.
template <class T>
void apply(const Act& act, const Lattice& reference, State<T>& state) {
    std::visit([&](const auto& one) { apply(one, reference, state); }, act);
}

}  // namespace steplab
