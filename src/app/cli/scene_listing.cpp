#include "app/cli/scene_listing.hpp"

#include "app/cli/parameters_json.hpp"
#include "app/cli/text_table.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/json_text.hpp"
#include "models/scene/scene_particles.hpp"
#include "models/scene/spring_list.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/segment.hpp"
#include "sim/run/starting.hpp"
#include "sim/steppers/bands.hpp"
#include "sim/steppers/reordered.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <variant>

namespace steplab {

namespace {

struct Layout {
    std::string_view id, what;
};
struct NameOfLayout {
    Layout operator()(const ConstantForces&) const { return {"constant", "a constant acceleration of each particle"}; }
    Layout operator()(const LineForces&) const { return {"line", "a line of equal springs"}; }
    Layout operator()(const GridForces&) const { return {"grid", "a grid of equal springs with a fixed border"}; }
    Layout operator()(const PairForces&) const { return {"pairs", "one Morse potential between all particles"}; }
    Layout operator()(const NearPairForces&) const {
        return {"near-pairs", "one Morse potential between all particles within a cut-off"};
    }
    Layout operator()(const ComposedForces&) const { return {"composed", "no scene that has a layout of its own"}; }
};

void add_plan(SceneListing& listing) {
    const RunDescription held = as_held(listing.run);
    const Plan plan = plan_of(held);
    const Method& how = method(held.method);
    const Layout layout = std::visit(NameOfLayout(), plan.forces);
    const StepperSetup setup = segment_start(held, plan, instructions_for(how, plan, {}));
    listing.layout = layout.id;
    listing.recognised = layout.what;
    listing.instructions = id(setup.instructions);
    listing.threads = threads_for(how, setup, {});
    listing.reordered = !order_by_place(plan).empty();
    listing.drag = plan.drag;
}

SceneListing::PairForce pair_force(const PairTerm& term, const SceneParticles& particles) {
    std::vector<IndexRange> sets;
    for (const std::string& name : term.between) sets.push_back(particles.named(name));
    if (sets.empty()) sets.push_back({0, particles.count()});
    const bool within = sets.size() == 1 || sets[0] == sets[1];
    const double first = static_cast<double>(sets.front().count), second = static_cast<double>(sets.back().count);
    SceneListing::PairForce force{term.potential, within ? first * (first - 1) / 2 : first * second};
    if (term.cutoff) force.cutoff = term.cutoff->value;
    return force;
}

void add_contents(SceneListing& listing) {
    const Scene scene = model_of(listing.run).scene(listing.run.scene);
    const SceneParticles particles(scene);
    listing.particles = particles.count();
    listing.lightest = listing.heaviest = particles[0].mass;
    for (std::size_t i = 0; i < particles.count(); ++i) {
        const SceneParticle particle = particles[i];
        listing.fixed += particle.fixed ? 1 : 0;
        listing.lightest = std::min(listing.lightest, particle.mass);
        listing.heaviest = std::max(listing.heaviest, particle.mass);
    }
    for (const SpringTerm& term : scene.springs) {
        const std::size_t before = listing.springs;
        each_spring(particles, term, [&](const ScenePair&) { ++listing.springs; });
        if (term.potential)
            listing.pair_forces.push_back({.potential = term.potential->potential,
                                           .pairs = static_cast<double>(listing.springs - before),
                                           .along_springs = true});
    }
    for (const PairTerm& term : scene.pairs) listing.pair_forces.push_back(pair_force(term, particles));
    listing.fields = scene.fields.size();
    listing.box = scene.box.value();
}

std::string mass_text(const SceneListing& scene) {
    const std::string least = short_number(scene.lightest);
    return (scene.lightest == scene.heaviest ? least : least + " to " + short_number(scene.heaviest)) + " kg";
}

std::string parameter_text(const SceneListing& scene) {
    std::string text;
    for (const ParameterInfo& info : scene.run.scene.infos())
        text +=
            fmt::format("{}{}={}", text.empty() ? "" : " ", info.name, format_value(info, scene.run.scene[info.name]));
    return text.empty() ? "none" : text;
}

std::string pairs_text(const SceneListing::PairForce& force) {
    const std::string pairs = exact_text(force.pairs);
    if (force.along_springs) return fmt::format("along {} spring{}", pairs, force.pairs == 1 ? "" : "s");
    return fmt::format("between {} pair{}", pairs, force.pairs == 1 ? "" : "s");
}

}  // namespace

SceneListing scene_listing(const RunDescription& run) {
    SceneListing listing{.run = run, .layout = {}, .recognised = {}, .instructions = {}};
    add_plan(listing);
    add_contents(listing);
    return listing;
}

std::string scene_text(const SceneListing& scene) {
    const RunDescription& run = scene.run;
    const ModelInfo& info = model_of(run).info;
    std::vector<Row> rows{{"recognised", std::string(scene.recognised)},
                          {"layout", fmt::format("{}, {} thread{}, {}", scene.layout, scene.threads,
                                                 scene.threads == 1 ? "" : "s", scene.instructions)},
                          {"run", fmt::format("{}, {}, dt {}", run.method, id(run.precision), exact_text(run.dt))},
                          {"particles", fmt::format("{}, {} of them fixed", scene.particles, scene.fixed)},
                          {"mass", mass_text(scene)},
                          {"springs", fmt::format("{}", scene.springs)}};
    if (scene.reordered)
        rows.insert(rows.begin() + 2, {"order", "along a Z-order curve; files and tables keep the order of the scene"});
    for (const SceneListing::PairForce& force : scene.pair_forces)
        rows.push_back({"pair force", fmt::format("{} {}{}", force.potential, pairs_text(force),
                                                  force.cutoff ? ", cut-off " + exact_text(*force.cutoff) : "")});
    if (scene.fields > 0) rows.push_back({"fields", fmt::format("{}", scene.fields)});
    if (scene.drag > 0) rows.push_back({"drag", fmt::format("c / m = {} 1/s", short_number(scene.drag))});
    if (scene.box != Vec3{})
        rows.push_back({"box", fmt::format("{} x {} x {} m (0: not periodic)", exact_text(scene.box.x),
                                           exact_text(scene.box.y), exact_text(scene.box.z))});
    rows.push_back({"parameters", parameter_text(scene)});
    const std::string title = info.name.empty() ? shown(run.model) : std::string(info.name);
    return title + "\n" + (info.what.empty() ? "" : wrapped(info.what, 0) + "\n") + aligned(rows, 2);
}

std::string scene_json(const SceneListing& scene) {
    using Json = nlohmann::ordered_json;
    const RunDescription& run = scene.run;
    const ModelInfo& info = model_of(run).info;
    Json forces = Json::array();
    for (const SceneListing::PairForce& force : scene.pair_forces)
        forces.push_back({{"potential", force.potential},
                          {"pairs", force.pairs},
                          {"along_springs", force.along_springs},
                          {"cutoff", force.cutoff ? Json(*force.cutoff) : Json(nullptr)}});
    const Json json{{"id", run.model},
                    {"title", info.name},
                    {"teaches", info.what},
                    {"layout", scene.layout},
                    {"recognised", scene.recognised},
                    {"threads", scene.threads},
                    {"instructions", scene.instructions},
                    {"order", scene.reordered ? "z-order" : "scene"},
                    {"method", run.method},
                    {"precision", id(run.precision)},
                    {"dt", run.dt},
                    {"particles", scene.particles},
                    {"fixed", scene.fixed},
                    {"mass", {scene.lightest, scene.heaviest}},
                    {"springs", scene.springs},
                    {"pair_forces", forces},
                    {"fields", scene.fields},
                    {"drag", scene.drag},
                    {"box", {scene.box.x, scene.box.y, scene.box.z}},
                    {"parameters", parameters_json(run.scene.infos())}};
    return json_text(json);
}

}  // namespace steplab
