#include "session/change_text.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

namespace {

std::string particles_text(std::size_t first, std::size_t count) {
    return count == 1 ? fmt::format("particle {}", first) : fmt::format("{} particles", count);
}

/// Those of an act.
template <class OfParticles>
std::string particles_text(const OfParticles& act) {
    return particles_text(act.particle, 1 + act.others.size());
}

struct ActText {
    std::string operator()(const Pull& pull) const { return "pull of " + particles_text(pull); }
    std::string operator()(const Kick& kick) const { return "kick of " + particles_text(kick); }
    std::string operator()(const Tug& tug) const { return "pull of " + particles_text(tug); }
    std::string operator()(const TurnRound&) const { return "velocities turned round"; }
};

constexpr std::string_view mass_of_particles = "mass of particles", fixed_particles = "fixed particles";

/// "mass 2 kg of particle 3", "5 particles fixed".
std::string alterations_text(const RunDescription& before, const RunDescription& run, std::string_view name) {
    const std::vector<std::size_t> particles = altered_particles(before, run);
    const Alteration first = run.alterations.of(particles.front());
    const std::string which = particles_text(particles.front(), particles.size());
    if (name == fixed_particles) return which + (first.fixed.value_or(false) ? " fixed" : " free");
    return first.mass ? fmt::format("mass {} kg of {}", exact_text(*first.mass), which) : "mass of " + which;
}

/// "dt 0.2" of a run in which that differs.
std::string setting_of(const RunDescription& before, const RunDescription& run, std::string_view name) {
    if (name == "method") return "method " + run.method;
    if (name == "precision") return fmt::format("precision {}", id(run.precision));
    if (name == "dt") return "dt " + exact_text(run.dt);
    if (name == mass_of_particles || name == fixed_particles) return alterations_text(before, run, name);
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
    bool mass = false, fixed = false;
    for (const std::size_t particle : altered_particles(a, b)) {
        const Alteration before = a.alterations.of(particle), now = b.alterations.of(particle);
        mass = mass || before.mass != now.mass;
        fixed = fixed || before.fixed != now.fixed;
    }
    if (mass) names.push_back(mass_of_particles);
    if (fixed) names.push_back(fixed_particles);
    return names;
}

std::vector<std::size_t> altered_particles(const RunDescription& a, const RunDescription& b) {
    std::vector<std::size_t> particles;
    if (a.alterations == b.alterations) return particles;
    for (const RunDescription* run : {&a, &b}) {
        for (const Alteration& one : run->alterations.all()) {
            if (a.alterations.of(one.particle) != b.alterations.of(one.particle)) particles.push_back(one.particle);
        }
    }
    std::sort(particles.begin(), particles.end());
    particles.erase(std::unique(particles.begin(), particles.end()), particles.end());
    return particles;
}

std::string text_of(const SegmentBegin& before, const SegmentBegin& change) {
    if (change.act) return std::visit(ActText{}, *change.act);
    std::string text;
    for (const std::string_view name : differences(before.description, change.description))
        text += (text.empty() ? "" : ", ") + setting_of(before.description, change.description, name);
    return text;
}

}  // namespace steplab
