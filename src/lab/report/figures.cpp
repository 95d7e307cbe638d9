#include "lab/report/figures.hpp"

#include "core/entry.hpp"
#include "lab/study/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

constexpr const char* baseline = "rk4";

enum class Against { time, evaluations };

std::vector<Measurement> of_precision(const Study& study, Precision precision) {
    std::vector<Measurement> runs;
    std::copy_if(study.runs.begin(), study.runs.end(), std::back_inserter(runs),
                 [&](const Measurement& run) { return run.run.precision == precision; });
    return runs;
}

plot::Curve error_curve(const Study& study, const std::string& method, Precision precision, Against against,
                        bool by_tolerance) {
    plot::Curve curve{.name = method, .ascending = false};
    for (const Measurement& run : study.runs) {
        if (run.run.method != method || run.run.precision != precision || run.diverged() || !run.wall_seconds ||
            chooses_its_steps(run.run) != by_tolerance)
            continue;
        const double cost = against == Against::time ? *run.wall_seconds : static_cast<double>(run.result.evaluations);
        curve.add(cost, run.error);
    }
    return curve;
}

std::size_t colour_of(const std::string& method, const std::vector<std::string>& coloured,
                      const MethodColours& colours) {
    const bool shown = std::find(coloured.begin(), coloured.end(), method) != coloured.end();
    return shown ? colours.at(method) : plot::Curve::quiet;
}

plot::Quantity cost_axis(Against against) {
    plot::Quantity axis{
        .name = "force evaluations", .scale = plot::Scale::logarithmic, .numbers = plot::Numbers::counts};
    if (against == Against::evaluations) return axis;
    axis.name = "wall time";
    axis.numbers = plot::Numbers::seconds;
    return axis;
}

plot::Plot work_precision(const Study& study, Precision precision, Against against, const MethodColours& colours) {
    plot::Plot figure{.x = cost_axis(against),
                      .y = {.name = "error at the end", .unit = "m", .scale = plot::Scale::logarithmic}};
    const std::vector<std::string> coloured = coloured_methods(study);
    for (const std::string& method : study.plan.methods) {
        for (const bool by_tolerance : {false, true}) {
            plot::Curve curve = error_curve(study, method, precision, against, by_tolerance);
            curve.colour = colour_of(method, coloured, colours);
            curve.line = plot::dashed_if(by_tolerance && takes_dt(method));
            if (curve.line == plot::Line::dashed) curve.name += " by tolerance";
            figure.curves.push_back(std::move(curve));
        }
    }
    return figure;
}

/// The figures of all precisions against one kind of cost have the same range of it.
void give_common_cost(std::vector<plot::Plot>& figures, std::size_t first, std::size_t second) {
    Range range{infinity, -infinity};
    for (const std::size_t i : {first, second}) {
        for (const plot::Curve& curve : figures[i].curves) {
            for (const double cost : curve.x) range = {std::min(range.low, cost), std::max(range.high, cost)};
        }
    }
    if (!(range.low <= range.high)) return;
    constexpr double beside = 1.5;  // room for dots at the ends
    for (const std::size_t i : {first, second}) figures[i].x.range = Range{range.low / beside, range.high * beside};
}

double median_cost(const Study& study) {
    std::vector<std::uint64_t> costs;
    for (const Measurement& run : study.runs) {
        if (!run.diverged()) costs.push_back(run.result.evaluations);
    }
    if (costs.empty()) return 1;
    std::nth_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2), costs.end());
    return static_cast<double>(costs[costs.size() / 2]);
}

plot::Plot energy_figure(const Study& study, const MethodColours& colours) {
    plot::Plot figure{.x = {.name = "simulated time", .unit = "s"},
                      .y = {.name = "energy error", .unit = "J", .scale = plot::Scale::logarithmic},
                      .curves = energy_curves(study, median_cost(study))};
    const std::vector<std::string> coloured = coloured_methods(study);
    for (plot::Curve& curve : figure.curves) curve.colour = colour_of(curve.name, coloured, colours);
    if (!figure.curves.empty()) figure.x.range = Range{0, study.plan.time};
    return figure;
}

}  // namespace

std::vector<std::string> coloured_methods(const Study& study) {
    std::vector<std::string> coloured;
    for (const Precision precision : study.plan.precisions) {
        const std::vector<Measurement> runs = of_precision(study, precision);
        for (int digits = 1; digits <= 15; ++digits) {
            if (const Measurement* best = fastest(runs, std::pow(10, -digits))) coloured.push_back(best->run.method);
        }
    }
    const auto& methods = study.plan.methods;
    if (std::find(methods.begin(), methods.end(), baseline) != methods.end()) coloured.emplace_back(baseline);
    std::sort(coloured.begin(), coloured.end());
    coloured.erase(std::unique(coloured.begin(), coloured.end()), coloured.end());
    return coloured;
}

MethodColours method_colours(const std::vector<Study>& studies) {
    MethodColours colours;
    for (const Study& study : studies) {
        for (const std::string& method : coloured_methods(study)) colours.emplace(method, 0);
    }
    std::size_t next = 0;
    for (auto& [method, colour] : colours) colour = method == baseline ? 0 : ++next;
    return colours;
}

StudyFigures study_figures(const Study& study, const MethodColours& colours) {
    StudyFigures all;
    for (const Precision precision : study.plan.precisions) {
        for (const Against against : {Against::time, Against::evaluations}) {
            all.figures.push_back(work_precision(study, precision, against, colours));
            all.captions.push_back(
                fmt::format("Error against {}, {}", against == Against::time ? "time" : "evaluations", id(precision)));
        }
    }
    const std::size_t precisions = study.plan.precisions.size();
    for (const std::size_t kind : {0u, 1u}) give_common_cost(all.figures, kind, 2 * (precisions - 1) + kind);
    all.figures.push_back(energy_figure(study, colours));
    all.captions.emplace_back("Energy error over time, double");
    return all;
}

}  // namespace steplab
