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

/// How many are shown: beside other runs as many as there are lines.
std::size_t tracked_count(const Context& context) {
    const std::size_t all = 1 + context.view.also_tracked.size();
    return context.session.followers.empty() ? all : std::min(all, plot::lines_of_runs);
}

/// The particle in a place of the samples.
const Tracked& tracked_in(const Context& context, std::size_t place) {
    return place == 0 ? *context.view.tracked : context.view.also_tracked[place - 1];
}

std::string particle_name(const Context& context, std::size_t place) {
    return fmt::format("particle {}", tracked_in(context, place).particle);
}

/// "particles 3, 7", or how many of those that are selected.
std::string particles_text(const Context& context) {
    constexpr std::size_t most_named = 4;
    const std::size_t count = tracked_count(context), selected = context.state.selection.count(context.view);
    if (count < selected) return fmt::format("{} of {} particles", count, selected);
    if (count > most_named) return fmt::format("{} particles", count);
    std::string text = particle_name(context, 0);
    if (count > 1) text.insert(text.find(' '), "s");
    for (std::size_t place = 1; place < count; ++place)
        text += fmt::format(", {}", tracked_in(context, place).particle);
    return text;
}

bool begin_particle_plot(Plot& plot, const Context& context, std::string_view what) {
    plot.empty = "click a particle to plot what it does";
    if (!context.view.tracked) return false;
    const std::string_view axis = axis_names[context.state.history.direction()];
    plot.y.name = fmt::format("{} {} of {}", what, axis, particles_text(context));
    plot.empty = "no data yet";
    return true;
}

/// What a particle does in a run, without points. In one run particles are told apart by colours, and lines where these
/// are used up. Beside other runs the colour is that of the run and the line that of the particle, and the legend has
/// each of them once.
Curve curve_of(const Context& context, std::size_t run, std::size_t place) {
    const std::size_t swatch = context.run(run).swatch;
    Curve curve{.name = name_of_run(context, run), .colour = swatch, .line = plot::line_of_run(swatch)};
    if (tracked_count(context) == 1) return curve;
    const std::string particle = particle_name(context, place);
    if (context.session.followers.empty()) {
        curve.name = particle;
        curve.colour = (swatch + place) % plot::lines_of_runs;
        curve.line = plot::dashed_if(place >= plot::lines_of_runs);
        return curve;
    }
    curve.label = run > 0 ? curve.name : particle;
    curve.name += ", " + particle;
    if (run == 0 && place == 0) curve.label = curve.name;
    curve.in_legend = run == 0 || place == 0;
    curve.line = plot::line_of_run(place);
    return curve;
}

/// Calls work(run, place) for each run and each tracked particle.
template <class Work>
void for_each_motion(const Context& context, const Work& work) {
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        for (std::size_t place = 0; place < tracked_count(context); ++place) work(run, place);
    }
}

/// What particles do in all runs: value(particle, place) over time.
template <class Value>
void add_motions(Plot& plot, const Context& context, const Value& value) {
    for_each_motion(context, [&](std::size_t run, std::size_t place) {
        const SampleSeries& series = context.run(run).series;
        if (series.samples.empty()) return;  // until it has taken the first one
        const Curve look = curve_of(context, run, place);
        plot.curves.push_back(over_time(look.name, look.colour, series, [&](const Sample& sample) {
            const Sample::Particle* const known = sample.particle(place);
            return known ? value(*known, place) : unknown;
        }));
        plot.curves.back().line = look.line;
    });
}

/// The exact motion of each particle: add(curve, point, place) adds a point.
template <class Add>
void add_exact(Plot& plot, const Context& context, bool ascending, const Add& add) {
    for (std::size_t place = 0; place < tracked_count(context); ++place) {
        Curve curve{.name = "exact", .colour = Curve::exact, .line = plot::Line::dashed, .ascending = ascending};
        if (place > 0) curve.name += ", " + particle_name(context, place);
        curve.in_legend = place == 0;
        const auto points = context.state.plots.exact[place].of(
            context.view.series, place, tracked_in(context, place).exact, context.view.frame.positions.size());
        for (const ExactPoint& point : points) add(curve, point, place);
        if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
    }
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

Signal signal_of(const SampleSeries& series, std::size_t place, int axis) {
    constexpr std::size_t most = 4096;
    Signal signal;
    const auto& samples = series.samples;
    for (std::size_t i = samples.size(); i-- > 0 && signal.values.size() < most;) {
        const Sample::Particle* const known = samples[i].particle(place);
        if (!known) break;
        const double interval = i + 1 < samples.size() ? std::abs(samples[i + 1].time - samples[i].time) : 0;
        if (signal.values.size() == 1) signal.interval = interval;
        // Where dt was changed, or a method chooses its steps, a stretch of equal distances ends.
        if (signal.values.size() > 1 && !(std::abs(interval - signal.interval) < 1e-6 * signal.interval)) break;
        signal.values.push_back(component(known->displacement, axis));
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
    if (context.session.playback && !context.session.playback->measured) return;  // of particles without their scene
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

/// Displacements, counted from origin(place).
template <class Origin>
void add_paths(Plot& plot, const Context& context, const Origin& origin) {
    const int axis = context.state.history.direction();
    add_motions(plot, context, [&](const Sample::Particle& known, std::size_t place) {
        return origin(place) + component(known.displacement, axis);
    });
    add_ensemble(plot, context, origin(0));
    add_exact(plot, context, true, [&](Curve& curve, const ExactPoint& point, std::size_t place) {
        curve.add(point.time, origin(place) + component(point.displacement, axis));
    });
}

}  // namespace

void displacement_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "displacement", .unit = "m"};
    if (begin_particle_plot(plot, context, "displacement")) add_paths(plot, context, [](std::size_t) { return 0; });
}

void position_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "position", .unit = "m"};
    if (!begin_particle_plot(plot, context, "position")) return;
    add_paths(plot, context, [&](std::size_t place) {
        const Vec3 rest = context.view.frame.shape->rest[tracked_in(context, place).particle];
        return component(rest, context.state.history.direction());
    });
}

void velocity_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "velocity", .unit = "m/s"};
    if (!begin_particle_plot(plot, context, "velocity")) return;
    const int axis = context.state.history.direction();
    add_motions(plot, context,
                [axis](const Sample::Particle& known, std::size_t) { return component(known.velocity, axis); });
    add_exact(plot, context, true, [axis](Curve& curve, const ExactPoint& point, std::size_t) {
        curve.add(point.time, component(point.velocity, axis));
    });
}

void phase_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "displacement", .unit = "m"};
    plot.y = {.name = "velocity", .unit = "m/s"};
    if (!begin_particle_plot(plot, context, "velocity")) return;
    const int axis = context.state.history.direction();
    for_each_motion(context, [&](std::size_t run, std::size_t place) {
        Curve curve = curve_of(context, run, place);
        curve.ascending = false;
        for (const Sample& sample : context.run(run).series.samples) {
            if (const Sample::Particle* const known = sample.particle(place))
                curve.add(component(known->displacement, axis), component(known->velocity, axis));
        }
        plot.curves.push_back(std::move(curve));
    });
    add_exact(plot, context, false, [axis](Curve& curve, const ExactPoint& point, std::size_t) {
        curve.add(component(point.displacement, axis), component(point.velocity, axis));
    });
}

void spectrum_plot(Plot& plot, const Context& context) {
    constexpr std::size_t fewest = 64;
    plot.y = {.name = "amplitude", .unit = "m"};
    if (!begin_particle_plot(plot, context, "amplitude")) return;
    plot.x = {.name = "angular frequency", .unit = "rad/s"};
    plot.empty = "needs 64 samples at equal distances in time";
    for_each_motion(context, [&](std::size_t run, std::size_t place) {
        const Signal signal = signal_of(context.run(run).series, place, context.state.history.direction());
        if (signal.values.size() < fewest) return;
        plot::Spectrum found = plot::spectrum(signal.values, signal.interval);
        Curve curve = curve_of(context, run, place);
        curve.marks = plot::Marks::never;
        curve.x = std::move(found.frequencies);
        curve.y = std::move(found.amplitudes);
        plot.curves.push_back(std::move(curve));
    });
    add_modes(plot, context);
    if (!plot.curves.empty()) plot.x.range = frequencies_shown(plot);
}

}  // namespace steplab::ui
