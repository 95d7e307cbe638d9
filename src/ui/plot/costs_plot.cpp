#include "ui/plot/costs_plot.hpp"

#include "core/number_text.hpp"
#include "session/run_name.hpp"
#include "ui/widgets/format.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

/// What a series of points belongs to.
using SeriesKey = std::tuple<std::string, Precision, bool>;
SeriesKey key_of(const RunDescription& run) { return {run.method, run.precision, chooses_its_steps(run)}; }

/// The colour of a series: that of the run of the session that it is of, if there is one.
std::size_t colour_of(const Context& context, const SeriesKey& key) {
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        if (key_of(context.run(run).description) == key) return context.run(run).swatch;
    }
    return Curve::quiet;
}

/// Those of the methods on the screen last, in front.
void add_series(Plot& plot, const Context& context, const CostsView& costs, Cost cost) {
    std::map<SeriesKey, Curve> series;
    for (const CostPoint& point : costs.points) {
        Curve& curve = series[key_of(point.run)];
        curve.add(point.*cost, point.error);
    }
    for (const bool in_front : {false, true}) {
        for (auto& [key, curve] : series) {
            const std::size_t colour = colour_of(context, key);
            if ((colour != Curve::quiet) != in_front) continue;
            curve.name = std::get<0>(key);
            curve.colour = colour;
            curve.line = std::get<1>(key) == Precision::float_ ? plot::Line::dotted : plot::Line::solid;
            curve.marks = plot::Marks::always;
            curve.ascending = false;
            curve.in_legend = false;
            plot.curves.push_back(std::move(curve));
        }
    }
}

/// The runs than which none has a smaller error for no more of the cost.
Curve front_of(const CostsView& costs, Cost cost) {
    std::vector<std::pair<double, double>> points;
    for (const CostPoint& point : costs.points) points.emplace_back(point.*cost, point.error);
    std::sort(points.begin(), points.end());
    Curve curve{.name = "nothing better", .colour = Curve::exact, .line = plot::Line::dashed};
    for (const auto& [spent, error] : points) {
        if (curve.y.empty() || error < curve.y.back()) curve.add(spent, error);
    }
    return curve;
}

/// The runs of the session, as large dots.
void add_runs(Plot& plot, const Context& context, const CostsView& costs, Cost cost) {
    for (std::size_t run = 0; run < costs.runs.size() && run <= context.session.followers.size(); ++run) {
        if (!costs.runs[run]) continue;
        plot.curves.push_back({.name = run_name(context.run(run).description, context.view.description),
                               .colour = context.run(run).swatch,
                               .large = true,
                               .ascending = false,
                               .x = {*costs.runs[run].*cost},
                               .y = {costs.runs[run]->error}});
    }
}

void work_precision_plot(Plot& plot, const Context& context, Cost cost) {
    plot.y = {.name = "error", .unit = "m"};
    plot.empty = "measuring";
    plot.nearest_alone = true;
    const auto& costs = context.session.costs;
    if (!costs) return;
    if (costs->points.empty() && costs->complete) plot.empty = costs->how;
    plot.y.name = fmt::format("error after {} s", setting_text(costs->time));
    if (costs->provisional)
        plot.y.name += ", first estimate";
    else if (!costs->complete)
        plot.y.name += fmt::format(", {:.0f} % of the series", 100 * costs->done);
    add_series(plot, context, *costs, cost);
    if (costs->points.size() > 1) plot.curves.push_back(front_of(*costs, cost));
    add_runs(plot, context, *costs, cost);
}

}  // namespace

void costs_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "force evaluations"};
    work_precision_plot(plot, context, cost_of(PlotKind::costs));
}

void times_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "computing time", .unit = "s"};
    work_precision_plot(plot, context, cost_of(PlotKind::times));
}

const CostPoint* cost_point_at(const Context& context, PlotKind kind, const plot::Layout& layout) {
    const auto& costs = context.session.costs;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    if (!costs || !layout.frame.contains(pointer.x, pointer.y)) return nullptr;
    const CostPoint* best = nullptr;
    float least = context.px(14);
    for (const CostPoint& point : costs->points) {
        const float distance = std::hypot(layout.axes.across.pixel(point.*cost_of(kind)) - pointer.x,
                                          layout.axes.up.pixel(point.error) - pointer.y);
        if (distance >= least) continue;
        least = distance;
        best = &point;
    }
    return best;
}

RunDescription run_of(const CostPoint& point, const Context& context) {
    RunDescription run = point.run;
    if (chooses_its_steps(run)) run.dt = context.view.dt;
    return run;
}

std::string text_of(const CostPoint& point, const Context& context) {
    return fmt::format("{}\nerror {}\n{} force evaluations, {} ms\nclick: add it as a run",
                       run_name(run_of(point, context), context.view.description),
                       with_unit(error_text(point.error), "m"), count_text(point.evaluations),
                       setting_text(1e3 * point.seconds, 2));
}

}  // namespace steplab::ui
