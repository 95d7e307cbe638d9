#pragma once

#include "plot/layout.hpp"
#include "ui/context.hpp"

#include <optional>

namespace steplab::ui {

/// The work-precision diagram of the scene: error against force evaluations of all methods, the runs of the session in
/// it, and the line of those that nothing is better than.
void costs_plot(plot::Plot& plot, const Context& context);
/// The same against the time that computing took.
void times_plot(plot::Plot& plot, const Context& context);

/// What a point of such a plot costs, along its axis across.
using Cost = double CostPoint::*;
constexpr Cost cost_of(PlotKind kind) {
    return kind == PlotKind::times ? &CostPoint::seconds : &CostPoint::evaluations;
}

/// The point of such a plot that the pointer is at, if one is near.
const CostPoint* cost_point_at(const Context& context, PlotKind kind, const plot::Layout& layout);

/// The run of a point as it goes beside the others: a method of own steps is looked at as often as the leading run.
RunDescription run_of(const CostPoint& point, const Context& context);

/// "dop853, tolerance 1e-9 s, double": the run of a point, with its cost.
std::string text_of(const CostPoint& point, const Context& context);

}  // namespace steplab::ui
