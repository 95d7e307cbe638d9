#include "lab/study/speed_error_csv.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace steplab {

const char* const speed_error_header =
    "model,method,precision,dt,steps,evaluations,wall_s,error,energy_error,status,hash,rms_error,tolerance,settings";

namespace {

std::string cell(const std::optional<double>& value) { return value ? number_text(*value) : std::string(); }

/// The name of a scene file may be any.
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

std::string settings(const ParameterValues& values) {
    std::string text;
    for (const auto& info : values.infos()) {
        if (values[info.name] == info.default_value || info.name == "tolerance") continue;
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", info.name, format_value(info, values[info.name]));
    }
    return text;
}

std::string line(const Measurement& m) {
    const RunDescription& run = m.run;
    const auto good = [&](double value) { return m.diverged() ? std::optional<double>() : value; };
    const bool has_tolerance = run.method_parameters.contains("tolerance");
    const std::string of_scene = settings(run.scene), of_method = settings(run.method_parameters);
    return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", cell(run.model), run.method, id(run.precision),
                       number_text(run.dt), m.steps, m.result.evaluations, cell(m.wall_seconds), cell(good(m.error)),
                       cell(good(m.result.energy_error)), m.diverged() ? "diverged" : "ok", m.result.hash,
                       cell(good(m.rms_error)), has_tolerance ? number_text(run.method_parameters["tolerance"]) : "",
                       of_scene + (of_scene.empty() || of_method.empty() ? "" : " ") + of_method);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

[[noreturn]] void refuse(std::string_view line) {
    throw FileError(fmt::format("'{}' is not a line of speed_error.csv", shown(line)));
}

std::optional<double> number(std::string_view cell, std::string_view line) {
    if (cell.empty()) return std::nullopt;
    const auto value = parse_number(cell);
    if (!value) refuse(line);
    return value;
}

RunDescription run_of(const RunDescription& scene, const std::vector<std::string_view>& cells, std::string_view line) {
    RunDescription run = with_method(scene, cells[0]);
    const std::optional<Precision> precision = parse_precision(cells[1]);
    if (!precision) refuse(line);
    run.precision = *precision;
    run.dt = number(cells[2], line).value_or(0);
    if (!cells[11].empty()) run.method_parameters.set("tolerance", number(cells[11], line).value_or(0));
    if (cells[12].empty()) return run;
    for (const std::string_view setting : split(cells[12], ' ')) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string_view::npos) refuse(line);
        set_parameter(run, setting.substr(0, equals), setting.substr(equals + 1));
    }
    return run;
}

Measurement parsed(std::string_view line, const RunDescription& scene) {
    const std::string name = cell(scene.model) + ",";
    if (!line.starts_with(name)) refuse(line);
    const auto cells = split(line.substr(name.size()), ',');
    if (cells.size() != 13) refuse(line);
    const auto value = [&](std::size_t cell) { return number(cells[cell], line).value_or(0); };
    RunResult result{
        .evaluations = static_cast<std::uint64_t>(value(4)), .energy_error = value(7), .hash = std::string(cells[9])};
    if (cells[8] != "ok") result.divergence.emplace();
    return {.run = run_of(scene, cells, line),
            .steps = static_cast<std::uint64_t>(value(3)),
            .result = std::move(result),
            .error = value(6),
            .rms_error = value(10),
            .wall_seconds = number(cells[5], line)};
}

}  // namespace

std::string speed_error_csv(std::span<const Measurement> measurements) {
    std::string text = std::string(speed_error_header) + "\n";
    for (const Measurement& m : measurements) text += line(m);
    return text;
}

std::vector<Measurement> parse_speed_error_csv(std::string_view text, const RunDescription& scene) {
    std::vector<Measurement> measurements;
    for (const std::string_view line : split(text, '\n')) {
        if (!line.empty() && line != speed_error_header) measurements.push_back(parsed(line, scene));
    }
    return measurements;
}

}  // namespace steplab
