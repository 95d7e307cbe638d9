#include "io/scene_defaults.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_appearance.hpp"
#include "io/scene_blocks.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;
using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<std::string_view> method_ids() {
    std::vector<std::string_view> ids;
    ids.reserve(methods().size());
    for (const Method& method : methods()) ids.push_back(method.info.id);
    return ids;
}

/// "method=rk4,dt=0.02" as names and values. Throws UsageError.
Settings settings_of(std::string_view text) {
    Settings settings;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view one = text.substr(begin, end - begin);
        const std::size_t equals = one.find('=');
        if (equals == std::string_view::npos || equals == 0)
            throw UsageError(
                fmt::format("'{}' is not of the form name=value, such as dt=0.02", shown(std::string(one))));
        settings.emplace_back(one.substr(0, equals), one.substr(equals + 1));
        begin = end + 1;
    }
    return settings;
}

void check_setting(const std::string& name, const std::string& text, std::string_view method_id) {
    if (name == "method") return;
    if (name == "precision" && parse_precision(text)) return;
    if (name == "precision")
        throw UsageError(unknown_word("precision", text, std::vector<std::string_view>{"float", "double"}));
    const std::span<const ParameterInfo> infos = method(method_id).info.parameters;
    const auto info = std::find_if(infos.begin(), infos.end(), [&](const auto& known) { return known.name == name; });
    if (name != "dt" && info == infos.end()) {
        std::vector<std::string_view> known{"method", "dt", "precision"};
        for (const ParameterInfo& parameter : infos) known.push_back(parameter.name);
        throw UsageError(unknown_word("setting", name, known));
    }
    parse_value(name == "dt" ? dt_parameter : *info, text);
}

/// A run to be compared with the first: a method, dt, precision or parameters of the method.
void check_compared(const std::string& text, const std::string& first_method) {
    const Settings settings = settings_of(text);
    const auto named =
        std::find_if(settings.begin(), settings.end(), [](const auto& setting) { return setting.first == "method"; });
    const std::string& id = named == settings.end() ? first_method : named->second;
    const std::vector<std::string_view> known = method_ids();
    if (std::find(known.begin(), known.end(), id) == known.end()) throw UsageError(unknown_word("method", id, known));
    for (const auto& [name, value] : settings) check_setting(name, value, id);
}

/// The list, or one text, each with its place.
void check_compared(const toml::node& node, const std::string& first_method) {
    const toml::array* const list = node.as_array();
    const auto check = [&](const toml::node& one) {
        try {
            check_compared(text_of(one), first_method);
        } catch (const UsageError& error) {
            fail_at(one, error.what());
        }
    };
    if (!list) return check(node);
    for (const toml::node& one : *list) check(one);
}

}  // namespace

void read_run(const toml::node& node, SceneNumbers& numbers, SceneDefaults& defaults) {
    const toml::node *compared = nullptr, *parameters = nullptr;  // of the method, which may be named after them
    read_keys(table_of(node, "[run]"), "[run]",
              {{"method", [&](const toml::node& given) { defaults.method = word_of(given, "method", method_ids()); }},
               {"dt", [&](const toml::node& given) { defaults.dt = numbers.positive(given, Use::start).value; }},
               {"precision",
                [&](const toml::node& given) {
                    defaults.precision = word_of(given, "precision", {"float", "double"});
                }},
               {"until", [&](const toml::node& given) { defaults.until = numbers.positive(given, Use::start).value; }},
               {"compare",
                [&](const toml::node& given) {
                    defaults.compare = texts_of(given);
                    compared = &given;
                }},
               {"parameters", [&](const toml::node& given) { parameters = &given; }}});
    if (parameters) read_method_parameters(*parameters, defaults);
    if (compared) check_compared(*compared, defaults.method.empty() ? "rk4" : defaults.method);
}

SceneStart scene_start(const toml::node& node, SceneNumbers& numbers, ParticleFiles& files) {
    SceneStart start;
    const toml::table& table = table_of(node, "[start]");
    const auto from = [&](const toml::node& given) {
        start.file = text_of(given);
        try {
            start.change.from = files.start(start.file);
        } catch (const FileError& error) {
            fail_at(given, error.what());
        }
    };
    read_keys(table, "[start]",
              {{"mode", [&](const toml::node& given) { start.mode = numbers.count(given, 1); }},
               {"amplitude", [&](const toml::node& given) { start.amplitude = numbers.quantity(given, Use::start); }},
               {"reverse", [&](const toml::node& given) { start.change.reverse = flag_of(given); }},
               {"from", from}});
    if (table.contains("mode") != table.contains("amplitude"))
        fail_at(node, "mode and amplitude belong together: the number of the mode and its largest displacement");
    return start;
}

void check_start(const toml::table& root, const SceneStart& start, std::size_t particles) {
    const auto place = [&](const char* key) -> const toml::node& { return *root["start"][key].node(); };
    if (start.change.from && start.change.from->positions.size() != particles)
        fail_at(place("from"),
                fmt::format("it holds {} particles, the scene has {}", start.change.from->positions.size(), particles));
    if (start.mode > 0 && particles > most_in_modes)
        fail_at(place("mode"), fmt::format("normal modes are computed of at most {} particles, the scene has {}",
                                           most_in_modes, particles));
}

}  // namespace steplab
