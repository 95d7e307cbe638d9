#include "sim/run/run_variant.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace steplab {

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

Settings settings_of(std::string_view text) {
    Settings settings;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view one = text.substr(begin, end - begin);
        const std::size_t equals = one.find('=');
        if (equals == std::string_view::npos || equals == 0)
            throw UsageError(
                fmt::format("'{}' is not of the form name=value, such as dt=0.02", shown(std::string(one))));
        const std::string name(one.substr(0, equals));
        const auto same = [&](const auto& earlier) { return earlier.first == name; };
        if (std::any_of(settings.begin(), settings.end(), same))
            throw UsageError(fmt::format("'{}' is set more than once", shown(name)));
        settings.emplace_back(name, one.substr(equals + 1));
        begin = end + 1;
    }
    return settings;
}

Precision precision_named(const std::string& text) {
    if (const auto precision = parse_precision(text)) return *precision;
    throw UsageError(unknown_word("precision", text, std::vector<std::string_view>{"float", "double"}));
}

/// Of time running backward, if that of the run does.
double dt_of(const std::string& text, const RunDescription& run) {
    ParameterInfo info = dt_parameter;
    if (run.dt < 0 && text.starts_with('-')) info.minimum = -infinity;
    return parse_value(info, text);
}

void set(RunDescription& run, const std::string& name, const std::string& text) {
    if (name == "precision") {
        run.precision = precision_named(text);
    } else if (name == "dt") {
        run.dt = dt_of(text, run);
    } else if (run.scene.contains(name) || run.method_parameters.contains(name)) {
        set_parameter(run, name, text);
    } else {
        std::vector<std::string_view> known{"method", "dt", "precision"};
        for (const ParameterInfo& info : run.method_parameters.infos()) known.push_back(info.name);
        for (const ParameterInfo& info : run.scene.infos()) known.push_back(info.name);
        throw UsageError(unknown_word("setting", name, known));
    }
}

std::string changed(const ParameterValues& values, const ParameterValues& from) {
    std::string text;
    for (const ParameterInfo& info : values.infos()) {
        if (values[info.name] != from[info.name])
            text += fmt::format(",{}={}", info.name, format_value(info, values[info.name]));
    }
    return text;
}

}  // namespace

RunDescription variant_of(const RunDescription& run, std::string_view text) {
    const Settings settings = settings_of(text);
    RunDescription variant = run;
    for (const auto& [name, value] : settings) {
        if (name == "method") variant = with_method(std::move(variant), value);
    }
    for (const auto& [name, value] : settings) {
        if (name != "method") set(variant, name, value);
    }
    return variant;
}

std::string variant_text(const RunDescription& run, const RunDescription& of) {
    const ParameterValues defaults(run.method_parameters.infos());
    return fmt::format("method={},dt={},precision={}{}{}", run.method, exact_text(run.dt), id(run.precision),
                       changed(run.method_parameters, defaults), changed(run.scene, of.scene));
}

}  // namespace steplab
