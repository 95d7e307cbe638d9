#include "lab/study/study.hpp"

#include "core/interruption.hpp"
#include "core/larger_magnitude.hpp"
#include "io/commit.hpp"
#include "lab/study/parallel.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/samples.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <utility>

namespace steplab {

namespace {

struct DefaultScene {
    const char* model;
    double time;
    double work;  ///< processor seconds of a full report, as measured once
};

constexpr DefaultScene default_scenes[] = {{"free", 10, 8},  {"oscillator", 62, 14}, {"chain", 68.1, 20},
                                           {"mesh", 20, 70}, {"rope", 5, 42},        {"morse", 2, 60}};

constexpr LeftOut left_out[] = {
    {"crystal", "methods lose their order at the kinks of its cut-off, which an error against dt cannot show fairly"}};

/// The run of this method in double whose cost is closest; null if there is none.
const Measurement* at_cost(const Study& study, const std::string& method, double evaluations) {
    const auto away = [&](const Measurement& run) {
        return std::abs(std::log(static_cast<double>(run.result.evaluations) / evaluations));
    };
    const Measurement* nearest = nullptr;
    for (const Measurement& run : study.runs) {
        if (run.run.method != method || run.run.precision != Precision::double_ || run.diverged()) continue;
        if (!nearest || away(run) < away(*nearest)) nearest = &run;
    }
    return nearest;
}

/// Number of samples of the energy, and of intervals whose largest error is plotted.
constexpr std::uint64_t moments = 600, spans = 60;

plot::Curve energy_curve(const Measurement& run, const Execution& execution) {
    plot::Curve curve{.name = run.run.method, .marks = plot::Marks::never};
    Simulation simulation(run.run, execution);
    Samples samples(run.steps, moments);
    const std::uint64_t samples_per_span = std::max<std::uint64_t>(1, samples.count() / spans);
    double largest = 0;
    while (samples.advance(simulation)) {
        check_interruption();
        largest = larger_magnitude(largest, simulation.energy_error());
        if (samples.number() % samples_per_span != 0) continue;
        curve.add(simulation.time(), largest);
        largest = 0;
    }
    return curve;
}

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

}  // namespace

std::vector<StudyPlan> default_plans(bool quick) {
    std::vector<StudyPlan> plans;
    for (const auto& [id, time, work] : default_scenes) {
        plans.push_back(plan_for(describe(id, "rk4"), time, quick));
        plans.back().reference_effort = 1;
        if (plans.back().scene.model == "morse") plans.back().scene.scene.set("spacing", 0.3);
    }
    return plans;
}

StudyPlan plan_for(const RunDescription& scene, double time, bool quick) {
    StudyPlan plan{.scene = scene, .time = time, .methods = {}, .method_settings = {}, .precisions = {}};
    for (const Method& method : methods()) {
        if (!method.info.curiosity) plan.methods.emplace_back(method.info.id);
    }
    plan.precisions = {Precision::double_, Precision::float_};
    plan.most_seconds_a_run = quick ? 0.01 : 0.5;
    plan.ratio = quick ? 2 : 1.4142135623730951;
    plan.reference_effort = quick ? 0.1 : 1;  // where a cut-off keeps references from converging it takes a minute
    plan.rounds = quick ? 3 : 7;
    plan.brief = quick;
    return plan;
}

double quick_time(const StudyPlan& plan) {
    // ω T of the fastest vibration, for each particle and each of its partners: what a step of any method has to do
    constexpr double most_work = 4e5;
    const Plan scene = steplab::plan_of(plan.scene);
    const double terms = static_cast<double>(scene.reference.count) + interacting_pairs(scene);
    return std::min(plan.time, most_work / (frequency(plan) * terms));
}

std::span<const LeftOut> left_out_of_plans() { return left_out; }

std::string left_out_text() {
    std::string text;
    for (const LeftOut& scene : left_out)
        text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", scene.model, scene.reason);
    return text;
}

double share_of_work(const StudyPlan& plan) {
    for (const DefaultScene& scene : default_scenes) {
        if (plan.scene.model == scene.model) return scene.work;
    }
    return 1;
}

std::vector<plot::Curve> energy_curves(const Study& study, double evaluations) {
    std::vector<const Measurement*> runs;
    for (const std::string& id : study.plan.methods) {
        const Measurement* const run = method(id).info.adaptive ? nullptr : at_cost(study, id, evaluations);
        if (run) runs.push_back(run);
    }
    std::vector<plot::Curve> curves(runs.size());
    parallel_for_each(runs.size(), most_bytes(study.plan), [&](std::size_t i, const Execution& execution) {
        curves[i] = energy_curve(*runs[i], execution);
    });
    return curves;
}

Circumstances circumstances() {
    return {STEPLAB_VERSION, STEPLAB_COMMIT, STEPLAB_COMPILER, processor_name(),
            fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))};
}

}  // namespace steplab
