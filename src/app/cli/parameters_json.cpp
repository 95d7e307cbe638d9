#include "app/cli/parameters_json.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace steplab {

using Json = nlohmann::ordered_json;

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

namespace {

std::string_view kind_text(ParameterInfo::Kind kind) {
    switch (kind) {
        case ParameterInfo::Kind::integer:
            return "integer";
        case ParameterInfo::Kind::choice:
            return "choice";
        case ParameterInfo::Kind::real:
            break;
    }
    return "real";
}

Json default_json(const ParameterInfo& info) {
    if (info.kind == ParameterInfo::Kind::choice) return format_value(info, info.default_value);
    if (info.kind == ParameterInfo::Kind::integer) return static_cast<std::int64_t>(info.default_value);
    return info.default_value;
}

Json parameter_json(const ParameterInfo& info) {
    Json json{{"name", info.name}, {"what", info.what}, {"kind", kind_text(info.kind)}, {"unit", info.unit}};
    if (info.kind == ParameterInfo::Kind::choice) {
        json["choices"] = std::vector<std::string_view>(info.choices.begin(), info.choices.end());
    } else {
        json["minimum"] = json_number(info.minimum);
        json["minimum_included"] = info.minimum_included;
        json["maximum"] = json_number(info.maximum);
    }
    json["range"] = range_text(info);
    json["default"] = default_json(info);
    json["on_change"] = info.on_change == OnChange::applies_live ? "applies live" : "restarts";
    return json;
}

}  // namespace

Json parameters_json(std::span<const ParameterInfo> parameters) {
    Json list = Json::array();
    for (const ParameterInfo& info : parameters) list.push_back(parameter_json(info));
    return list;
}

}  // namespace steplab
