#include "app/cli/scene_options.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_file.hpp"
#include "io/starting_values_file.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace steplab {

namespace {

constexpr std::string_view all_methods = "all";

/// Up to this number every integer is exactly a double.
constexpr double most_steps = 9007199254740992.0;

constexpr ParameterInfo dt_option = [] {
    ParameterInfo option = dt_parameter;
    option.name = "--dt";
    return option;
}();
constexpr ParameterInfo until_info{.name = "--until", .unit = "", .minimum = -infinity, .what = "end time"};
constexpr ParameterInfo steps_info{.name = "--steps",
                                   .kind = ParameterInfo::Kind::integer,
                                   .unit = "",
                                   .maximum = most_steps,
                                   .what = "number of steps"};

}  // namespace

Precision precision_of(std::string_view text) {
    if (const auto precision = parse_precision(text)) return *precision;
    constexpr std::array known{id(Precision::float_), id(Precision::double_)};
    throw UsageError(unknown_word("precision", text, known));
}

std::vector<Setting> parse_settings(const std::vector<std::string>& texts) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format("--set '{}' is not of the form name=value, such as --set n=20", shown(text)));
        const std::string name = text.substr(0, equals);
        for (const Setting& earlier : settings) {
            if (earlier.name == name)
                throw UsageError(fmt::format("parameter '{}' is set more than once", shown(name)));
        }
        settings.push_back({name, text.substr(equals + 1)});
    }
    return settings;
}

namespace {

bool has_parameter(const RunDescription& description, std::string_view name) {
    return description.scene.contains(name) || description.method_parameters.contains(name);
}

/// Throws UsageError if a setting is a parameter of none of the runs.
void check_known(const std::vector<Setting>& settings, const std::vector<RunDescription>& runs) {
    for (const Setting& setting : settings) {
        if (std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return has_parameter(run, setting.name); }))
            continue;
        std::vector<std::string_view> known;
        for (const ParameterInfo& info : runs.front().scene.infos()) known.push_back(info.name);
        for (const RunDescription& run : runs) {
            for (const ParameterInfo& info : run.method_parameters.infos()) {
                if (std::find(known.begin(), known.end(), info.name) == known.end()) known.push_back(info.name);
            }
        }
        throw UsageError(
            unknown_word("parameter", setting.name, known, fmt::format("{} and the methods", runs.front().model)));
    }
}

}  // namespace

void SceneOptions::declare(CLI::App& app) {
    app_ = &app;
    const RunDescription defaults = describe();
    model_ = defaults.model;
    method_ = defaults.method;
    precision_ = id(defaults.precision);
    dt_ = number_text(defaults.dt);
    const std::string group = "Scene";
    text_option(app, "--model", model_, "ID", fmt::format("Model to simulate (default {})", model_), group);
    text_option(app, "--scene", scene_, "FILE|NAME", "Scene file (TOML), or a scene of `steplab list scenes`", group);
    repeated_option(app, "--set", settings_, "name=value", "Parameter of the model or method; repeatable", group);
    const std::string_view many = methods_ == Methods::one_or_all ? "; all: every method" : "";
    text_option(app, "--method", method_, methods_ == Methods::one_or_all ? "ID|all" : "ID",
                methods_ == Methods::lammps ? "Integration method (velocity-verlet: the one that LAMMPS has)"
                                            : fmt::format("Integration method ({}{})", default_text(method_), many),
                group);
    text_option(app, "--precision", precision_, "float|double",
                methods_ == Methods::lammps
                    ? "Floating-point precision of the run (double: that of LAMMPS)"
                    : fmt::format("Floating-point precision of the run (default {})", precision_),
                group);
    text_option(app, "--dt", dt_, "X",
                fmt::format("Time step [s] ({}){}", default_text(dt_),
                            time_ == Time::both ? "; negative: backward in time, with a negative end time" : ""),
                group);
    text_option(app, "--from", from_, "FILE[:STEP]",
                "Start from the positions and velocities of a trajectory, CSV or XYZ (default: its last step)", group);
    flag_option(app, "--reverse", reverse_, "Turn all velocities round at the start", group);
    footer(app, catalogue_hint);
}

bool SceneOptions::any_given() const {
    constexpr std::array names{"--model", "--scene", "--set", "--method", "--precision", "--dt", "--from", "--reverse"};
    return std::any_of(names.begin(), names.end(), [this](const char* name) { return is_given(*app_, name); });
}
bool SceneOptions::names_method() const { return is_given(*app_, "--method"); }
bool SceneOptions::names_precision() const { return is_given(*app_, "--precision"); }

std::string SceneOptions::default_text(std::string_view fixed) const {
    return defaults_ == Defaults::fixed ? fmt::format("default {}", fixed) : "default: as suits the model";
}

/// The model or scene file, its parameters at their defaults.
RunDescription SceneOptions::chosen_scene() const {
    if (scene_.empty()) {
        RunDescription scene = describe(model_);
        scene.precision = precision_of(precision_);
        return scene;
    }
    if (steplab::is_given(*app_, "--model"))
        throw UsageError("--model and --scene both choose the scene: give only one of them");
    RunDescription scene = describe(find_scene(scene_));
    if (names_precision()) scene.precision = precision_of(precision_);
    return scene;
}

double SceneOptions::given_dt() const {
    ParameterInfo option = dt_option;
    if (time_ == Time::both && dt_.starts_with('-')) option.minimum = -infinity;
    return parse_value(option, dt_);
}

StartChange SceneOptions::start() const {
    StartChange start{.reverse = reverse_};
    if (!from_.empty()) start.from = std::make_shared<const StartingValues>(starting_values(from_));
    return start;
}

/// The dt that a model recommends depends on the parameters of the scene. A scene file says how it opens.
RunDescription SceneOptions::with_given_method(RunDescription scene) const {
    if (scene.origin) {
        RunDescription description = names_method() ? with_method(scene, method_) : scene;
        if (steplab::is_given(*app_, "--dt")) description.dt = given_dt();
        return description;
    }
    const bool recommends = defaults_ == Defaults::recommended;
    RunDescription description = recommends && !names_method() ? opening(scene) : with_method(scene, method_);
    description.dt = recommends && !steplab::is_given(*app_, "--dt") ? opening_dt(scene) : given_dt();
    return description;
}

/// A scene file may say that it runs backward.
void SceneOptions::check_direction(const RunDescription& description) const {
    if (time_ == Time::forward && description.dt < 0)
        throw UsageError(
            fmt::format("the scene runs backward in time, dt = {}: give a --dt > 0 here", exact_text(description.dt)));
}

RunDescription SceneOptions::description() const {
    const std::vector<Setting> settings = parse_settings(settings_);
    RunDescription scene = chosen_scene();
    for (const Setting& setting : settings) {
        if (scene.scene.contains(setting.name)) scene.scene.set_text(setting.name, setting.text);
    }
    RunDescription description = with_given_method(scene);
    for (const Setting& setting : settings) set_parameter(description, setting.name, setting.text);
    description.start = start();
    check_direction(description);
    check(description);
    return description;
}

std::vector<RunDescription> SceneOptions::descriptions() const {
    if (method_ != all_methods) return {description()};
    const std::vector<Setting> settings = parse_settings(settings_);
    std::vector<RunDescription> runs;
    RunDescription scene = chosen_scene();
    scene.start = start();
    for (const Method& method : methods()) runs.push_back(with_method(scene, method.info.id));
    check_known(settings, runs);
    for (RunDescription& run : runs) {
        if (!run.origin || steplab::is_given(*app_, "--dt")) run.dt = given_dt();
        for (const Setting& setting : settings) {
            if (has_parameter(run, setting.name)) set_parameter(run, setting.name, setting.text);
        }
    }
    check_direction(runs.front());
    check(runs.front());
    return runs;
}

void TimeOptions::declare(CLI::App& app) {
    const std::string group = "Time";
    const std::string_view before = default_ == Default::scene ? "the end that a scene file gives, else " : "";
    text_option(app, "--steps", steps_, "N", fmt::format("Number of steps (default {}{})", before, default_steps_),
                group);
    text_option(app, "--until", until_, "T", "End time [s], instead of --steps", group);
}

std::uint64_t TimeOptions::steps(const RunDescription& description) const {
    if (!steps_.empty() && !until_.empty())
        throw UsageError("--steps and --until both set the length of the run: give only one of them");
    if (!steps_.empty()) return static_cast<std::uint64_t>(parse_value(steps_info, steps_));
    const std::optional<double> until = this->until(description);
    if (!until) return default_steps_;
    if (*until / description.dt < 0)
        throw UsageError(fmt::format("{} {} and dt = {} differ in sign: a negative dt goes with a negative end time",
                                     until_.empty() ? "the scene's until" : "--until", exact_text(*until),
                                     exact_text(description.dt)));
    if (*until / description.dt > most_steps) {
        throw UsageError(fmt::format("--until {} needs more than {} steps of dt {}", exact_text(*until),
                                     number_text(most_steps), exact_text(description.dt)));
    }
    return steps_until(*until, description.dt);
}

RunEnd TimeOptions::end(const RunDescription& description) const {
    const std::uint64_t number = steps(description);
    const std::optional<double> until = this->until(description);
    return until ? run_end(description, *until) : RunEnd{number};
}

std::optional<std::string> TimeOptions::note(const RunDescription& description, const RunEnd& end) const {
    const double dt = description.dt, time = static_cast<double>(end.step) * dt,
                 asked = until(description).value_or(time);
    if (end.time || std::abs(time - asked) <= 1e-6 * std::abs(dt)) return std::nullopt;
    return fmt::format("{} {} of dt = {} s end{} at t = {} s, not at {} s", end.step, end.step == 1 ? "step" : "steps",
                       typed(dt, 6), end.step == 1 ? "s" : "", typed(time, 6), typed(asked, 6));
}

std::optional<double> TimeOptions::until(const RunDescription& description) const {
    if (!until_.empty()) return parse_value(until_info, until_);
    const bool of_scene = default_ == Default::scene && steps_.empty();
    return of_scene ? model_of(description).opening.until : std::nullopt;
}

RunEnd TimeOptions::moment(const RunDescription& description) const {
    if (until_.empty() || !steps_.empty()) return end(description);
    return {.step = 0, .time = end_time(description)};
}

double TimeOptions::end_time(const RunDescription& description) const {
    return until(description).value_or(static_cast<double>(steps(description)) * description.dt);
}

double TimeOptions::duration(const RunDescription& description) const {
    const double time = end_time(description);
    if (!(time > 0)) throw UsageError("the end time must be > 0: give --until T, or --steps N with --dt X");
    return time;
}

}  // namespace steplab
