#include "session/change_text.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

struct ActText {
    std::string operator()(const Pull& pull) const { return fmt::format("pull of particle {}", pull.particle); }
    std::string operator()(const Kick& kick) const { return fmt::format("kick of particle {}", kick.particle); }
    std::string operator()(const TurnRound&) const { return "velocities turned round"; }
};

/// "dt 0.2" of a run in which that differs.
std::string setting_of(const RunDescription& run, std::string_view name) {
    if (name == "method") return "method " + run.method;
    if (name == "precision") return fmt::format("precision {}", id(run.precision));
    if (name == "dt") return "dt " + exact_text(run.dt);
    const ParameterValues& values = run.scene.contains(name) ? run.scene : run.method_parameters;
    for (const ParameterInfo& info : values.infos()) {
        if (info.name == name) return fmt::format("{} {}", name, format_value(info, values[name]));
    }
    return std::string(name);
}

}  // namespace

std::vector<std::string_view> differences(const RunDescription& a, const RunDescription& b) {
    std::vector<std::string_view> names;
    if (a.method != b.method) names.emplace_back("method");
    if (a.precision != b.precision) names.emplace_back("precision");
    if (a.dt != b.dt) names.emplace_back("dt");
    const auto add = [&](const ParameterValues& before, const ParameterValues& now) {
        for (const ParameterInfo& info : now.infos()) {
            if (before.contains(info.name) && before[info.name] != now[info.name]) names.push_back(info.name);
        }
    };
    add(a.scene, b.scene);
    add(a.method_parameters, b.method_parameters);
    return names;
}

std::string text_of(const SegmentBegin& before, const SegmentBegin& change) {
    if (change.act) return std::visit(ActText{}, *change.act);
    std::string text;
    for (const std::string_view name : differences(before.description, change.description))
        text += (text.empty() ? "" : ", ") + setting_of(change.description, name);
    return text;
}

}  // namespace steplab
