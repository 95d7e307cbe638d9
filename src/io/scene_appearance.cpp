#include "io/scene_appearance.hpp"

#include "core/appearance.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "models/model.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace steplab {

namespace {

/// What a check says of a value becomes a problem at its place.
template <class Check>
void check_at(const toml::node& node, const Check& check) {
    try {
        check();
    } catch (const UsageError& error) {
        fail_at(node, error.what());
    }
}

std::string value_text(const toml::node& node) {
    return node.is_number() ? number_text(*node.value<double>()) : text_of(node);
}

}  // namespace

void read_method_parameters(const toml::node& node, SceneDefaults& defaults) {
    const MethodInfo& info =
        method(defaults.method.empty() ? Opening{}.method : std::string_view(defaults.method)).info;
    ParameterValues values(info.parameters);
    std::vector<KeyHandler> handlers;
    for (const ParameterInfo& parameter : info.parameters) {
        handlers.push_back({parameter.name, [&values, &defaults, name = parameter.name](const toml::node& given) {
                                const std::string text = value_text(given);
                                check_at(given, [&] { values.set_text(name, text); });
                                defaults.method_parameters[std::string(name)] = text;
                            }});
    }
    read_all_keys(table_of(node, "parameters"), fmt::format("the parameters of {}", info.id), handlers);
}

void read_view(const toml::node& node, SceneDefaults& defaults) {
    const auto keep = [](std::string& kept, auto check) {
        return [&kept, check](const toml::node& given) {
            const std::string text = text_of(given);
            check_at(given, [&] { check(text); });
            kept = text;
        };
    };
    read_all_keys(table_of(node, "[view]"), "[view]",
                  {{"camera", keep(defaults.camera, [](const std::string& text) { parse_view(text, "camera"); })},
                   {"colour", keep(defaults.colour, [](const std::string& text) { colouring_of(text); })},
                   {"background", keep(defaults.background, [](const std::string& text) { background_of(text); })}});
}

std::string read_topic(const toml::node& node) { return word_of(node, "topic", {topic_ids.begin(), topic_ids.end()}); }

}  // namespace steplab
