#pragma once
// Crystals for tests of near pairs.

#include "models/forces/layouts.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <variant>

namespace steplab::test {

/// Parameters of a crystal, the others at their defaults.
inline ParameterValues values(Settings settings) {
    ParameterValues all(model("crystal").info.parameters);
    for (const auto& [name, value] : settings) all.set(name, value);
    return all;
}

/// The crystal of these parameters.
inline Plan crystal(Settings settings = {}) { return model("crystal").plan(values(settings)); }

/// Of a crystal.
inline NearPairForces forces_of(const Plan& scene) { return std::get<NearPairForces>(scene.forces); }

/// Its particles up to `spread` from the lattice along each axis, and some of them periods away.
template <class T>
Field<T> scattered(const Plan& scene, double spread) {
    Field<double> u = scene.start.state().displacement;
    const double period = forces_of(scene).period;
    for (std::size_t i = 0; i < u.count(); ++i) {
        const auto along = [&](std::size_t n) { return spread * (static_cast<double>(n * 37 % 101) / 50 - 1); };
        const auto away = [&](std::size_t n) { return period * (static_cast<double>(n % 5) - 2); };
        u.set(i,
              u.at(i) + Vec3{along(3 * i) + away(i), along(3 * i + 1) + away(i / 3), along(3 * i + 2) + away(i / 7)});
    }
    return converted<T>(u);
}

}  // namespace steplab::test
