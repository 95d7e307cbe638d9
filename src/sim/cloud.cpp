#include "sim/cloud.hpp"

#include <algorithm>

namespace steplab {

namespace {

constexpr std::string_view start_speed = "v0", time_step = "dt";

bool can_differ(const RunDescription& description, const ParameterInfo& info) {
    return info.kind == ParameterInfo::Kind::real && description.scene[info.name] != 0;
}

}  // namespace

std::vector<std::string_view> spreadable(const RunDescription& description) {
    std::vector<std::string_view> names;
    for (const ParameterInfo& info : description.scene.infos()) {
        if (!can_differ(description, info)) continue;
        names.insert(info.name == start_speed ? names.begin() : names.end(), info.name);
    }
    names.push_back(time_step);
    return names;
}

Spread spread_of(const Cloud& cloud, const RunDescription& description) {
    const std::vector<std::string_view> names = spreadable(description);
    const bool known = std::find(names.begin(), names.end(), cloud.spread) != names.end();
    const std::string_view name = known ? std::string_view(cloud.spread) : names.front();
    if (name == time_step)
        return {std::string(name), description.dt * (1 - cloud.width), description.dt * (1 + cloud.width)};
    const auto infos = description.scene.infos();
    const ParameterInfo& info =
        *std::find_if(infos.begin(), infos.end(), [&](const ParameterInfo& it) { return it.name == name; });
    const double value = description.scene[name];
    const auto allowed = [&](double wanted) { return std::clamp(wanted, std::min(info.minimum, value), info.maximum); };
    return {std::string(name), allowed(value * (1 - cloud.width)), allowed(value * (1 + cloud.width))};
}

}  // namespace steplab
