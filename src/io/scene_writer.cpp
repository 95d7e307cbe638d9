#include "io/scene_writer.hpp"

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/listed_blocks.hpp"
#include "io/particle_files.hpp"
#include "io/scene_toml.hpp"
#include "io/starting_values_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace steplab {

namespace {

std::string list_of(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_string(text);
    return "[" + list + "]";
}

/// Writes blocks and notes the names of parameters in them.
class Writer {
public:
    std::string text;
    std::set<std::string, std::less<>> names;

    std::string number(const WrittenNumber& quantity) {
        if (quantity.text.empty()) return number_text(quantity.value);
        note_names(quantity.text);
        return toml_string(quantity.text);
    }
    void note_names(const std::string& expression_text) {
        const Expression expression(expression_text);
        for (const std::string& name : expression.names()) names.insert(name);
    }
    /// The expressions among the parameters that anything uses, last those that others use.
    std::string followers(const Scene& scene) {
        std::string lines;
        for (std::set<std::string> written; true;) {
            const auto next = std::find_if(scene.followers.begin(), scene.followers.end(), [&](const auto& follower) {
                return names.contains(follower.first) && !written.contains(follower.first);
            });
            if (next == scene.followers.end()) return lines;
            written.insert(next->first);
            note_names(next->second);
            lines += fmt::format("{} = {}\n", next->first, toml_string(next->second));
        }
    }
    std::string vector(const WrittenVector& v) {
        return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z));
    }

    void begin(std::string_view name) { text += fmt::format("\n{}\n", name); }
    void line(std::string_view key, const std::string& value) { text += fmt::format("{} = {}\n", key, value); }
    void line(std::string_view key, const WrittenNumber& quantity) { line(key, number(quantity)); }
    void line(std::string_view key, const WrittenVector& v) { line(key, vector(v)); }
    void flag(std::string_view key, bool value) { line(key, std::string(value ? "true" : "false")); }
    template <class Value>
    void unless(const Value& usual, std::string_view key, const Value& value) {
        if (!(value == usual)) line(key, value);
    }

    void operator()(const ParticleBlock& block);
    void operator()(const Fix& fix);
    void operator()(const SpringTerm& term);
    void operator()(const PairTerm& term);
    void operator()(const FieldTerm& field);
    void operator()(const SceneStart& start);

private:
    template <class Term>
    void potential(const Term& term) {
        line("potential", toml_string(term.potential));
        for (const auto& [name, value] : term.values) line(name, value);
        for (const auto& [name, value] : term.parameters) names.insert(name);
    }
    void arrangement(const std::monostate&) {}
    void arrangement(const LineArrangement& given) {
        line("line", fmt::format("{{ count = {}, step = {} }}", given.count, vector(given.step)));
    }
    void arrangement(const GridArrangement& given) {
        line("grid", fmt::format("{{ count = [{}, {}], steps = [{}, {}] }}", given.columns, given.rows,
                                 vector(given.steps[0]), vector(given.steps[1])));
    }
    void arrangement(const CrystalArrangement& given) {
        constexpr std::array kinds{"cubic", "bcc", "fcc"};
        line("lattice", fmt::format("{{ kind = \"{}\", cells = [{}, {}, {}], constant = {} }}",
                                    kinds[static_cast<std::size_t>(given.kind)], given.cells[0], given.cells[1],
                                    given.cells[2], number(given.constant)));
    }
    void arrangement(const ListedParticles& given) { line("file", toml_string(ParticleFiles::name_below(given.file))); }
};

void Writer::operator()(const ParticleBlock& block) {
    begin("[[particles]]");
    if (!block.group.empty()) line("group", toml_string(block.group));
    unless({}, "position", block.position);
    unless({}, "velocity", block.velocity);
    const auto* const list = std::get_if<ListedParticles>(&block.arrangement);
    if (list && !list->masses) line("mass", block.mass);
    if (!list) unless(WrittenNumber(1), "mass", block.mass);
    if (list && !list->roles) flag("fixed", block.fixed);
    unless(WrittenNumber(0), "charge", block.charge);
    if (block.fixed && !list) flag("fixed", true);
    if (block.role != Role::moving) line("role", toml_string(id(block.role)));
    std::visit([this](const auto& given) { arrangement(given); }, block.arrangement);
    if (const auto* vector = std::get_if<WrittenVector>(&block.displacement)) line("displacement", *vector);
    if (const auto* random = std::get_if<RandomDisplacement>(&block.displacement))
        line("displacement", fmt::format("{{ random = {}, seed = {} }}", number(random->width), random->seed));
    if (block.temperature)
        line("temperature", fmt::format("{{ kT = {}, seed = {}, exact = {} }}", number(block.temperature->kT),
                                        block.temperature->seed, block.temperature->exact));
}

void Writer::operator()(const Fix& fix) {
    begin("[[fix]]");
    line("particles", list_of(fix.particles));
    if (fix.fixed) flag("fixed", *fix.fixed);
    if (fix.velocity) line("velocity", *fix.velocity);
    if (fix.displacement) line("displacement", *fix.displacement);
    if (fix.mass) line("mass", *fix.mass);
    if (fix.charge) line("charge", *fix.charge);
    if (fix.role) line("role", toml_string(id(*fix.role)));
}

void Writer::operator()(const SpringTerm& term) {
    constexpr std::array directions{"axes", "diagonals", "both"};
    begin("[[springs]]");
    if (!term.between.empty()) line("between", toml_string(term.between));
    if (term.along != SpringTerm::Along::axes)
        line("along", toml_string(directions[static_cast<std::size_t>(term.along)]));
    if (!term.pairs.empty()) {
        std::string pairs;
        for (const auto& [one, other] : term.pairs) pairs += (pairs.empty() ? "" : ", ") + list_of({one, other});
        line("pairs", "[" + pairs + "]");
    }
    unless(WrittenNumber(0), "damping", term.damping);
    if (term.potential) return potential(*term.potential);
    line("k", term.k);
    if (term.length) line("length", *term.length);
    unless(WrittenNumber(0), "quadratic", term.quadratic);
    unless(WrittenNumber(0), "cubic", term.cubic);
}

void Writer::operator()(const PairTerm& term) {
    begin("[[pairs]]");
    if (!term.between.empty()) line("between", list_of(term.between));
    potential(term);
    if (term.cutoff) line("cutoff", *term.cutoff);
}

void Writer::operator()(const FieldTerm& field) {
    begin("[[fields]]");
    if (!field.particles.empty()) line("particles", list_of(field.particles));
    if (field.gravity) line("gravity", *field.gravity);
    if (field.drag) line("drag", *field.drag);
    if (!field.potential.empty()) potential(field);
}

void Writer::operator()(const SceneStart& start) {
    if (start == SceneStart()) return;
    begin("[start]");
    if (!start.file.empty()) line("from", toml_string(start.file));
    if (start.mode > 0) line("mode", fmt::format("{}", start.mode));
    if (start.mode > 0) line("amplitude", start.amplitude);
    if (start.change.reverse) flag("reverse", true);
}

std::string parameters_text(const RunDescription& run, const Scene& scene, Writer& writer) {
    const std::string followers = writer.followers(scene);
    std::string text;
    for (const ParameterInfo& info : run.scene.infos()) {
        if (!writer.names.contains(info.name)) continue;
        text +=
            fmt::format("{} = {{ value = {}, range = [{}, {}]{}, what = {}{} }}\n", info.name,
                        number_text(run.scene[info.name]), number_text(info.slider_low), number_text(info.slider_high),
                        info.unit.empty() ? "" : fmt::format(", unit = {}", toml_string(info.unit)),
                        toml_string(info.what), info.slider_logarithmic ? ", logarithmic = true" : "");
    }
    text += followers;
    return text.empty() ? text : "\n[parameters]\n" + text;
}

/// Method parameters that are not at their defaults: { tolerance = 1e-9 }.
std::string method_parameters_text(const ParameterValues& values) {
    std::string text;
    for (const ParameterInfo& info : values.infos()) {
        if (values[info.name] == info.default_value) continue;
        const std::string value = format_value(info, values[info.name]);
        const bool is_word = info.kind == ParameterInfo::Kind::choice;
        text += fmt::format("{} {} = {}", text.empty() ? "" : ",", info.name, is_word ? toml_string(value) : value);
    }
    return text.empty() ? text : "{" + text + " }";
}

void write_run(Writer& writer, const RunDescription& run, const SceneDefaults& defaults) {
    writer.begin("[run]");
    writer.line("method", toml_string(run.method));
    const std::string parameters = method_parameters_text(run.method_parameters);
    if (!parameters.empty()) writer.line("parameters", parameters);
    writer.line("dt", number_text(run.dt));
    writer.line("precision", toml_string(id(run.precision)));
    if (defaults.until && *defaults.until / run.dt > 0) writer.line("until", number_text(*defaults.until));
    if (!defaults.compare.empty()) writer.line("compare", list_of(defaults.compare));
}

void write_view(Writer& writer, const SceneView& view) {
    if (view.camera.empty() && view.colour.empty() && view.background.empty()) return;
    writer.begin("[view]");
    if (!view.camera.empty()) writer.line("camera", toml_string(view.camera));
    if (!view.colour.empty()) writer.line("colour", toml_string(view.colour));
    if (!view.background.empty()) writer.line("background", toml_string(view.background));
}

/// The start of the scene as the run changes it: values of a file take the place of all before.
SceneStart start_of(const RunDescription& run, SceneStart start, const std::string& file) {
    if (run.start.from) start = {.file = file};
    if (!start.file.empty() && !file.empty()) start.file = file;
    start.change.reverse = start.change.reverse != run.start.reverse;
    return start;
}

std::string head(const RunDescription& run) {
    const Model& model = model_of(run);
    const std::string topic = model.topic.empty() ? "" : fmt::format("topic = {}\n", toml_string(model.topic));
    return fmt::format("steplab = 1\ntitle = {}\nteaches = {}\n{}", toml_string(model.info.name),
                       toml_string(model.info.what), topic);
}

/// Of a scene, with what the run and its scene file say besides.
std::string text_of(const RunDescription& run, const Scene& scene, const SceneView& view,
                    const std::string& start_file) {
    Writer writer;
    for (const ParticleBlock& block : scene.particles) writer(block);
    for (const Fix& fix : scene.fixes) writer(fix);
    for (const SpringTerm& term : scene.springs) writer(term);
    for (const PairTerm& term : scene.pairs) writer(term);
    for (const FieldTerm& field : scene.fields) writer(field);
    if (scene.box.value() != Vec3{}) {
        writer.begin("[box]");
        writer.line("size", scene.box);
        if (scene.corner) writer.line("corner", *scene.corner);
    }
    write_run(writer, run, run.origin ? run.origin->defaults : SceneDefaults{});
    writer(start_of(run, scene.start, start_file));
    write_view(writer, view);
    return head(run) + parameters_text(run, scene, writer) + writer.text;
}

}  // namespace

SceneView view_of(const RunDescription& run) {
    if (!run.origin) return {};
    const SceneDefaults& defaults = run.origin->defaults;
    return {defaults.camera, defaults.colour, defaults.background};
}

std::string scene_file_text(const RunDescription& run) { return scene_file_text(run, view_of(run)); }

std::string scene_file_text(const RunDescription& run, const SceneView& view, const std::string& start_file) {
    return text_of(run, model_of(run).scene(run.scene), view, start_file);
}

std::string whole_scene_text(const RunDescription& run) {
    if (run.start.from)
        throw UsageError(fmt::format("the scene was given another start ({}): its text alone cannot hold it",
                                     shown(run.start.from->given)));
    return text_of(run, without_files(model_of(run).scene(run.scene)), view_of(run), {});
}

}  // namespace steplab
