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

bool knows_exact(const SampleSeries& series) {
    return std::any_of(series.samples.begin(), series.samples.end(),
                       [](const Sample& sample) { return sample.particle && sample.particle->exact_displacement; });
}

bool begin_particle_plot(Plot& plot, const Context& context, std::string_view what) {
    plot.empty = "click a particle to plot what it does";
    if (!context.view.tracked) return false;
    const std::string_view axis = axis_names[context.state.history.direction()];
    plot.y.name = fmt::format("{} {} of particle {}", what, axis, context.view.tracked->particle);
    plot.empty = "no data yet";
    return true;
}

/// Between the lowest and the highest run of the ensemble.
void add_ensemble(Plot& plot, const Context& context) {
    const int axis = context.state.history.direction();
    plot::Band band{.name = "ensemble"};
    for (const SpreadSample& sample : context.view.spread.samples) {
        if (!sample.reach) continue;
        band.x.push_back(sample.time);
        band.low.push_back(component(sample.reach->low, axis));
        band.high.push_back(component(sample.reach->high, axis));
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
    if (!modes) plot.x.name += " (normal modes: computed of at most 64 particles)";
    if (!modes) return;
    constexpr double equal = 1e-7;  // far above the rounding of a frequency
    for (std::size_t first = 0, next = 0; first < modes->size(); first = next) {
        while (next < modes->size() && (*modes)[next] <= (1 + equal) * (*modes)[first]) ++next;
        const bool one = next == first + 1;
        plot.moments.push_back(
            {(*modes)[first], one ? fmt::format("mode {}", next) : fmt::format("modes {}-{}", first + 1, next)});
    }
}

}  // namespace

void displacement_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "displacement", .unit = "m"};
    if (!begin_particle_plot(plot, context, "displacement")) return;
    const int axis = context.state.history.direction();
    add_runs(plot, context, [axis](const Sample& sample) {
        return sample.particle ? component(sample.particle->displacement, axis) : unknown;
    });
    add_ensemble(plot, context);
    if (!knows_exact(context.view.series)) return;
    plot.curves.push_back(over_time("exact", Curve::exact, context.view.series, [axis](const Sample& sample) {
        const auto& particle = sample.particle;
        return particle && particle->exact_displacement ? component(*particle->exact_displacement, axis) : unknown;
    }));
    plot.curves.back().line = plot::Line::dashed;
}

void velocity_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "velocity", .unit = "m/s"};
    if (!begin_particle_plot(plot, context, "velocity")) return;
    const int axis = context.state.history.direction();
    add_runs(plot, context, [axis](const Sample& sample) {
        return sample.particle ? component(sample.particle->velocity, axis) : unknown;
    });
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
