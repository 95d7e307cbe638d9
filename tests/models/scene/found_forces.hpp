#pragma once

#include "models/forces/layouts.hpp"
#include "models/scene/plain_scene.hpp"
#include "models/scene/planner.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

namespace steplab::test {

/// What the layout makes of a scene at its start, in number type T: forces in N with all damping.
struct Found {
    std::vector<Real3> forces;
    double energy = 0;
};

template <class T>
Found found(const Scene& scene) {
    const Plan plan = planned(scene);
    const auto& forces = std::get<ComposedForces>(plan.forces);
    const State<double> start = plan.start.state();
    const Field<T> u = converted<T>(start.displacement), v = converted<T>(start.velocity);
    Field<T> a(u.count());
    auto force = engine<T>(forces);
    force.accelerations(u, a);
    if (force.damped()) force.add_damping(u, v, a);
    Found result;
    for (std::size_t i = 0; i < u.count(); ++i) {
        const Real mass = plan.mass * (plan.masses.empty() ? 1 : plan.masses[i]);
        const auto at = [i](const Field<T>& field) { return Real3{field.x()[i], field.y()[i], field.z()[i]}; };
        result.forces.push_back(mass * (at(a) - Real(plan.drag) * at(v)));
    }
    result.energy = force.potential(u).value;
    return result;
}

template <class T>
inline constexpr Real eps = std::numeric_limits<T>::epsilon();

/// (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / (12 h), wrong by h^4 / 30 of the fifth derivative.
template <class F>
auto fifth_order_slope(F f, Real h) {
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

/// A direction for each particle that moves.
inline std::vector<Real3> directions(const PlainScene& plain) {
    std::vector<Real3> all;
    for (std::size_t i = 0; i < plain.count(); ++i) {
        const auto k = static_cast<Real>(i);
        const bool fixed = plain.particles()[i].fixed;
        all.push_back(fixed ? Real3{} : Real3{std::sin(3 * k + 1), std::cos(5 * k), std::sin(7 * k + 2)});
    }
    return all;
}

}  // namespace steplab::test
