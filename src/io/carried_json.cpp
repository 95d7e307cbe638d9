#include "io/carried_json.hpp"

#include "io/scene_file.hpp"
#include "io/starting_values_file.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

using Json = nlohmann::ordered_json;

Json json_of(const SceneFile& file) {
    Json parts = Json::array();
    for (const SceneFile::Part& part : file.parts) parts.push_back({{"name", part.name}, {"content", part.content}});
    return {{"name", file.given}, {"files", parts}};
}

SceneOrigin origin_of(const Json& json) {
    std::vector<SceneFile::Part> parts;
    for (const Json& part : json.at("files")) parts.push_back({part.at("name"), part.at("content")});
    if (parts.empty()) throw std::runtime_error("no scene");
    return scene_from(std::move(parts), json.at("name"));
}

Json json_of(const StartChange& start) {
    Json json = Json::object();
    if (start.from) json["from"] = {{"name", start.from->given}, {"content", csv_text(*start.from)}};
    json["reverse"] = start.reverse;
    return json;
}

StartChange start_of(const Json& json) {
    StartChange start;
    start.reverse = json.at("reverse");
    if (!json.contains("from")) return start;
    const Json& from = json.at("from");
    const auto text = std::make_shared<const std::string>(from.at("content").get<std::string>());
    const std::string name = from.at("name");
    StartingValues values = starting_values(TextInput(name, text), {});
    values.given = name;
    start.from = std::make_shared<const StartingValues>(std::move(values));
    return start;
}

}  // namespace steplab
