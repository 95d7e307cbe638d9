#include "lab/study/saved_study.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/json_text.hpp"
#include "io/output_file.hpp"
#include "io/trajectory_layout.hpp"
#include "lab/study/speed_error_csv.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <system_error>

namespace steplab {

namespace {

using Json = nlohmann::json;

/// Everything that makes measurements comparable: the plan, the program and the machine.
std::string key(const StudyPlan& plan) {
    const Circumstances made = circumstances();
    std::string text = fmt::format("{} to {} with", command_line(plan.scene), number_text(plan.time));
    if (plan.scene.origin) {
        for (const SceneFile::Part& part : plan.scene.origin->parts)
            text += fmt::format(" {:x}", trajectory::hash_of(part.content));
    }
    for (const std::string& method : plan.methods) text += " " + method;
    for (const auto& [name, value] : plan.method_settings) text += fmt::format(" {}={}", name, number_text(value));
    for (const Precision precision : plan.precisions) text += fmt::format(" {}", id(precision));
    return text + fmt::format(" {} {} {} {} by {} {} {} on {}", plan.most_seconds_a_run, plan.most_steps_a_run,
                              plan.ratio, plan.rounds, made.version, made.commit, made.compiler, made.processor);
}

/// As text, because JSON has no infinity.
Json step_json(const std::optional<double>& dt) { return dt ? Json(number_text(*dt)) : Json(nullptr); }

std::optional<double> step_of(const Json& json) {
    return json.is_null() ? std::nullopt : parse_number(json.get<std::string>());
}

Json json_of(const std::vector<CutSeries>& cut) {
    Json list = Json::array();
    for (const CutSeries& series : cut) list.push_back({series.method, id(series.precision)});
    return list;
}

std::vector<CutSeries> cut_of(const Json& list) {
    std::vector<CutSeries> cut;
    for (const Json& json : list) {
        const auto precision = parse_precision(json.at(1).get<std::string>());
        if (!precision) throw FileError("a series has an unknown precision");
        cut.push_back({json.at(0), *precision});
    }
    return cut;
}

Json json_of(const std::map<std::size_t, MeasuredSeries>& ahead) {
    Json list = Json::array();
    for (const auto& [place, series] : ahead) list.push_back({place, speed_error_csv(series.runs), series.cut});
    return list;
}

std::map<std::size_t, MeasuredSeries> ahead_of(const Json& list, const RunDescription& scene) {
    std::map<std::size_t, MeasuredSeries> ahead;
    for (const Json& json : list)
        ahead[json.at(0)] = {parse_speed_error_csv(json.at(1).get<std::string>(), scene), json.at(2)};
    return ahead;
}

Json json_of(const std::vector<Limit>& limits) {
    Json list = Json::array();
    for (const Limit& limit : limits) {
        list.push_back({{"method", limit.description.method},
                        {"omega_max", limit.omega_max},
                        {"theory", step_json(limit.theory)},
                        {"measured", step_json(limit.measured)},
                        {"note", limit.note}});
    }
    return list;
}

std::vector<Limit> limits_of(const Json& list, const StudyPlan& plan) {
    std::vector<Limit> limits;
    for (const Json& json : list) {
        limits.push_back({.description = run_over(plan, json.at("method"), plan.precisions.front(), 1),
                          .omega_max = json.at("omega_max"),
                          .theory = step_of(json.at("theory")),
                          .measured = step_of(json.at("measured")),
                          .note = json.at("note")});
    }
    return limits;
}

StudyState state_of(const Json& json, const StudyPlan& plan) {
    StudyState state{.reference = json.at("reference"),
                     .reference_error = json.at("reference_error"),
                     .series = {.runs = parse_speed_error_csv(json.at("runs").get<std::string>(), plan.scene),
                                .cut = cut_of(json.at("cut")),
                                .series = json.at("series"),
                                .ahead = ahead_of(json.at("ahead"), plan.scene),
                                .timed = json.at("timed")},
                     .limits = {}};
    if (json.contains("limits")) state.limits = limits_of(json.at("limits"), plan);
    return state;
}

}  // namespace

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw FileError(fmt::format("cannot create the folder '{}': {}", shown(folder.string()), error.message()));
}

SavedStudies::SavedStudies(const std::string& report_folder)
    : folder_(std::filesystem::path(report_folder) / ".measured") {
    make_folder(folder_);
}

std::string SavedStudies::file_of(const StudyPlan& plan) const {
    return (folder_ / (plan.scene.model + ".json")).string();
}

std::optional<StudyState> SavedStudies::find(const StudyPlan& plan) const {
    std::ifstream file(file_of(plan));
    const Json json = Json::parse(file, nullptr, false);  // a truncated file is discarded
    try {
        if (json.at("key") == key(plan)) return state_of(json, plan);
    } catch (const Json::exception&) {
    } catch (const Error&) {
    }
    return std::nullopt;
}

void SavedStudies::save(const StudyPlan& plan, const StudyState& state) const {
    Json json{{"key", key(plan)},
              {"reference", state.reference},
              {"reference_error", state.reference_error},
              {"runs", speed_error_csv(state.series.runs)},
              {"cut", json_of(state.series.cut)},
              {"series", state.series.series},
              {"ahead", json_of(state.series.ahead)},
              {"timed", state.series.timed}};
    if (state.limits) json["limits"] = json_of(*state.limits);
    OutputFile file(file_of(plan));
    file.write(json_text(json, one_line));
    file.commit();
}

void SavedStudies::remove() const {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

}  // namespace steplab
