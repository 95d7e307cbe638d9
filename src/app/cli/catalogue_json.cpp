#include "app/cli/catalogue_text.hpp"
#include "app/cli/parameters_json.hpp"
#include "sim/catalogue.hpp"

#include <nlohmann/json.hpp>

#include <string_view>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

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
            {"linear_limit", json_number(linear_limit(info, defaults))},
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
