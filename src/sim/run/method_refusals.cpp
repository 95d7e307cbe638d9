#include "sim/run/method_refusals.hpp"

#include <fmt/format.h>

#include <variant>

namespace steplab {

std::optional<std::string> backward_refusal(const RunDescription& description) {
    const bool own_steps = method(description.method).info.adaptive || chooses_its_steps(description);
    if (!(description.dt < 0) || !own_steps) return std::nullopt;
    return fmt::format(
        "{} chooses its own steps, which go forward in time: dt must be > 0; to go back, reverse the velocities",
        description.method);
}

std::optional<std::string> method_refusal(const Method& method, const RunDescription& description, const Plan& plan) {
    const MethodInfo& info = method.info;
    const auto because = [&](std::string_view why) {
        return fmt::format("{} cannot run this scene: {}", info.id, why);
    };
    if (info.curiosity && std::holds_alternative<ComposedForces>(plan.forces))
        return because("it is kept as printed in 2008, for the models of then");
    if (facts_of(description).damping && info.order_with_damping == 0)
        return because("dashpots, and drag whose rate c / m differs between particles, are not in its formulas");
    if (!info.refusal) return std::nullopt;
    const auto refused = std::visit([&](const auto& forces) { return info.refusal(coupling(forces)); }, plan.forces);
    return refused ? std::optional(because(*refused)) : std::nullopt;
}

std::optional<std::string> name_refusal(const MethodInfo& method, const RunDescription& description) {
    for (const ParameterInfo& info : method.parameters) {
        if (!description.scene.contains(info.name)) continue;
        return fmt::format(
            "'{}' is a parameter of the scene and of {}: rename that of the scene, or choose another method", info.name,
            method.id);
    }
    return std::nullopt;
}

MethodRefusals method_refusals(const RunDescription& description, const Plan& plan) {
    MethodRefusals all;
    for (const Method& method : methods()) {
        auto refused = name_refusal(method.info, description);
        if (!refused) refused = method_refusal(method, description, plan);
        if (refused) all.emplace(method.info.id, *refused);
    }
    return all;
}

}  // namespace steplab
