#include "ui/plot/pair_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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
    now.in_legend = name.empty();  // of several forces they are told by their colour
    if (!now.x.empty()) plot.curves.push_back(std::move(now));
}

/// What there is to see of a curve: its well as far up as down; of one without a well what lies beyond the nearest
/// tenth, where it may be without bound.
Range seen_of(const Curve& curve) {
    const auto lowest = std::min_element(curve.y.begin(), curve.y.end());
    if (lowest != curve.y.begin() && *lowest < 0) return {1.15 * *lowest, -1.15 * *lowest};
    const auto from = curve.y.begin() + static_cast<std::ptrdiff_t>(curve.y.size() / 10);
    const auto [low, high] = std::minmax_element(from, curve.y.end());
    const double margin = 0.15 * std::max(std::abs(*low), std::abs(*high));
    return {std::min(0.0, *low) - margin, std::max(0.0, *high) + margin};
}

/// Of all curves of potentials and forces; none where they are all 0.
std::optional<Range> range_of(const Plot& plot) {
    Range all{0, 0};
    for (const Curve& curve : plot.curves) {
        if (curve.line == plot::Line::none) continue;
        const Range seen = seen_of(curve);
        all = {std::min(all.low, seen.low), std::max(all.high, seen.high)};
    }
    return all.low < all.high && std::isfinite(all.high - all.low) ? std::optional(all) : std::nullopt;
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
