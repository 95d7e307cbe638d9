#include "sim/run/act.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

namespace {

bool moves(std::size_t particle, const Shape& shape) {
    return particle < shape.roles.size() && shape.roles[particle] != Role::fixed;
}

/// Calls visit(act) with the act of a particle, and of others with it; the result is true for what is done to all.
template <class SomeAct, class Visit>
bool of_particles(SomeAct& act, const Visit& visit) {
    return std::visit(
        [&](auto& one) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(one)>, TurnRound>) {
                return true;
            } else {
                return visit(one);
            }
        },
        act);
}

bool same_particles(const Pull& a, const Pull& b) { return a.particle == b.particle && a.others == b.others; }

}  // namespace

bool acts(const Act& act, const Shape& shape) {
    return of_particles(act, [&](const auto& one) {
        const auto is_another = [&](std::size_t other) { return other != one.particle && moves(other, shape); };
        return moves(one.particle, shape) && std::all_of(one.others.begin(), one.others.end(), is_another);
    });
}

std::optional<Act> on_moving(Act act, const Shape& shape) {
    if (acts(act, shape)) return act;
    const bool moved = of_particles(act, [&](auto& one) {
        std::vector<std::size_t> others(one.others.begin(), one.others.end());
        std::erase_if(others, [&](std::size_t other) { return other == one.particle || !moves(other, shape); });
        one.others = ParticleList(std::move(others));
        return moves(one.particle, shape);
    });
    return moved ? std::optional(std::move(act)) : std::nullopt;
}

bool does_work(const Act& act) { return !std::holds_alternative<TurnRound>(act); }

bool overwrites(const Act& later, const Act& earlier) {
    const Pull *const pull = std::get_if<Pull>(&later), *const before = std::get_if<Pull>(&earlier);
    return pull && before && same_particles(*pull, *before);
}

bool continues(const Act& later, const Act& earlier) {
    const Tug* const tug = std::get_if<Tug>(&later);
    return tug && tug->goes_on && std::holds_alternative<Tug>(earlier);
}

}  // namespace steplab
