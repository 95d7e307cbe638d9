#include "app/cli/catalogue_text.hpp"
#include "sim/catalogue.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: no limit is null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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
        json["minimum"] = number(info.minimum);
        json["minimum_included"] = info.minimum_included;
        json["maximum"] = number(info.maximum);
    }
    json["range"] = range_text(info);
    json["default"] = default_json(info);
    json["on_change"] = info.on_change == OnChange::applies_live ? "applies live" : "restarts";
    return json;
}

Json parameters_json(std::span<const ParameterInfo> parameters) {
    Json list = Json::array();
    for (const ParameterInfo& info : parameters) list.push_back(parameter_json(info));
    return list;
}

Json model_json(const Model& model) {
    const ModelInfo& info = model.info;
    return {{"id", info.id},
            {"name", info.name},
            {"what", info.what},
            {"opening", {{"method", model.opening.method}, {"dt", model.opening.dt}}},
            {"parameters", parameters_json(info.parameters)}};
}

Json method_json(const MethodInfo& info) {
    const ParameterValues defaults(info.parameters);
    return {{"id", info.id},
            {"name", info.name},
            {"what", info.what},
            {"order", info.order},
            {"order_with_drag", info.order_with_drag},
            {"order_with_damping", info.order_with_damping},
            {"evaluations_per_step", evaluations_per_step(info, defaults)},
            {"start_evaluations", info.start_evaluations},
            {"linear_limit", number(linear_limit(info, defaults))},
            {"symplectic", info.symplectic},
            {"reversible", info.reversible},
            {"adaptive", info.adaptive},
            {"implicit", info.implicit},
            {"curiosity", info.curiosity},
            {"conserves", info.conserves},
            {"source", info.source},
            {"parameters", parameters_json(info.parameters)}};
}

}  // namespace

std::string catalogue_json(bool with_models, bool with_methods) {
    Json json = Json::object();
    if (with_models) {
        json["models"] = Json::array();
        for (const Model& model : models()) json["models"].push_back(model_json(model));
    }
    if (with_methods) {
        json["methods"] = Json::array();
        for (const Method& method : methods()) json["methods"].push_back(method_json(method.info));
    }
    return json.dump(2) + "\n";
}

}  // namespace steplab
