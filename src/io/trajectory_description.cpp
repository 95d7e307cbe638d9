#include "io/trajectory_description.hpp"

#include "io/commit.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace steplab::trajectory {

namespace {

using Json = nlohmann::ordered_json;

/// A choice as its word, everything else as a number.
Json json_of(const ParameterValues& values) {
    Json json = Json::object();
    for (const ParameterInfo& info : values.infos()) {
        const std::string name(info.name);
        const double value = values[info.name];
        if (info.kind == ParameterInfo::Kind::choice) {
            json[name] = format_value(info, value);
        } else {
            json[name] = value;
        }
    }
    return json;
}

Json json_of(const RunDescription& run) {
    return {{"model", run.model},
            {"parameters", json_of(run.scene)},
            {"method", run.method},
            {"method_parameters", json_of(run.method_parameters)},
            {"precision", id(run.precision)},
            {"dt", run.dt},
            {"command_line", command_line(run)}};
}

void set_parameters(ParameterValues& values, const Json& json) {
    for (const auto& [name, value] : json.items()) {
        if (value.is_string()) {
            values.set_text(name, value.get<std::string>());
        } else {
            values.set(name, value.get<double>());
        }
    }
}

/// [[0, 4], [9, 1]]: the particles 0 to 3 and 9.
Json particle_runs(const FrameBlock& block) {
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    for (std::size_t row = 0; row < block.frame_rows; ++row) {
        const std::size_t particle = block.particle(row);
        if (runs.empty() || runs.back().first + runs.back().second != particle) runs.emplace_back(particle, 0);
        ++runs.back().second;
    }
    return runs;
}

/// [["fixed", 1], ["moving", 9]]
Json role_runs(const FrameBlock& block) {
    std::vector<std::pair<std::string_view, std::size_t>> runs;
    for (std::size_t row = 0; row < block.frame_rows; ++row) {
        const std::string_view role = id(block.role(row));
        if (runs.empty() || runs.back().first != role) runs.emplace_back(role, 0);
        ++runs.back().second;
    }
    return runs;
}

Json box_json(const Shape& shape) {
    return {{"edge", shape.period}, {"corner", {shape.corner.x, shape.corner.y, shape.corner.z}}};
}

void set_box(Shape& shape, const Json& json) {
    shape.period = json.at("edge");
    if (!(shape.period > 0)) throw std::runtime_error("no box");
    const Json& corner = json.at("corner");
    shape.corner = {corner.at(0), corner.at(1), corner.at(2)};
}

std::size_t count_of(const Json& json) {
    if (!json.is_number_unsigned()) throw std::runtime_error("no count");
    return json;
}

Role role_of(std::string_view name) {
    for (const Role role : {Role::moving, Role::fixed, Role::kicked, Role::bullet}) {
        if (id(role) == name) return role;
    }
    throw std::runtime_error("no role");
}

Precision precision_of(const Json& run) {
    if (const auto precision = parse_precision(run.at("precision").get<std::string>())) return *precision;
    throw std::runtime_error("no precision");
}

}  // namespace

std::string description_json(const RunDescription& run, const FrameBlock& block) {
    Json json{{"program", "steplab " STEPLAB_VERSION},
              {"run", json_of(run)},
              {"rows", block.frame_rows},
              {"particles", particle_runs(block)},
              {"roles", role_runs(block)}};
    if (block.shape->period != 0) json["box"] = box_json(*block.shape);
    return json.dump() + "\n";
}

Description parse_description(std::string_view text, std::uint64_t most_rows) {
    const Json json = Json::parse(text);
    Description description;
    description.program = json.at("program");
    description.run = json.at("run").dump();
    description.precision = precision_of(json.at("run"));
    description.rows = count_of(json.at("rows"));
    if (description.rows == 0 || description.rows > most_rows) throw std::runtime_error("no such number of rows");
    std::vector<std::size_t> particles;
    for (const Json& run : json.at("particles")) {
        const std::size_t first = count_of(run.at(0)), count = count_of(run.at(1));
        if (count > description.rows - particles.size()) throw std::runtime_error("too many particles");
        for (std::size_t i = 0; i < count; ++i) particles.push_back(first + i);
    }
    Shape shape;
    for (const Json& run : json.at("roles")) {
        const std::size_t count = count_of(run.at(1));
        if (count > description.rows - shape.roles.size()) throw std::runtime_error("too many roles");
        shape.roles.insert(shape.roles.end(), count, role_of(run.at(0).get<std::string>()));
    }
    if (particles.size() != description.rows || shape.roles.size() != description.rows)
        throw std::runtime_error("too few particles");
    if (json.contains("box")) set_box(shape, json.at("box"));
    description.particles = std::make_shared<const std::vector<std::size_t>>(std::move(particles));
    description.shape = std::make_shared<const Shape>(std::move(shape));
    return description;
}

RunDescription parse_run(const std::string& text) {
    const Json json = Json::parse(text);
    RunDescription run = describe(json.at("model").get<std::string>(), json.at("method").get<std::string>());
    set_parameters(run.scene, json.at("parameters"));
    set_parameters(run.method_parameters, json.at("method_parameters"));
    run.precision = precision_of(json);
    run.dt = json.at("dt");
    return run;
}

}  // namespace steplab::trajectory
