#include "sim/ensemble/live_ensemble_options.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

constexpr std::string_view start_speed = "v0";

bool can_differ(const RunDescription& description, const ParameterInfo& info) {
    return info.kind == ParameterInfo::Kind::real && description.scene[info.name] != 0;
}

/// The shortest decimal near `width` that gives these ends exactly; `width` itself if none does.
double shortest_width(LiveEnsembleOptions ensemble, const RunDescription& description, const ParameterRange& ends) {
    const auto [low, high] = std::minmax(ends.from, ends.to);
    for (int digits = 1; digits <= 17; ++digits) {
        const double width = *parse_number(fmt::format("{:.{}e}", ensemble.width, digits - 1));
        const LiveEnsembleOptions rounded{.runs = ensemble.runs, .spread = ensemble.spread, .width = width};
        const ParameterRange range = range_of(rounded, description);
        const auto [from, to] = std::minmax(range.from, range.to);
        if (from == low && to == high) return width;
    }
    return ensemble.width;
}

}  // namespace

LiveEnsembleOptions nearest_live_ensemble(const RunDescription& description, std::size_t runs,
                                          const std::vector<ParameterRange>& ranges) {
    LiveEnsembleOptions ensemble{.runs = runs, .width = 0};
    if (ranges.empty()) return ensemble;
    LiveEnsembleOptions as_given{.runs = runs, .width = 0, .otherwise = true, .ranges = ranges};
    const ParameterRange& range = ranges.front();
    const std::vector<std::string_view> known = perturbable(description);
    if (ranges.size() > 1 || std::find(known.begin(), known.end(), range.name) == known.end()) return as_given;
    const double value = range.name == dt_parameter.name ? description.dt : description.scene[range.name];
    ensemble.spread = range.name;
    ensemble.width = std::abs(range.to - range.from) / 2 / std::abs(value);
    // The decimal ends of a range are rounded, each by half of epsilon.
    const double off = std::abs((range.from + range.to) / 2 - value) / std::abs(value);
    const bool about_value = off <= std::numeric_limits<double>::epsilon();
    if (!about_value || !(ensemble.width <= LiveEnsembleOptions::most_width)) return as_given;
    ensemble.width = shortest_width(ensemble, description, range);
    return ensemble;
}

std::vector<ParameterRange> ranges_of(const LiveEnsembleOptions& ensemble, const RunDescription& description) {
    if (ensemble.otherwise) return ensemble.ranges;
    return {range_of(ensemble, description)};
}

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
