#include "sim/ensemble/live_ensemble_options.hpp"

#include <algorithm>

namespace steplab {

namespace {

constexpr std::string_view start_speed = "v0";

bool can_differ(const RunDescription& description, const ParameterInfo& info) {
    return info.kind == ParameterInfo::Kind::real && description.scene[info.name] != 0;
}

}  // namespace

std::vector<std::string_view> perturbable(const RunDescription& description) {
    std::vector<std::string_view> names;
    for (const ParameterInfo& info : description.scene.infos()) {
        if (!can_differ(description, info)) continue;
        names.insert(info.name == start_speed ? names.begin() : names.end(), info.name);
    }
    names.push_back(dt_parameter.name);
    return names;
}

ParameterRange range_of(const LiveEnsembleOptions& ensemble, const RunDescription& description) {
    const std::vector<std::string_view> names = perturbable(description);
    const bool known = std::find(names.begin(), names.end(), ensemble.spread) != names.end();
    const std::string_view name = known ? std::string_view(ensemble.spread) : names.front();
    const double value = name == dt_parameter.name ? description.dt : description.scene[name];
    return {std::string(name), value * (1 - ensemble.width), value * (1 + ensemble.width)};
}

}  // namespace steplab
