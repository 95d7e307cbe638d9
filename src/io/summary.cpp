#include "io/summary.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/carried_json.hpp"
#include "io/commit.hpp"
#include "io/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace steplab {

namespace {

/// dt of a float run as 0.1 instead of 0.10000000149: the shortest text that reads back as the same float.
double shortest(Precision precision, double dt) {
    if (precision == Precision::double_) return dt;
    return parse_number(number_text(static_cast<float>(dt))).value_or(dt);
}

nlohmann::ordered_json collisions_json(const CollisionRecord& collisions) {
    nlohmann::ordered_json kept = nlohmann::ordered_json::array();
    for (const Collision& collision : collisions.kept())
        kept.push_back({{"time", collision.time}, {"particles", {collision.first, collision.second}}});
    return {{"count", collisions.count()}, {"first", kept}};
}

/// Every parameter of model and method by its name: with the rest of a summary enough to repeat the run.
nlohmann::ordered_json parameters_json(const RunDescription& run) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const ParameterValues* values : {&run.scene, &run.method_parameters}) {
        for (const ParameterInfo& info : values->infos()) {
            const double value = (*values)[info.name];
            const std::string name(info.name);
            if (info.kind == ParameterInfo::Kind::real)
                json[name] = value;
            else if (info.kind == ParameterInfo::Kind::integer)
                json[name] = static_cast<std::int64_t>(value);
            else
                json[name] = format_value(info, value);
        }
    }
    return json;
}

/// The files of the scene, and where the run starts if not where its scene does.
void add_carried(nlohmann::ordered_json& json, const RunDescription& run) {
    if (run.origin) json["scene"] = json_of(*run.origin);
    if (!run.start.is_none()) json["start"] = json_of(run.start);
}

/// What drag takes is no error.
bool energy_error_is_change(const RunSummary& summary) { return has_drag(summary.run) && !summary.result.drag_work; }

/// The fields that may differ between the runs of an ensemble, which have notes and wall time in common.
void add_result(nlohmann::ordered_json& json, const RunSummary& summary, bool timed) {
    const RunResult& result = summary.result;
    json["dt"] = shortest(summary.run.precision, result.dt);
    json["steps"] = result.steps;
    if (summary.until) json["until"] = *summary.until;
    json["time"] = result.time;
    json["particles"] = result.particles;
    json["evaluations"] = result.evaluations;
    json["energy_start"] = result.energy_start;
    json["energy_end"] = result.energy_end;
    json["energy_error"] = result.energy_error;
    if (result.drag_work) json["drag_work"] = *result.drag_work;
    if (energy_error_is_change(summary)) json["energy_change"] = std::exchange(json["energy_error"], nullptr);
    if (result.error) json["error"] = *result.error;
    if (timed) json["notes"] = summary.notes;
    if (timed) json["wall_seconds"] = summary.wall_seconds;
    json["hash"] = result.hash;
    json["status"] = result.status();
    if (result.divergence) {
        json[result.status() + "_step"] = *result.diverged_step();
        json["reason"] = result.divergence->message;
    }
    if (result.collisions.count() > 0) json["collisions"] = collisions_json(result.collisions);
}

/// "6: particles 6 and 18 at t = 0.9379 s, 8 and 20 at 0.9382 s, ..."
std::string collisions_text(const CollisionRecord& collisions) {
    constexpr std::size_t most = 4;
    std::string text = fmt::format("{}", collisions.count());
    for (std::size_t i = 0; i < std::min(most, collisions.kept().size()); ++i) {
        const Collision& collision = collisions.kept()[i];
        text += fmt::format("{}{} and {} at {}{} s", i == 0 ? ": particles " : ", ", collision.first, collision.second,
                            i == 0 ? "t = " : "", short_number(collision.time));
    }
    return text + (collisions.count() > most ? ", ..." : "");
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
    nlohmann::ordered_json json{{"version", STEPLAB_VERSION},
                                {"commit", STEPLAB_COMMIT},
                                {"model", summary.run.model},
                                {"method", summary.run.method},
                                {"precision", id(summary.run.precision)},
                                {"parameters", parameters_json(summary.run)}};
    add_carried(json, summary.run);
    add_result(json, summary, true);
    return json_text(json);
}

std::string summary_text(const RunSummary& summary) {
    const RunDescription& run = summary.run;
    const RunResult& result = summary.result;
    const std::string dt = number_text(shortest(run.precision, result.dt));
    std::string text = fmt::format("{} with {}, {}, dt {}\n", shown(run.model), run.method, id(run.precision), dt);
    const auto line = [&text](std::string_view what, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", what, value);
    };
    line("particles", fmt::format("{}", result.particles));
    line("steps", fmt::format("{}", result.steps));
    line("time", short_number(result.time) + " s");
    line("evaluations", fmt::format("{}", result.evaluations));
    line("energy", fmt::format("{} J at the start, {} J at the end", short_number(result.energy_start),
                               short_number(result.energy_end)));
    line(energy_error_is_change(summary) ? "energy change" : "energy error",
         fmt::format("{} J at most, over the written steps (--every)", short_number(result.energy_error)));
    if (result.drag_work) line("work of drag", short_number(*result.drag_work) + " J, counted in the energy error");
    if (result.error) line("error", short_number(*result.error) + " m at the end, against the exact solution");
    if (result.collisions.count() > 0) line("collisions", collisions_text(result.collisions));
    line("wall time", duration_text(summary.wall_seconds));
    line("hash", result.hash);
    line("status", result.divergence ? fmt::format("{} in step {}", result.status(), *result.diverged_step()) : "ok");
    return text;
}

std::size_t EnsembleSummary::diverged() const {
    return static_cast<std::size_t>(std::count_if(
        runs.begin(), runs.end(), [](const Run& run) { return run.summary.result.divergence.has_value(); }));
}

std::string summary_json(const EnsembleSummary& summary) {
    const RunDescription& first = summary.runs.front().summary.run;
    nlohmann::ordered_json ranges = nlohmann::ordered_json::array(), runs = nlohmann::ordered_json::array();
    for (const auto& [name, from, to] : summary.ranges) ranges.push_back({{"name", name}, {"from", from}, {"to", to}});
    for (std::size_t i = 0; i < summary.runs.size(); ++i) {
        nlohmann::ordered_json set = nlohmann::ordered_json::object(), run{{"run", i}};
        for (std::size_t k = 0; k < summary.ranges.size(); ++k) set[summary.ranges[k].name] = summary.runs[i].values[k];
        run["set"] = set;
        add_result(run, summary.runs[i].summary, false);
        runs.push_back(std::move(run));
    }
    nlohmann::ordered_json json{
        {"version", STEPLAB_VERSION}, {"commit", STEPLAB_COMMIT},         {"model", first.model},
        {"method", first.method},     {"precision", id(first.precision)}, {"parameters", parameters_json(first)}};
    add_carried(json, first);
    json["ensemble"] = summary.runs.size();
    json["spread"] = ranges;
    json["diverged"] = summary.diverged();
    json["notes"] = summary.notes;
    json["wall_seconds"] = summary.wall_seconds;
    json["runs"] = runs;
    return json_text(json);
}

std::string summary_text(const EnsembleSummary& summary) {
    const RunDescription& first = summary.runs.front().summary.run;
    std::string text = fmt::format("{} runs of {} with {}, {}\n", summary.runs.size(), shown(first.model), first.method,
                                   id(first.precision));
    const auto line = [&text](std::string_view what, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", what, value);
    };
    for (const auto& [name, from, to] : summary.ranges)
        line(name, fmt::format("{} to {}", number_text(from), number_text(to)));
    std::uint64_t steps = 0;
    double error = 0;
    bool is_change = false;
    for (const auto& run : summary.runs) {
        is_change = is_change || energy_error_is_change(run.summary);
        steps += run.summary.result.steps;
        error = std::max(error, run.summary.result.energy_error);
    }
    line("steps", fmt::format("{} in total", steps));
    line(is_change ? "energy change" : "energy error",
         fmt::format("{} J at most, over the written steps (--every) of all runs", short_number(error)));
    line("wall time", duration_text(summary.wall_seconds));
    line("status", summary.diverged() == 0 ? "ok"
                                           : fmt::format("{} diverged, {} ok", summary.diverged(),
                                                         summary.runs.size() - summary.diverged()));
    return text;
}

}  // namespace steplab
