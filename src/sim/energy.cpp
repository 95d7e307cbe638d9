#include "sim/energy.hpp"

#include "core/lanes.hpp"
#include "core/sum.hpp"

#include <cstddef>
#include <limits>
#include <span>

namespace steplab {

namespace {

/// Springs at rest hold rounding errors of this part of the energy it takes to press one of them to nothing.
constexpr double spring_rounding = 1e-12;

double spring_floor(double k, double length, std::size_t springs) {
    const double least = std::numeric_limits<double>::min();
    return spring_rounding * 0.5 * k * length * length * static_cast<double>(springs) + least;
}

double floor_of(const ConstantForces& forces) { return spring_floor(forces.mass * forces.step, 1, forces.count); }
double floor_of(const LineForces& forces) { return spring_floor(forces.k, forces.rest_length, forces.count); }
double floor_of(const GridForces& forces) {
    return spring_floor(forces.k, forces.rest_length, 4 * forces.dim * forces.dim);
}
double floor_of(const PairForces& forces) { return forces.depth * static_cast<double>(forces.count); }

}  // namespace

EnergyMeter::EnergyMeter(const Scene& scene)
    : mass_(scene.mass),
      engine_(std::visit([](const auto& forces) { return Engine(engine<double>(forces)); }, scene.forces)),
      floor_(std::visit([](const auto& forces) { return floor_of(forces); }, scene.forces)) {}

Energy EnergyMeter::energy(const State<double>& state) {
    using Many = CacheLineLanes<double>;
    LanesSum<Many> squares;
    const std::span<const double> v = state.velocity.flat();
    for (std::size_t k = 0; k < v.size(); k += Many::count) {
        const Many velocities = Many::load(v.data() + k);
        squares.add(velocities * velocities);
    }
    const auto potential = std::visit([&](auto& forces) { return forces.potential(state.displacement); }, engine_);
    return {mass_ / 2 * squares.value(), potential};
}

}  // namespace steplab
