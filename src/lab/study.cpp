#include "lab/study.hpp"

#include "lab/commit.hpp"
#include "sim/catalogue.hpp"
#include "sim/simulation.hpp"

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
};

constexpr DefaultScene default_scenes[] = {{"free", 10}, {"oscillator", 62}, {"chain", 68.1},
                                           {"mesh", 20}, {"rope", 5},        {"morse", 2}};

/// The run of this method in double whose cost comes nearest; null if there is none.
const Measurement* at_cost(const Study& study, const std::string& method, double evaluations) {
    const auto away = [&](const Measurement& run) {
        return std::abs(std::log(static_cast<double>(run.evaluations) / evaluations));
    };
    const Measurement* nearest = nullptr;
    for (const Measurement& run : study.runs) {
        if (run.run.method != method || run.run.precision != Precision::double_ || run.diverged) continue;
        if (!nearest || away(run) < away(*nearest)) nearest = &run;
    }
    return nearest;
}

Curve energy_curve(const Measurement& run, int colour) {
    constexpr std::uint64_t moments = 300;
    Curve curve{.name = run.run.method, .points = {}, .colour = colour, .marks = false};
    Simulation simulation(run.run);
    const std::uint64_t points = std::min(moments, run.steps);
    for (std::uint64_t i = 1; i <= points; ++i) {
        simulation.advance(run.steps * i / points - simulation.step());
        curve.points.emplace_back(simulation.time(), std::abs(simulation.diagnostics().energy_error));
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
    for (const auto& [id, time] : default_scenes) {
        StudyPlan plan{
            .scene = describe(id, "rk4"), .time = time, .methods = {}, .method_settings = {}, .precisions = {}};
        if (plan.scene.model == "morse") plan.scene.scene.set("spacing", 0.3);
        for (const Method& method : methods()) {
            if (!method.info.curiosity) plan.methods.emplace_back(method.info.id);
        }
        plan.precisions = {Precision::double_, Precision::float_};
        plan.most_seconds_a_run = quick ? 0.01 : 0.5;
        plan.ratio = quick ? 2 : 1.4142135623730951;
        plan.rounds = quick ? 3 : 7;
        plans.push_back(std::move(plan));
    }
    return plans;
}

std::vector<Curve> energy_curves(const Study& study, double evaluations) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < study.plan.methods.size(); ++i) {
        const std::string& id = study.plan.methods[i];
        const Measurement* run = method(id).info.adaptive ? nullptr : at_cost(study, id, evaluations);
        if (run) curves.push_back(energy_curve(*run, static_cast<int>(i)));
    }
    return curves;
}

Circumstances circumstances() {
    return {STEPLAB_VERSION, STEPLAB_COMMIT, STEPLAB_COMPILER, processor_name(),
            fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))};
}

}  // namespace steplab
