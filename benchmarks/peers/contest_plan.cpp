#include "contest_plan.hpp"

#include "core/error.hpp"
#include "io/scene_file.hpp"
#include "lab/study/study.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/fixed_particles.hpp"
#include "sim/run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace steplab::benchmark {

namespace {

StudyPlan with_these_runs(StudyPlan study, double most_seconds, double ratio) {
    study.precisions = {Precision::double_};
    study.most_seconds_a_run = most_seconds;
    study.ratio = ratio;
    study.rounds = 1;
    return study;
}

/// A scene of the report.
ContestPlan short_contest(std::string_view name) {
    const std::vector<StudyPlan> plans = default_plans(false);
    const auto found = std::find_if(plans.begin(), plans.end(), [&](const auto& p) { return p.scene.model == name; });
    if (found == plans.end()) throw UsageError("no contest " + std::string(name));
    return {.name = name, .study = with_these_runs(*found, 0.02, 1.1)};
}

/// A shipped scene over many periods.
ContestPlan long_contest(std::string_view name, const char* scene, double time, double length, double most_seconds) {
    StudyPlan study = default_plans(false).front();  // its methods
    study.scene = describe(find_scene(scene));
    study.time = time;
    return {.name = name,
            .study = with_these_runs(std::move(study), most_seconds, 1.25),
            .length = length,
            .targets = {1e-6, 1e-9},
            .tolerance_ratio = 0.4,
            .most_steps = 1000000,
            .patience = 5,
            .rounds = 7,
            .smallest = true};
}

constexpr double hundred_periods = 200 * std::numbers::pi;  // a = G M = 1
constexpr double jupiters_axis = 5.2;                       // the smallest orbit, on which errors are largest

std::vector<double> strengths_of(const Plan& scene) {
    const auto* const composed = std::get_if<ComposedForces>(&scene.forces);
    std::vector<double> strengths;
    if (!composed) return strengths;
    const Composition& terms = *composed->terms;
    for (const double mass : terms.masses) strengths.push_back(terms.pairs.at(0).values.at(0) * terms.mass * mass);
    return strengths;
}

Plan scene_of(const ContestPlan& plan) { return model_of(plan.study.scene).plan(plan.study.scene.scene); }

}  // namespace

ContestPlan contest_plan(std::string_view name) {
    if (name == "kepler") return long_contest(name, "kepler-ellipse", hundred_periods, 1, 0.3);
    if (name == "outer-solar-system") return long_contest(name, "outer-solar-system", 1e4, jupiters_axis, 1);
    return short_contest(name);
}

Problem problem_of(const ContestPlan& plan) {
    const Frame start = Simulation(plan.study.scene).frame();
    const Plan scene = scene_of(plan);
    Problem problem{.scene = plan.name,
                    .time = plan.study.time,
                    .positions = {},
                    .velocities = {},
                    .strengths = {},
                    .most_steps = plan.most_steps};
    if (plan.name != "kepler") {  // in the others what is fixed is part of the loops
        problem.positions = start.positions;
        problem.velocities = start.velocities;
        problem.strengths = strengths_of(scene);
        return problem;
    }
    for (std::size_t i = 0; i < start.positions.size(); ++i) {
        if (is_fixed(scene.forces, i)) continue;
        problem.positions.push_back(start.positions[i]);
        problem.velocities.push_back(start.velocities[i]);
    }
    return problem;
}

double error_of(const std::vector<Vec3>& end, const ContestPlan& plan, const Reference& reference) {
    const Plan scene = scene_of(plan);
    Field<double> displacement = reference.moments.back().state.displacement;
    const std::size_t others = displacement.count() - end.size();  // fixed, and first
    for (std::size_t i = 0; i < end.size(); ++i) displacement.set(others + i, end[i] - scene.reference.at(others + i));
    const double largest = error_against(reference.moments.back(), displacement) / plan.length;
    return std::isfinite(largest) ? largest : 1e300;
}

}  // namespace steplab::benchmark
