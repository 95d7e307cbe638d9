#include "ui/plot/particle_plots.hpp"

#include "plot/spectrum.hpp"
#include "ui/plot/run_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

constexpr std::string_view axis_names[] = {"x", "y", "z"};

bool begin_particle_plot(Plot& plot, const Context& context, std::string_view what) {
    plot.empty = "click a particle to plot what it does";
    if (!context.view.tracked) return false;
    const std::string_view axis = axis_names[context.state.history.direction()];
    plot.y.name = fmt::format("{} {} of particle {}", what, axis, context.view.tracked->particle);
    plot.empty = "no data yet";
    return true;
}

Curve exact_curve() { return {.name = "exact", .colour = Curve::exact, .line = plot::Line::dashed}; }

std::span<const ExactPoint> exact_points(const Context& context) {
    const auto& tracked = context.view.tracked;
    return context.state.plots.exact.of(context.view.series, tracked ? tracked->exact : std::nullopt,
                                        context.view.frame.positions.size());
}

/// The exact motion over time.
template <class Value>
void add_exact(Plot& plot, const Context& context, const Value& value) {
    Curve curve = exact_curve();
    for (const ExactPoint& point : exact_points(context)) curve.add(point.time, value(point));
    if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
}

/// Between the lowest and the highest run of the ensemble; `origin`: where their displacements are counted from.
void add_ensemble(Plot& plot, const Context& context, double origin) {
    const int axis = context.state.history.direction();
    plot::Band band{.name = "ensemble"};
    for (const SpreadSample& sample : context.view.spread.samples) {
        if (!sample.reach) continue;
        band.x.push_back(sample.time);
        band.low.push_back(origin + component(sample.reach->low, axis));
        band.high.push_back(origin + component(sample.reach->high, axis));
    }
    if (!band.x.empty()) plot.bands.push_back(std::move(band));
}

/// The newest values of a particle at equal distances in time.
struct Signal {
    std::vector<double> values;
    double interval = 0;
};

Signal signal_of(const SampleSeries& series, int axis) {
    constexpr std::size_t most = 4096;
    Signal signal;
    const auto& samples = series.samples;
    for (std::size_t i = samples.size(); i-- > 0 && signal.values.size() < most;) {
        if (!samples[i].particle) break;
        const double interval = i + 1 < samples.size() ? std::abs(samples[i + 1].time - samples[i].time) : 0;
        if (signal.values.size() == 1) signal.interval = interval;
        // Where dt was changed, or a method chooses its steps, a stretch of equal distances ends.
        if (signal.values.size() > 1 && !(std::abs(interval - signal.interval) < 1e-6 * signal.interval)) break;
        signal.values.push_back(component(samples[i].particle->displacement, axis));
    }
    return signal;
}

/// The part of the frequencies in which there is something: peaks, and normal modes.
Range frequencies_shown(const Plot& plot) {
    double last = 0, highest = 0;
    for (const plot::Moment& mode : plot.moments) last = std::max(last, mode.x);
    for (const Curve& curve : plot.curves) {
        const double peak = *std::max_element(curve.y.begin(), curve.y.end());
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (curve.y[i] > 1e-3 * peak) last = std::max(last, curve.x[i]);
        }
        highest = std::max(highest, curve.x.back());
    }
    return {0, std::min(1.2 * last, highest)};
}

/// As lines, which are named by their numbers; those of one frequency have one.
void add_modes(Plot& plot, const Context& context) {
    const auto& modes = context.state.plots.laws.modes(context.view.description);
    if (!modes) plot.x.name += " (modes: of up to 64 particles)";
    if (!modes) return;
    constexpr double equal = 1e-7;  // far above the rounding of a frequency
    for (std::size_t first = 0, next = 0; first < modes->size(); first = next) {
        while (next < modes->size() && (*modes)[next] <= (1 + equal) * (*modes)[first]) ++next;
        const bool one = next == first + 1;
        plot.moments.push_back(
            {(*modes)[first], one ? fmt::format("mode {}", next) : fmt::format("modes {}-{}", first + 1, next)});
    }
}

/// Displacements, counted from somewhere else.
void add_paths(Plot& plot, const Context& context, double origin) {
    const int axis = context.state.history.direction();
    add_runs(plot, context, [=](const Sample& sample) {
        return sample.particle ? origin + component(sample.particle->displacement, axis) : unknown;
    });
    add_ensemble(plot, context, origin);
    add_exact(plot, context, [=](const ExactPoint& point) { return origin + component(point.displacement, axis); });
}

}  // namespace

void displacement_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "displacement", .unit = "m"};
    if (begin_particle_plot(plot, context, "displacement")) add_paths(plot, context, 0);
}

void position_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "position", .unit = "m"};
    if (!begin_particle_plot(plot, context, "position")) return;
    const Vec3 rest = context.view.frame.shape->rest[context.view.tracked->particle];
    add_paths(plot, context, component(rest, context.state.history.direction()));
}

void velocity_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "velocity", .unit = "m/s"};
    if (!begin_particle_plot(plot, context, "velocity")) return;
    const int axis = context.state.history.direction();
    add_runs(plot, context, [axis](const Sample& sample) {
        return sample.particle ? component(sample.particle->velocity, axis) : unknown;
    });
    add_exact(plot, context, [axis](const ExactPoint& point) { return component(point.velocity, axis); });
}

void phase_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "displacement", .unit = "m"};
    plot.y = {.name = "velocity", .unit = "m/s"};
    if (!begin_particle_plot(plot, context, "velocity")) return;
    const int axis = context.state.history.direction();
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        const RunView& view = context.run(run);
        Curve curve{.name = name_of_run(context, run),
                    .colour = view.swatch,
                    .line = plot::line_of_run(view.swatch),
                    .ascending = false};
        for (const Sample& sample : view.series.samples) {
            if (!sample.particle) continue;
            curve.x.push_back(component(sample.particle->displacement, axis));
            curve.y.push_back(component(sample.particle->velocity, axis));
        }
        plot.curves.push_back(std::move(curve));
    }
    Curve exact = exact_curve();
    exact.ascending = false;
    for (const ExactPoint& point : exact_points(context))
        exact.add(component(point.displacement, axis), component(point.velocity, axis));
    if (!exact.x.empty()) plot.curves.push_back(std::move(exact));
}

void spectrum_plot(Plot& plot, const Context& context) {
    constexpr std::size_t fewest = 64;
    plot.y = {.name = "amplitude", .unit = "m"};
    if (!begin_particle_plot(plot, context, "amplitude")) return;
    plot.x = {.name = "angular frequency", .unit = "rad/s"};
    plot.empty = "needs 64 samples at equal distances in time";
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        const RunView& view = context.run(run);
        const Signal signal = signal_of(view.series, context.state.history.direction());
        if (signal.values.size() < fewest) continue;
        plot::Spectrum found = plot::spectrum(signal.values, signal.interval);
        plot.curves.push_back({.name = name_of_run(context, run),
                               .colour = view.swatch,
                               .line = plot::line_of_run(view.swatch),
                               .marks = plot::Marks::never,
                               .x = std::move(found.frequencies),
                               .y = std::move(found.amplitudes)});
    }
    add_modes(plot, context);
    if (!plot.curves.empty()) plot.x.range = frequencies_shown(plot);
}

}  // namespace steplab::ui
