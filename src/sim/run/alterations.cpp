#include "sim/run/alterations.hpp"

#include "core/known.hpp"
#include "models/scene/planner.hpp"
#include "models/scene/scene_facts.hpp"
#include "sim/run/known_motion.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

struct Alterations::Content {
    SceneOrigin origin;  ///< keeps the model that was altered
    std::vector<Alteration> all;
    Model model;
};

namespace {

bool is_before(const Alteration& a, const Alteration& b) { return a.particle < b.particle; }

/// Ascending, one of each particle: what comes later goes before what came earlier.
std::vector<Alteration> merged(std::vector<Alteration> all) {
    std::erase_if(all, [](const Alteration& one) { return !one.fixed && !one.mass; });
    std::stable_sort(all.begin(), all.end(), is_before);
    std::vector<Alteration> result;
    for (const Alteration& one : all) {
        if (result.empty() || result.back().particle != one.particle) result.push_back({one.particle});
        if (one.fixed) result.back().fixed = one.fixed;
        if (one.mass) result.back().mass = one.mass;
    }
    return result;
}

/// Planned as any other scene; what takes long is kept.
Model altered_model(const Model& base, const std::vector<Alteration>& all) {
    Model model = base;
    model.scene = [base_scene = base.scene, all](const ParameterValues& values) {
        return altered(base_scene(values), all);
    };
    model.facts = [scene = model.scene,
                   known = std::make_shared<KnownOfRuns<SceneFacts>>()](const ParameterValues& values) {
        return known->of(values, [&] { return facts_of(scene(values)); });
    };
    model.plan = [scene = model.scene, known = std::make_shared<Known<Plan>>()](const ParameterValues& values) {
        return known->of(values, [&] {
            const Scene made = scene(values);
            return started(planned(made), shape_of(made), made.start);
        });
    };
    model.shape = [shape = base.shape, scene = model.scene](const ParameterValues& values) {
        return altered(shape(values), scene(values));
    };
    model.omega_max = [plan = model.plan, shape = model.shape,
                       known = std::make_shared<KnownOfRuns<std::optional<double>>>()](const ParameterValues& values) {
        return known->of(values, [&]() -> std::optional<double> {
            const auto frequency = known_frequency(plan(values), shape(values));
            return frequency ? std::optional(frequency->omega) : std::nullopt;
        });
    };
    model.exact = [plan = model.plan](const ParameterValues& values) { return known_motion(plan(values)); };
    model.resting = {};
    return model;
}

}  // namespace

Alterations::Alterations(const Model& base, const SceneOrigin& origin, std::vector<Alteration> all) {
    all = merged(std::move(all));
    if (all.empty()) return;
    Model model = altered_model(base, all);
    content_ = std::make_shared<const Content>(Content{origin, std::move(all), std::move(model)});
}

std::span<const Alteration> Alterations::all() const {
    return content_ ? std::span<const Alteration>(content_->all) : std::span<const Alteration>();
}

const Model& Alterations::model() const { return content_->model; }

std::vector<Alteration> Alterations::with(std::span<const Alteration> more) const {
    std::vector<Alteration> result(all().begin(), all().end());
    result.insert(result.end(), more.begin(), more.end());
    return result;
}

Alteration Alterations::of(std::size_t particle) const {
    const auto place = std::lower_bound(all().begin(), all().end(), Alteration{particle}, is_before);
    return place == all().end() || place->particle != particle ? Alteration{particle} : *place;
}

bool operator==(const Alterations& a, const Alterations& b) {
    return a.content_ == b.content_ || std::equal(a.all().begin(), a.all().end(), b.all().begin(), b.all().end());
}

}  // namespace steplab
