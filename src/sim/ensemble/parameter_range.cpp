#include "sim/ensemble/parameter_range.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace steplab {

namespace {

const ParameterInfo& info_of(const RunDescription& description, std::string_view name) {
    if (name == dt_parameter.name) return dt_parameter;
    std::vector<std::string_view> known{dt_parameter.name};
    for (const auto infos : {description.scene.infos(), description.method_parameters.infos()}) {
        for (const ParameterInfo& info : infos) {
            if (info.name == name) return info;
            if (info.kind != ParameterInfo::Kind::choice) known.push_back(info.name);
        }
    }
    throw UsageError(
        unknown_word("parameter", name, known, fmt::format("{} and {}", description.model, description.method)));
}

void set(RunDescription& description, std::string_view name, double value) {
    if (name == dt_parameter.name) {
        description.dt = value;
    } else if (description.scene.contains(name)) {
        description.scene.set(name, value);
    } else {
        description.method_parameters.set(name, value);
    }
}

}  // namespace

double ParameterRange::value(std::size_t run, std::size_t runs) const {
    if (run == 0) return from;
    if (run + 1 == runs) return to;
    return from + (to - from) * static_cast<double>(run) / static_cast<double>(runs - 1);
}

ParameterRange parse_parameter_range(const RunDescription& description, const std::string& text) {
    const std::size_t equals = text.find('='), colon = text.find(':', equals);
    if (equals == std::string::npos || equals == 0 || colon == std::string::npos)
        throw UsageError(
            fmt::format("--spread '{}' is not of the form name=a:b, such as --spread dt=0.01:0.1", shown(text)));
    const ParameterInfo& info = info_of(description, text.substr(0, equals));
    if (info.kind == ParameterInfo::Kind::choice)
        throw UsageError(fmt::format("--spread {}: only numbers can be spread, and {} is one of {}", shown(text),
                                     info.name, range_text(info)));
    return {std::string(info.name), parse_value(info, text.substr(equals + 1, colon - equals - 1)),
            parse_value(info, text.substr(colon + 1))};
}

RunDescription run_in_range(RunDescription description, std::span<const ParameterRange> ranges, std::size_t run,
                            std::size_t runs) {
    for (const ParameterRange& spread : ranges) {
        try {
            set(description, spread.name, spread.value(run, runs));
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("run {} of the ensemble: {}", run, error.what()));
        }
    }
    check(description);
    return description;
}

}  // namespace steplab
