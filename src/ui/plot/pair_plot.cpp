#include "ui/plot/pair_plot.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

Curve curve_of(const PairLaw& law, std::string name, const std::function<double(double)>& value) {
    constexpr int points = 400;
    Curve curve{.name = std::move(name), .marks = plot::Marks::never};
    for (int i = 0; i <= points; ++i) {
        const double r = law.closest + (law.farthest - law.closest) * i / points;
        curve.add(r, value(r));
    }
    return curve;
}

/// Dots on the curve of the potential.
Curve pairs_now(const PairLaw& law, std::string name, const Frame& frame) {
    constexpr std::size_t most = 400;
    Curve curve{.name = std::move(name), .line = plot::Line::none, .marks = plot::Marks::always};
    for (const double r : distances_now(law, frame, most)) {
        if (r >= law.closest && r <= law.farthest) curve.add(r, law.energy(r));
    }
    return curve;
}

void add_law(Plot& plot, const PairLaw& law, std::size_t number, const std::string& name, const Frame& frame) {
    Curve energy = curve_of(law, name + "V", law.energy), force = curve_of(law, name + "F", law.force);
    energy.colour = 2 * number;
    force.colour = 2 * number + 1;
    force.line = plot::Line::dashed;
    plot.curves.push_back(std::move(energy));
    plot.curves.push_back(std::move(force));
    Curve now = pairs_now(law, name + "pairs now", frame);
    now.colour = 2 * number;
    if (!now.x.empty()) plot.curves.push_back(std::move(now));
}

/// Around what lies below 0; a steep wall would leave no room for it.
std::optional<Range> range_of(const Plot& plot) {
    double lowest = 0;
    for (const Curve& curve : plot.curves) lowest = std::min(lowest, *std::min_element(curve.y.begin(), curve.y.end()));
    if (lowest == 0 || !std::isfinite(lowest)) return std::nullopt;
    return Range{1.15 * lowest, -1.15 * lowest};
}

}  // namespace

void pair_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "distance of two particles", .unit = "m"};
    plot.y = {.name = "potential V [J], force F [N]"};
    plot.empty = "the scene has no pair forces";
    const std::vector<PairLaw>& laws = context.state.plots.laws.pairs(context.view.description);
    for (std::size_t number = 0; number < laws.size(); ++number)
        add_law(plot, laws[number], number, laws.size() > 1 ? laws[number].name + ": " : "", context.view.frame);
    if (laws.size() == 1) plot.caption = laws.front().name + ", " + plot.caption;
    plot.y.range = range_of(plot);
}

}  // namespace steplab::ui
