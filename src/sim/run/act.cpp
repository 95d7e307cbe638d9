#include "sim/run/act.hpp"

#include <optional>

namespace steplab {

namespace {

/// The one particle that it is done to; none: to all.
std::optional<std::size_t> particle_of(const Act& act) {
    if (const auto* const pull = std::get_if<Pull>(&act)) return pull->particle;
    if (const auto* const kick = std::get_if<Kick>(&act)) return kick->particle;
    return std::nullopt;
}

}  // namespace

bool acts(const Act& act, const Shape& shape) {
    const auto particle = particle_of(act);
    return !particle || (*particle < shape.roles.size() && shape.roles[*particle] != Role::fixed);
}

bool does_work(const Act& act) { return !std::holds_alternative<TurnRound>(act); }

}  // namespace steplab
