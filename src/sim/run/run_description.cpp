#include "sim/run/run_description.hpp"

#include "core/duration.hpp"
#include "core/error.hpp"
#include "core/shell_word.hpp"
#include "core/text.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/method_refusals.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <variant>
#include <vector>

namespace steplab {

namespace {

void check_dt(const RunDescription& description) {
    const double dt = description.dt, held = rounded_to(description.precision, dt);
    check_value(dt_parameter, std::abs(dt));
    if (const auto refused = backward_refusal(description)) throw UsageError(*refused);
    if (!std::isfinite(held) || held == 0) {
        throw UsageError(
            fmt::format("dt = {} is lost in float: choose one from 1e-37 to 3e38, or double", exact_text(dt)));
    }
}

void check_fits(Precision precision, const ParameterInfo& info, double value) {
    const double held = rounded_to(precision, value);
    const bool vanished = held == 0 && !info.minimum_included && info.minimum == 0;
    if (std::isfinite(held) && !vanished) return;
    throw UsageError(fmt::format("{} = {} is lost in float, which holds 1e-37 to 3e38: choose another value or double",
                                 info.name, exact_text(value)));
}

/// "a smaller n": the first whole number of a scene counts its particles.
std::string smaller(const ParameterValues& values) {
    for (const ParameterInfo& info : values.infos()) {
        if (info.kind == ParameterInfo::Kind::integer) return fmt::format("a smaller {}", info.name);
    }
    return "fewer";
}

void check_memory(const RunDescription& description, double needed_for_interactions) {
    const double particles = model_of(description).particles(description.scene);
    const double needed = particles * bytes_per_particle(description) + needed_for_interactions;
    if (needed < 1e6) return;  // always there, and to ask the system takes longer than a short run
    const double there = available_memory();
    if (needed <= there && particles <= 4294967295.0) return;
    throw UsageError(fmt::format("{} particles need {} of memory, {} are available: choose {}", exact_text(particles),
                                 bytes_text(needed), bytes_text(there), smaller(description.scene)));
}

/// Methods that cannot run every scene check its forces; what is held for each interaction has to fit memory, too.
void check_method(const RunDescription& description) {
    const Method& entry = method(description.method);
    const bool of_model = !description.origin && description.alterations.empty() && !description.start.from;
    if (of_model && !entry.info.refusal && !facts_of(description).lists_pairs) return;
    const Plan scene = plan_of(description);
    if (const auto refused = method_refusal(entry, description, scene)) throw UsageError(*refused);
    check_memory(description, bytes_of_interactions(description, scene));
}

const Model& unaltered_model(const RunDescription& description) {
    return description.origin ? *description.origin->model : model(description.model);
}

void check_alterations(const RunDescription& description) {
    if (description.alterations.empty()) return;
    const double particles = model_of(description).particles(description.scene);
    for (const Alteration& one : description.alterations.all()) {
        if (!(static_cast<double>(one.particle) < particles))
            throw UsageError(
                fmt::format("there is no particle {}: they count from 0 to {:.0f}", one.particle, particles - 1));
        if (!one.mass) continue;
        check_value(altered_mass, *one.mass);
        check_fits(description.precision, altered_mass, *one.mass);
    }
}

/// "--set name=value" for every parameter that is not at its default.
std::string changed_parameters(const ParameterValues& values) {
    std::string text;
    for (const auto& info : values.infos()) {
        if (values[info.name] != info.default_value)
            text += fmt::format(" --set {}={}", info.name, format_value(info, values[info.name]));
    }
    return text;
}

}  // namespace

SceneFacts facts_of(const RunDescription& description) { return model_of(description).facts(description.scene); }

const Model& model_of(const RunDescription& description) {
    return description.alterations.empty() ? unaltered_model(description) : description.alterations.model();
}

RunDescription describe(SceneOrigin origin) {
    const Model& scene = *origin->model;
    RunDescription description = with_method({}, scene.opening.method);
    description.model = std::filesystem::path(origin->given).stem().string();
    description.scene = ParameterValues(scene.info.parameters);
    for (const auto& [name, text] : origin->defaults.method_parameters)
        description.method_parameters.set_text(name, text);
    description.dt = scene.opening.dt;
    description.precision = scene.opening.precision;
    description.origin = std::move(origin);
    return description;
}

RunDescription describe(std::string_view model_id, std::string_view method_id) {
    return with_method(with_model({}, model_id), method_id);
}

RunDescription with_model(RunDescription description, std::string_view id) {
    const ModelInfo& info = model(id).info;
    description.model = info.id;
    description.origin = {};
    description.start = {};
    description.alterations = {};
    description.scene = ParameterValues(info.parameters);
    return description;
}

RunDescription with_method(RunDescription description, std::string_view id) {
    const MethodInfo& info = method(id).info;
    description.method = info.id;
    description.method_parameters = ParameterValues(info.parameters);
    return description;
}

RunDescription with_alterations(RunDescription description, std::span<const Alteration> alterations) {
    description.alterations =
        Alterations(unaltered_model(description), description.origin, description.alterations.with(alterations));
    return description;
}

RunDescription without_missing_alterations(RunDescription description) {
    if (description.alterations.empty()) return description;
    const Model& base = unaltered_model(description);
    const double particles = base.particles(description.scene);
    const auto all = description.alterations.all();
    std::vector<Alteration> kept;
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept),
                 [&](const Alteration& one) { return static_cast<double>(one.particle) < particles; });
    if (kept.size() < all.size()) description.alterations = Alterations(base, description.origin, kept);
    return description;
}

void set_parameter(RunDescription& description, std::string_view name, std::string_view text) {
    if (description.scene.contains(name)) return description.scene.set_text(name, text);
    if (description.method_parameters.contains(name)) return description.method_parameters.set_text(name, text);
    std::vector<std::string_view> known;
    for (const auto& info : description.scene.infos()) known.push_back(info.name);
    for (const auto& info : description.method_parameters.infos()) known.push_back(info.name);
    throw UsageError(
        unknown_word("parameter", name, known, fmt::format("{} and {}", description.model, description.method)));
}

void check_values(const RunDescription& description) {
    check_dt(description);
    if (const auto refused = name_refusal(method(description.method).info, description)) throw UsageError(*refused);
    for (const ParameterValues& values : {description.scene, description.method_parameters}) {
        for (const auto& info : values.infos()) {
            check_value(info, values[info.name]);
            if (info.kind == ParameterInfo::Kind::real) check_fits(description.precision, info, values[info.name]);
        }
    }
    check_alterations(description);
    const Model& model = model_of(description);
    const auto ask = [&](const auto& refusal) {
        if (!refusal) return;
        if (const auto refused = refusal(description.scene)) throw UsageError(*refused);
    };
    ask(model.refusal);
    check_memory(description, 0);
    if (description.precision == Precision::float_) ask(model.lost_in_float);
}

void check(const RunDescription& description) {
    check_values(description);
    check_method(description);
}

RunDescription as_held(RunDescription description) {
    check(description);
    description.dt = rounded_to(description.precision, description.dt);
    for (const auto& info : description.scene.infos()) {
        if (info.kind == ParameterInfo::Kind::integer) continue;  // a count is held as it is
        description.scene.set(info.name, rounded_to(description.precision, description.scene[info.name]));
    }
    return description;
}

std::string command_line(const RunDescription& description) {
    const std::string scene =
        description.origin ? "--scene " + shell_word(description.origin->given) : "--model " + description.model;
    const StartChange& start = description.start;
    return fmt::format("{}{} --method {}{} --precision {} --dt {}{}{}", scene, changed_parameters(description.scene),
                       description.method, changed_parameters(description.method_parameters), id(description.precision),
                       exact_text(description.dt), start.from ? " --from " + shell_word(start.from->given) : "",
                       start.reverse ? " --reverse" : "");
}

std::optional<StabilityLimit> stability_limit(const RunDescription& description) {
    const auto omega = model_of(description).omega_max(description.scene);
    if (!omega || !(*omega <= largest_frequency)) return std::nullopt;
    return StabilityLimit{linear_limit(description, *omega), *omega};
}

double fastest_frequency(const RunDescription& description) {
    const auto known = model_of(description).omega_max(description.scene);
    return known ? *known : facts_of(description).pair_frequency;
}

bool has_drag(const RunDescription& description) { return facts_of(description).drag > 0; }

int order_of(const MethodInfo& method, const SceneFacts& scene) {
    if (scene.damping) return method.order_with_damping;
    return scene.drag > 0 ? method.order_with_drag : method.order;
}

int order_of(const RunDescription& description) {
    return order_of(method(description.method).info, facts_of(description));
}

bool keeps_drag_work(const RunDescription& description) {
    const SceneFacts facts = facts_of(description);
    const Method& how = method(description.method);
    if (!facts.damping) return how.counts_drag || how.parts.known();
    return !facts.dashpots && how.counts_drag && how.info.order_with_damping > 0;
}

bool integrates_drag_work(const RunDescription& description) {
    return has_drag(description) && keeps_drag_work(description);
}

bool chooses_its_steps(const RunDescription& description) {
    const ParameterValues& values = description.method_parameters;
    return values.contains("tolerance") && values["tolerance"] > 0;
}

std::uint64_t steps_until(double duration, double dt) {
    return static_cast<std::uint64_t>(std::ceil(duration / dt * (1 - 1e-12)));
}

RunEnd run_end(const RunDescription& description, double until) {
    const std::uint64_t steps = steps_until(until, description.dt);
    if (steps == 0 || !chooses_its_steps(description)) return {steps};
    const double reached = static_cast<double>(steps) * rounded_to(description.precision, description.dt);
    // up to rounding the steps end there anyway
    return std::abs(reached - until) <= 1e-6 * std::abs(description.dt) ? RunEnd{steps} : RunEnd{steps, until};
}

}  // namespace steplab
