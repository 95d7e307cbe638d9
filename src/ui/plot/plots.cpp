#include "ui/plot/plots.hpp"

#include "session/run_name.hpp"
#include "sim/catalogue.hpp"
#include "ui/plot/costs_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view axis_names[] = {"x", "y", "z"};

using Value = std::function<double(const Sample&)>;

/// A curve over time of what samples hold. Runs that go backward in time ascend, too.
Curve over_time(std::string name, std::size_t colour, const SampleSeries& series, const Value& value) {
    Curve curve{.name = std::move(name), .colour = colour};
    for (const Sample& sample : series.samples) {
        curve.x.push_back(sample.time);
        curve.y.push_back(value(sample));
    }
    if (curve.x.size() > 1 && curve.x.front() > curve.x.back()) {
        std::reverse(curve.x.begin(), curve.x.end());
        std::reverse(curve.y.begin(), curve.y.end());
    }
    return curve;
}

std::string name_of(const Context& context, std::size_t run) {
    if (context.session.followers.empty()) return "run";
    return run_name(context.run(run).description, context.view.description);
}

/// The same of all runs, each in its colour and line.
void add_runs(Plot& plot, const Context& context, const Value& value) {
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        const RunView& view = context.run(run);
        if (view.series.samples.empty()) continue;  // in still pictures only the leading run has any
        plot.curves.push_back(over_time(name_of(context, run), run, view.series, value));
        plot.curves.back().line = plot::line_of_run(run);
    }
}

double relative_energy_error(const Sample& sample) {
    return sample.energy_error / std::abs(sample.kinetic + sample.potential - sample.energy_error);
}

/// True if E0 is a scale of the energies: not where large ones cancel, or where it is zero by choice.
bool has_energy_scale(const SampleSeries& series) {
    double largest = 0, start = 0;
    for (const Sample& sample : series.samples) {
        largest = std::max({largest, std::abs(sample.kinetic), std::abs(sample.potential)});
        start = std::abs(sample.kinetic + sample.potential - sample.energy_error);
    }
    return start > 1e-3 * largest;
}

void energy_error_plot(Plot& plot, const Context& context) {
    const bool drag = has_drag(context.view.description), relative = !drag && has_energy_scale(context.view.series);
    plot.y = {.name = drag ? "energy change" : "E - E0", .unit = "J"};
    if (relative) plot.y = {.name = "(E - E0) / |E0|", .unit = ""};
    add_runs(plot, context, [relative](const Sample& sample) {
        return relative ? relative_energy_error(sample) : sample.energy_error;
    });
}

void energies_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "energy", .unit = "J"};
    const SampleSeries& series = context.view.series;
    plot.curves = {
        over_time("kinetic", 0, series, [](const Sample& sample) { return sample.kinetic; }),
        over_time("potential", 1, series, [](const Sample& sample) { return sample.potential; }),
        over_time("total", 2, series, [](const Sample& sample) { return sample.kinetic + sample.potential; })};
    for (std::size_t i = 0; i < plot.curves.size(); ++i) plot.curves[i].line = plot::line_of_run(i);
}

Curve traced(const Course& course, std::string name, std::size_t run) {
    Curve curve{.name = std::move(name), .colour = run, .line = plot::line_of_run(run)};
    curve.x.assign(course.times().begin(), course.times().end());
    curve.y.assign(course.values().begin(), course.values().end());
    return curve;
}

/// Of samples where the scene has an exact solution, else as far as the runs were compared with the reference.
void error_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "position error", .unit = "m"};
    plot.empty = "the runs were not compared yet";
    if (context.view.has_exact)
        return add_runs(plot, context, [](const Sample& sample) { return sample.error.value_or(unknown); });
    const auto errors = context.state.history.errors();
    for (std::size_t run = 0; run < std::min(errors.size(), context.session.followers.size() + 1); ++run)
        plot.curves.push_back(traced(errors[run], name_of(context, run), run));
}

void momentum_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "|P - P0|", .unit = "kg m/s"};
    add_runs(plot, context, [&context](const Sample& sample) {
        return length(sample.momentum - context.view.series.samples.front().momentum);
    });
}

void spread_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "spread", .unit = "m"};
    plot.empty = "no ensemble beside the run";
    if (!context.state.history.spread().times().empty())
        plot.curves.push_back(traced(context.state.history.spread(), "largest", 0));
}

// of the selected particle

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

void displacement_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "displacement", .unit = "m"};
    if (!begin_particle_plot(plot, context, "displacement")) return;
    const int axis = context.state.history.direction();
    add_runs(plot, context, [axis](const Sample& sample) {
        return sample.particle ? component(sample.particle->displacement, axis) : unknown;
    });
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
        Curve curve{.name = name_of(context, run), .colour = run, .line = plot::line_of_run(run), .ascending = false};
        for (const Sample& sample : view.series.samples) {
            if (!sample.particle) continue;
            curve.x.push_back(component(sample.particle->displacement, axis));
            curve.y.push_back(component(sample.particle->velocity, axis));
        }
        plot.curves.push_back(std::move(curve));
    }
}

/// Of the particles that move, in as many classes as the root of their number.
void speeds_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "speed", .unit = "m/s"};
    plot.y.name = "particles";
    plot.empty = "of one particle there is nothing to count";
    std::vector<double> speeds;
    for (const Vec3 velocity : context.view.frame.velocities) {
        if (const double speed = length(velocity); speed > 0 && std::isfinite(speed)) speeds.push_back(speed);
    }
    if (speeds.size() < 2) return;
    const double largest = *std::max_element(speeds.begin(), speeds.end());
    const auto classes = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(speeds.size())), 4.0, 60.0));
    std::vector<double> counts(classes);
    for (const double speed : speeds)
        ++counts[std::min(classes - 1, static_cast<std::size_t>(speed / largest * static_cast<double>(classes)))];
    Curve curve{.name = "run", .ascending = false};
    const auto corner = [&](double part, double count) {
        curve.x.push_back(largest * part / static_cast<double>(classes));
        curve.y.push_back(count);
    };
    corner(0, 0);
    for (std::size_t i = 0; i < classes; ++i) {
        corner(static_cast<double>(i), counts[i]);
        corner(static_cast<double>(i + 1), counts[i]);
    }
    corner(static_cast<double>(classes), 0);
    plot.curves.push_back(std::move(curve));
}

using Fill = void (*)(Plot&, const Context&);
Fill fill_of(PlotKind kind) {
    switch (kind) {
        case PlotKind::energy_error:
            return energy_error_plot;
        case PlotKind::energies:
            return energies_plot;
        case PlotKind::error:
            return error_plot;
        case PlotKind::displacement:
            return displacement_plot;
        case PlotKind::velocity:
            return velocity_plot;
        case PlotKind::phase:
            return phase_plot;
        case PlotKind::momentum:
            return momentum_plot;
        case PlotKind::speeds:
            return speeds_plot;
        case PlotKind::costs:
            return costs_plot;
        case PlotKind::spread:
            break;
    }
    return spread_plot;
}

/// The last part of the run: an oscillation over all of it would be a bar.
std::optional<Range> recent(const SampleSeries& series) {
    constexpr std::size_t shown = 600;
    const auto& samples = series.samples;
    if (samples.size() <= shown) return std::nullopt;
    const double from = samples[samples.size() - shown].time, to = samples.back().time;
    return Range{std::min(from, to), std::max(from, to)};
}

/// The part of time that is shown, what was done in it, and where the run stands.
void add_time(Plot& plot, const Context& context, PlotKind kind) {
    const bool oscillates = kind == PlotKind::displacement || kind == PlotKind::velocity;
    const SampleSeries& series = context.view.series;
    plot.x.range = context.state.plots.window;
    if (!plot.x.range && oscillates) plot.x.range = recent(series);
    for (const Mark& change : context.session.line.changes) plot.moments.push_back({change.time, change.text});
    if (!series.samples.empty() && context.view.frame.step < series.samples.back().step)
        plot.now = context.view.frame.time;
}

}  // namespace

const PlotKindInfo& info_of(PlotKind kind) {
    return *std::find_if(plot_kinds.begin(), plot_kinds.end(), [&](const auto& info) { return info.kind == kind; });
}

PlotChoice default_choice(PlotKind kind) {
    const bool logarithmic = kind == PlotKind::costs || kind == PlotKind::error;
    return {kind, logarithmic ? plot::Scale::logarithmic : plot::Scale::linear};
}

Plot plot_of(const Context& context, const PlotChoice& choice) {
    Plot plot{.name = std::string(info_of(choice.kind).id),
              .caption = fmt::format("{}, {}", context.view.description.model,
                                     run_name(context.view.description, context.view.description)),
              .empty = "no data yet"};
    const auto& playback = context.session.playback;
    if (playback && !playback->measured) {
        plot.empty = "not known: the file does not have a whole scene";
        return plot;
    }
    const bool of_samples = choice.kind != PlotKind::speeds && choice.kind != PlotKind::costs;
    if (context.view.series.samples.empty() && of_samples) return plot;
    fill_of(choice.kind)(plot, context);
    plot.y.scale = choice.scale;
    if (plot.x.name == "time") add_time(plot, context, choice.kind);
    plot.title = plot.y.unit.empty() ? plot.y.name : fmt::format("{} [{}]", plot.y.name, plot.y.unit);
    return plot;
}

}  // namespace steplab::ui
