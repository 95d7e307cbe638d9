#pragma once

#include "sim/run/energy.hpp"
#include "sim/run/simulation.hpp"

#include <optional>

namespace steplab {

/// False where the energy has risen beyond what any usable run of the scene does (docs/divergence.md): by more than
/// 1000 times the kinetic and absolute potential energy at the start, the work of outer forces since and the scene's
/// floor. Relative to these, falling and slow gains are not taken for a blow-up. Drag only lowers the energy.
bool energy_is_possible(const Energy& now, const Energy& start, double floor);
/// The same of a gain since the start [J]; `scale`: the sum of all those.
bool gain_is_possible(double gain, double scale);

/// True only if it is possible whatever the parts are: `bound` is not below the kinetic energy and that of the springs.
bool energy_is_surely_possible(double bound, const Energy& start, double floor);

/// The particle farthest from its senses: not finite, or the fastest.
std::size_t wildest_particle(const State<double>& state);

/// Fills in dt, limit and message. `energy`: of the last good step [J].
void explain(Divergence& divergence, const RunDescription& held, const std::optional<StabilityLimit>& limit,
             double energy);

}  // namespace steplab
