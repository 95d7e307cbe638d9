#include "sim/steppers/energy_sums.hpp"

#include "core/field_lanes.hpp"
#include "core/instruction_set.hpp"
#include "core/lanes.hpp"
#include "core/sum.hpp"
#include "models/forces/layouts.hpp"

#include <variant>

// Compiled once for each instruction set.

namespace steplab::STEPLAB_INSTRUCTION_SET {

namespace {

/// Energy of what pulls at the first `own` of these particles from one another and from those behind them.
PotentialEnergy energy_of_piece(LineForces forces, const Field<double>& u, std::size_t held, std::size_t own) {
    forces.count = held;
    return Line<double>(forces).potential(u, own);
}
PotentialEnergy energy_of_piece(GridForces forces, const Field<double>& u, std::size_t held, std::size_t own) {
    forces.rows = held / forces.columns;
    return Grid<double>(forces).potential(u, own / forces.columns);
}
template <class Whole>
PotentialEnergy energy_of_piece(const Whole& forces, const Field<double>& u, std::size_t, std::size_t) {
    return engine<double>(forces).potential(u);
}

double squares(const Field<double>& v, std::size_t count) {
    using Many = CacheLineLanes<double>;
    LanesSum<Many> squares;
    for (const double* component : {v.x(), v.y(), v.z()}) {
        for (std::size_t i = 0; i < count; i += Many::count) {
            const Many velocities = where(Many::first(count - i), Many::load(component + i), Many(0.0));
            squares.add(velocities * velocities);
        }
    }
    return squares.value();
}

PotentialEnergy potential(const Forces& forces, const Field<double>& u, std::size_t held, std::size_t own) {
    return std::visit([&](const auto& layout) { return energy_of_piece(layout, u, held, own); }, forces);
}

}  // namespace

EnergySums energy_sums();

EnergySums energy_sums() { return {potential, squares}; }

}  // namespace steplab::STEPLAB_INSTRUCTION_SET
