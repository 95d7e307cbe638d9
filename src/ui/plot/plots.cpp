#include "ui/plot/plots.hpp"

#include "session/run_name.hpp"
#include "sim/catalogue.hpp"
#include "ui/plot/costs_plot.hpp"
#include "ui/plot/pair_plot.hpp"
#include "ui/plot/particle_plots.hpp"
#include "ui/plot/run_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

using plot::Curve;
using plot::Plot;

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
    const bool drag = context.view.facts.drag > 0, relative = !drag && has_energy_scale(context.view.series);
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

bool has_size(const ErrorSeries& errors) {
    return std::any_of(errors.samples.begin(), errors.samples.end(),
                       [](const ErrorSample& sample) { return sample.error > 0; });
}

/// Where errors are known, and not 0 as at the start, which a logarithmic axis does not show: a band alone would say
/// nothing.
void add_error_of_reference(Plot& plot, const SessionView& session) {
    const auto& known = session.error_series;
    if (std::none_of(known.begin(), known.end(), has_size)) return;
    plot::Band band{.name = "error of the reference", .colour = Curve::quiet, .is_cut = true};
    for (const ErrorSample& sample : known.front().samples) {
        band.x.push_back(sample.time);
        band.low.push_back(0);
        band.high.push_back(sample.reference_error);
    }
    const bool exact = std::all_of(band.high.begin(), band.high.end(), [](double error) { return error == 0; });
    if (!exact) plot.bands.push_back(std::move(band));
}

/// Of samples where the scene has an exact solution, else as far as the runs were compared with the reference.
void error_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "position error", .unit = "m"};
    plot.empty = "the runs were not compared yet";
    if (context.view.why_not_exact.empty() && context.view.has_exact)
        return add_runs(plot, context, [](const Sample& sample) { return sample.error.value_or(unknown); });
    const auto& errors = context.session.error_series;
    for (std::size_t run = 0; run < std::min(errors.size(), context.session.followers.size() + 1); ++run) {
        const std::size_t swatch = context.run(run).swatch;
        Curve curve{.name = name_of_run(context, run), .colour = swatch, .line = plot::line_of_run(swatch)};
        for (const ErrorSample& sample : errors[run].samples) {
            curve.x.push_back(sample.time);
            curve.y.push_back(sample.error);
        }
        plot.curves.push_back(std::move(curve));
    }
    add_error_of_reference(plot, context.session);
}

void momentum_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "|P - P0|", .unit = "kg m/s"};
    const auto& samples = context.view.series.samples;
    if (samples.empty()) return;  // until the leading run has taken the first one
    add_runs(plot, context,
             [start = samples.front().momentum](const Sample& sample) { return length(sample.momentum - start); });
}

void spread_plot(Plot& plot, const Context& context) {
    plot.y = {.name = "spread", .unit = "m"};
    plot.empty = "no ensemble beside the run";
    if (context.view.spread.samples.empty()) return;
    Curve curve{.name = "largest", .colour = context.view.swatch};
    for (const SpreadSample& sample : context.view.spread.samples) {
        curve.x.push_back(sample.time);
        curve.y.push_back(sample.largest);
    }
    plot.curves.push_back(std::move(curve));
}

/// Of the particles that are free to move, in as many classes as the root of their number.
void speeds_plot(Plot& plot, const Context& context) {
    plot.x = {.name = "speed", .unit = "m/s"};
    plot.y.name = "particles";
    plot.empty = "of one particle there is nothing to count";
    std::vector<double> speeds;
    const Frame& frame = context.view.frame;
    for (std::size_t i = 0; i < frame.velocities.size(); ++i) {
        const double speed = length(frame.velocities[i]);
        if (frame.shape->roles[i] != Role::fixed && std::isfinite(speed)) speeds.push_back(speed);
    }
    if (speeds.size() < 2) return;
    const double largest = *std::max_element(speeds.begin(), speeds.end());
    if (largest == 0) plot.empty = "all particles are at rest";
    if (largest == 0) return;
    const auto classes = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(speeds.size())), 4.0, 60.0));
    std::vector<double> counts(classes);
    for (const double speed : speeds)
        ++counts[std::min(classes - 1, static_cast<std::size_t>(speed / largest * static_cast<double>(classes)))];
    Curve curve{.name = "run", .marks = plot::Marks::never, .ascending = false};
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
        case PlotKind::position:
            return position_plot;
        case PlotKind::velocity:
            return velocity_plot;
        case PlotKind::phase:
            return phase_plot;
        case PlotKind::spectrum:
            return spectrum_plot;
        case PlotKind::pairs:
            return pair_plot;
        case PlotKind::momentum:
            return momentum_plot;
        case PlotKind::speeds:
            return speeds_plot;
        case PlotKind::costs:
            return costs_plot;
        case PlotKind::times:
            return times_plot;
        case PlotKind::spread:
            break;
    }
    return spread_plot;
}

/// Of a spectrum, where there is more than rounding.
std::optional<Range> upper_decades(const Plot& plot) {
    double highest = 0;
    for (const Curve& curve : plot.curves)
        highest = std::max(highest, *std::max_element(curve.y.begin(), curve.y.end()));
    return highest > 0 ? std::optional(decade_range(1e-6 * highest, highest)) : std::nullopt;
}

/// The last part of the run: an oscillation over all of it would be a bar.
std::optional<Range> recent(const SampleSeries& series) {
    constexpr std::size_t shown = 600;
    const auto& samples = series.samples;
    if (samples.size() <= shown) return std::nullopt;
    const double from = samples[samples.size() - shown].time, to = samples.back().time;
    return Range{std::min(from, to), std::max(from, to)};
}

/// Of a whole run from its start at t = 0, also where the first value is that after the first step, as errors are.
std::optional<Range> from_start(const Plot& plot) {
    bool whole = false;
    Range range{0, 0};
    for (const Curve& curve : plot.curves) {
        if (curve.x.size() < 2) continue;
        const double interval = curve.x[1] - curve.x[0];
        constexpr double rounding = 1 + 1e-6;
        whole = whole || (curve.x.front() > 0 && curve.x.front() <= rounding * interval);
        range.low = std::min(range.low, curve.x.front());
        range.high = std::max(range.high, curve.x.back());
    }
    for (const plot::Band& band : plot.bands) {
        if (!band.x.empty()) range.high = std::max(range.high, band.x.back());
    }
    return whole ? std::optional(range) : std::nullopt;
}

/// The part of time that is shown, what was done in it, and where the run stands.
void add_time(Plot& plot, const Context& context, PlotKind kind) {
    const bool oscillates = kind == PlotKind::displacement || kind == PlotKind::position || kind == PlotKind::velocity;
    const SampleSeries& series = context.view.series;
    plot.x.range = context.state.plots.window;
    if (!plot.x.range && oscillates) plot.x.range = recent(series);
    if (plot.x.range && !context.state.plots.window) plot.x.part = "latest part";
    if (!plot.x.range) plot.x.range = from_start(plot);
    for (const Mark& change : context.session.line.changes) plot.moments.push_back({change.time, change.text});
    if (!series.samples.empty() && context.view.frame.step < series.samples.back().step)
        plot.now = context.view.frame.time;
}

}  // namespace

const PlotKindInfo& info_of(PlotKind kind) {
    return *std::find_if(plot_kinds.begin(), plot_kinds.end(), [&](const auto& info) { return info.kind == kind; });
}

/// What a logarithmic axis shows of errors of either sign: their sizes.
void take_sizes(Plot& plot) {
    for (Curve& curve : plot.curves) {
        for (double& value : curve.y) value = std::abs(value);
    }
    plot.y.name = plot.y.name == "(E - E0) / |E0|" ? "|E - E0| / |E0|" : "|" + plot.y.name + "|";
}

bool is_known(const Plot& plot) {
    return std::any_of(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) {
        return std::any_of(curve.y.begin(), curve.y.end(), [](double value) { return std::isfinite(value); });
    });
}

void set_scale(Plot& plot, PlotKind kind, plot::Scale scale) {
    plot.y.scale = scale;
    if (scale != plot::Scale::logarithmic) return;
    if (kind == PlotKind::energy_error) take_sizes(plot);
    if (kind == PlotKind::spectrum) plot.y.range = upper_decades(plot);
    if (is_known(plot)) plot.empty = "no value is above 0, as a logarithmic axis needs";
}

/// From the least value above 0 on, if it is logarithmic.
void set_scale_across(Plot& plot, plot::Scale scale) {
    plot.x.scale = scale;
    if (scale != plot::Scale::logarithmic || !plot.x.range || plot.x.range->low > 0) return;
    double least = infinity;
    for (const Curve& curve : plot.curves) {
        for (const double x : curve.x) least = x > 0 ? std::min(least, x) : least;
    }
    plot.x.range = least < plot.x.range->high ? std::optional(Range{least, plot.x.range->high}) : std::nullopt;
}

/// Empty: it is known of what is played.
std::string_view why_unknown(PlotKind kind, const std::optional<PlaybackView>& playback) {
    if (!playback) return "";
    if (!playback->measured && !is_of_particles(kind)) return "not known: the file does not have a whole scene";
    if (shows_costs(kind)) return "what accuracy costs is measured of runs, not of files";
    if (!playback->has_velocities && shows_velocities(kind)) return "not known: the file has no velocities";
    return "";
}

/// Errors of methods differ by powers of ten.
Plot plot_of(const Context& context, const PlotChoice& choice) {
    Plot plot{.name = std::string(info_of(choice.kind).id),
              .caption = fmt::format("{}, {}", context.view.description.model,
                                     run_name(context.view.description, context.view.description)),
              .empty = "no data yet"};
    if (const std::string_view reason = why_unknown(choice.kind, context.session.playback); !reason.empty()) {
        plot.empty = reason;
        return plot;
    }
    const bool of_samples =
        choice.kind != PlotKind::speeds && !shows_costs(choice.kind) && choice.kind != PlotKind::pairs;
    if (context.view.series.samples.empty() && of_samples) return plot;
    fill_of(choice.kind)(plot, context);
    set_scale(plot, choice.kind, choice.scale);
    if (choice.up) plot.y.range = choice.up;
    if (choice.across) plot.x.range = choice.across;
    if (plot.x.name == "time") add_time(plot, context, choice.kind);
    set_scale_across(plot, choice.across_scale);
    plot.title = text_of(plot.y);
    return plot;
}

}  // namespace steplab::ui
