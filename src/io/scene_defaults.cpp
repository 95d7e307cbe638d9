#include "io/scene_defaults.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/scene_appearance.hpp"
#include "io/scene_blocks.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/method_refusals.hpp"
#include "sim/run/run_variant.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

using Use = SceneNumbers::Use;

std::vector<std::string_view> method_ids() {
    std::vector<std::string_view> ids;
    ids.reserve(methods().size());
    for (const Method& method : methods()) ids.push_back(method.info.id);
    return ids;
}

/// A time step or an end time; negative: backward in time. It has one value, whatever the parameters are set to.
double not_zero(const toml::node& node, SceneNumbers& numbers) {
    if (node.is_string() && !expression_of(node).names().empty())
        fail_at(node, "must be a number: dt and until follow no parameters; each run may have others");
    const double value = numbers.quantity(node, Use::start).value;
    if (value == 0) fail_at(node, "must not be 0");
    return value;
}

/// A method that chooses its own steps takes none backward.
void check_direction(const SceneDefaults& defaults, const toml::node& dt) {
    RunDescription run = with_method({}, defaults.method.empty() ? Opening{}.method : defaults.method);
    for (const auto& [name, text] : defaults.method_parameters) run.method_parameters.set_text(name, text);
    run.dt = *defaults.dt;
    if (const auto refused = backward_refusal(run)) fail_at(dt, *refused);
}

/// The list, or one text, each with its place: runs to be compared with the first, of another method, dt, precision or
/// parameters of the method or of the scene.
void check_compared(const toml::node& node, const std::string& first_method, const ParameterValues& scene) {
    constexpr std::size_t most = 3;
    const toml::array* const list = node.as_array();
    RunDescription first = with_method({}, first_method);
    first.scene = scene;
    const auto check = [&](const toml::node& one) {
        try {
            variant_of(first, text_of(one));
        } catch (const UsageError& error) {
            fail_at(one, error.what());
        }
    };
    if (!list) return check(node);
    if (list->size() > most)
        fail_at(node, fmt::format("at most {} runs are compared with the first: these are {}", most, list->size()));
    for (const toml::node& one : *list) check(one);
}

}  // namespace

void read_run(const toml::node& node, SceneNumbers& numbers, SceneDefaults& defaults) {
    const toml::node *compared = nullptr, *until = nullptr, *step = nullptr;
    const toml::node* parameters = nullptr;  // of the method, which may be named after them
    read_all_keys(
        table_of(node, "[run]"), "[run]",
        {{"method", [&](const toml::node& given) { defaults.method = word_of(given, "method", method_ids()); }},
         {"dt",
          [&](const toml::node& given) {
              defaults.dt = not_zero(given, numbers);
              step = &given;
          }},
         {"precision",
          [&](const toml::node& given) {
              defaults.precision = word_of(given, "precision", {"float", "double"});
          }},
         {"until",
          [&](const toml::node& given) {
              defaults.until = not_zero(given, numbers);
              until = &given;
          }},
         {"compare",
          [&](const toml::node& given) {
              defaults.compare = texts_of(given);
              compared = &given;
          }},
         {"parameters", [&](const toml::node& given) { parameters = &given; }}});
    const double dt = defaults.dt.value_or(Opening{}.dt);
    if (until && *defaults.until / dt < 0)
        fail_at(*until,
                fmt::format("until = {} and dt = {} differ in sign: a negative dt goes with a negative end time",
                            exact_text(*defaults.until), exact_text(dt)));
    if (parameters) read_method_parameters(*parameters, defaults);
    if (step) check_direction(defaults, *step);
    if (compared) check_compared(*compared, defaults.method.empty() ? "rk4" : defaults.method, numbers.values());
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
    read_all_keys(
        table, "[start]",
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
