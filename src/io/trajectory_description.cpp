#include "io/trajectory_description.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/carried_json.hpp"
#include "io/commit.hpp"
#include "io/json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace steplab::trajectory {

namespace {

using Json = nlohmann::ordered_json;

std::size_t count_of(const Json& json) {
    if (!json.is_number_unsigned()) throw std::runtime_error("no count");
    return json;
}

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

Json run_json(const RunDescription& run) {
    return {{"model", run.model},
            {"parameters", json_of(run.scene)},
            {"method", run.method},
            {"method_parameters", json_of(run.method_parameters)},
            {"precision", id(run.precision)},
            {"dt", run.dt},
            {"command_line", command_line(run)}};
}

Json json_of(const RunDescription& run) {
    Json json = run_json(run);
    if (run.origin) json["scene"] = steplab::json_of(*run.origin);
    if (!run.start.is_none()) json["start"] = steplab::json_of(run.start);
    return json;
}

void set_parameters(ParameterValues& values, const Json& json) {
    for (const auto& [name, value] : json.items()) {
        if (!values.contains(name)) throw UsageError("unknown parameter '" + shown(name) + "'");
        if (value.is_string()) {
            values.set_text(name, value.get<std::string>());
        } else {
            values.set(name, value.get<double>());
        }
    }
}

/// [[0, 4], [9, 1]]: the particles 0 to 3 and 9.
Json json_of(const Runs<std::uint64_t>& particles) {
    Json json = Json::array();
    for (const auto& run : particles.runs()) json.push_back({run.value, run.count});
    return json;
}

/// [[2.5, 1], [1, 9]]
Json json_of(const Runs<double>& masses) {
    Json json = Json::array();
    for (const auto& run : masses.runs()) json.push_back({run.value, run.count});
    return json;
}

/// [["fixed", 1], ["moving", 9]]
Json json_of(const Runs<Role>& roles) {
    Json json = Json::array();
    for (const auto& run : roles.runs()) json.push_back({id(run.value), run.count});
    return json;
}

Json json_of(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vector_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

Json json_of(const Lattice& lattice) {
    if (lattice.points) {
        Json points = Json::array();
        for (const Vec3 point : *lattice.points) points.push_back(json_of(point));
        return {{"points", points}};
    }
    return {{"columns", lattice.columns},
            {"along_row", json_of(lattice.along_row)},
            {"between_rows", json_of(lattice.between_rows)}};
}

Lattice lattice_of(const Json& json) {
    Lattice lattice;
    if (json.contains("points")) {
        std::vector<Vec3> points;
        for (const Json& point : json.at("points")) points.push_back(vector_of(point));
        lattice.count = points.size();
        lattice.points = std::make_shared<const std::vector<Vec3>>(std::move(points));
        return lattice;
    }
    lattice.columns = count_of(json.at("columns"));
    if (lattice.columns == 0) throw std::runtime_error("no columns");
    lattice.along_row = vector_of(json.at("along_row"));
    lattice.between_rows = vector_of(json.at("between_rows"));
    return lattice;
}

Role role_of(std::string_view name) {
    if (const auto role = parse_role(name)) return *role;
    throw std::runtime_error("no role");
}

Precision precision_of(const Json& run) {
    if (const auto precision = parse_precision(run.at("precision").get<std::string>())) return *precision;
    throw std::runtime_error("no precision");
}

/// The dictionaries of a description lie in each other four deep; deeper ones may overflow the stack later.
Json parse_json(std::string_view text) {
    constexpr int deepest = 16;
    return Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest) throw std::runtime_error("too deep");
        return true;
    });
}

/// Files of the first version have the mass among the parameters of the run alone.
double mass_of(const Json& json, Precision precision) {
    if (json.contains("mass")) return json.at("mass");
    const Json& parameters = json.at("run").at("parameters");
    return parameters.contains("m") ? rounded_to(precision, parameters.at("m")) : 0;
}

/// A cube has one edge, any other box three sides.
Vec3 box_of(const Json& json) {
    const double edge = json.contains("edge") ? json.at("edge").get<double>() : 0;
    const Vec3 box = json.contains("sides") ? vector_of(json.at("sides")) : Vec3{edge, edge, edge};
    if (!(box.x >= 0 && box.y >= 0 && box.z >= 0) || box == Vec3{}) throw std::runtime_error("no box");
    return box;
}

FileScene scene_of(const Json& json, Version version) {
    FileScene scene;
    scene.precision = precision_of(json.at("run"));
    scene.mass = mass_of(json, scene.precision);
    if (version == Version::displacements) scene.reference = lattice_of(json.at("reference"));
    if (!json.contains("box")) return scene;
    scene.box = box_of(json.at("box"));
    scene.corner = vector_of(json.at("box").at("corner"));
    return scene;
}

}  // namespace

void RowList::name(FrameBlock& block) const {
    particles.each(block.first_row, block.rows,
                   [&](std::uint64_t first, std::uint64_t offset) { block.particles.push_back(first + offset); });
    roles.each(block.first_row, block.rows, [&](Role role, std::uint64_t) { block.roles.push_back(role); });
    if (masses.size() == 0) return;
    masses.each(block.first_row, block.rows, [&](double mass, std::uint64_t) { block.masses.push_back(mass); });
}

RowList row_list(const Frame& frame, const ParticleChoice& chosen) {
    RowList list;
    const std::size_t rows = FrameBlock::rows_of(frame, chosen);
    const auto particle = [&](std::size_t row) { return chosen ? (*chosen)[row] : row; };
    const auto role = [&](std::size_t row) { return frame.shape->roles[particle(row)]; };
    for (std::size_t begin = 0, end = 0; begin < rows; begin = end) {
        while (end < rows && particle(end) - particle(begin) == end - begin) ++end;
        list.particles.add(particle(begin), end - begin);
    }
    for (std::size_t begin = 0, end = 0; begin < rows; begin = end) {
        while (end < rows && role(end) == role(begin)) ++end;
        list.roles.add(role(begin), end - begin);
    }
    if (frame.shape->masses.empty()) return list;
    const auto mass = [&](std::size_t row) { return frame.shape->masses[particle(row)]; };
    for (std::size_t begin = 0, end = 0; begin < rows; begin = end) {
        while (end < rows && mass(end) == mass(begin)) ++end;
        list.masses.add(mass(begin), end - begin);
    }
    return list;
}

std::string description_json(const RunDescription& run, const FileScene& scene, const RowList& rows) {
    Json json{{"program", "steplab " STEPLAB_VERSION}, {"run", json_of(run)},          {"rows", rows.particles.size()},
              {"particles", json_of(rows.particles)},  {"roles", json_of(rows.roles)}, {"mass", scene.mass}};
    if (rows.masses.size() > 0) json["masses"] = json_of(rows.masses);
    if (scene.reference) json["reference"] = json_of(*scene.reference);
    const Vec3& box = scene.box;
    if (box != Vec3{}) {
        const bool is_cube = box.x == box.y && box.y == box.z;
        const Json corner = json_of(scene.corner);
        json["box"] =
            is_cube ? Json{{"edge", box.x}, {"corner", corner}} : Json{{"sides", json_of(box)}, {"corner", corner}};
    }
    return json_text(json, one_line);
}

Description parse_description(std::string_view text, Version version) {
    const Json json = parse_json(text);
    Description description;
    description.program = json.at("program");
    description.run = json.at("run").dump();
    description.rows = count_of(json.at("rows"));
    description.scene = scene_of(json, version);
    if (description.rows == 0) throw std::runtime_error("no rows");
    RowList& list = description.list;
    for (const Json& run : json.at("particles")) {
        const std::uint64_t count = count_of(run.at(1));
        if (count == 0 || count > description.rows - list.particles.size()) throw std::runtime_error("no particles");
        list.particles.add(count_of(run.at(0)), count);
    }
    for (const Json& run : json.at("roles")) {
        const std::uint64_t count = count_of(run.at(1));
        if (count == 0 || count > description.rows - list.roles.size()) throw std::runtime_error("no roles");
        list.roles.add(role_of(run.at(0).get<std::string>()), count);
    }
    for (const Json& run : json.value("masses", Json::array())) {
        const std::uint64_t count = count_of(run.at(1));
        if (count == 0 || count > description.rows - list.masses.size()) throw std::runtime_error("no masses");
        list.masses.add(run.at(0).get<double>(), count);
    }
    const bool masses = list.masses.size() == 0 || list.masses.size() == description.rows;
    if (!masses || list.particles.size() != description.rows || list.roles.size() != description.rows)
        throw std::runtime_error("too few particles");
    const auto& reference = description.scene.reference;
    for (const auto& run : list.particles.runs()) {
        const std::size_t points = reference && reference->points ? reference->points->size() : ~std::size_t{0};
        if (run.value > points || run.count > points - run.value)
            throw std::runtime_error("too few reference positions");
    }
    return description;
}

std::string run_text(const RunDescription& run) { return json_text(json_of(run), one_line); }

RunDescription parse_run(const std::string& text) {
    const Json json = parse_json(text);
    const std::string method = json.at("method");
    RunDescription run = json.contains("scene") ? with_method(describe(origin_of(json.at("scene"))), method)
                                                : describe(json.at("model").get<std::string>(), method);
    set_parameters(run.scene, json.at("parameters"));
    set_parameters(run.method_parameters, json.at("method_parameters"));
    run.precision = precision_of(json);
    run.dt = json.at("dt");
    if (json.contains("start")) run.start = start_of(json.at("start"));
    return run;
}

}  // namespace steplab::trajectory
