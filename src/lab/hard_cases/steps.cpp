#include "lab/hard_cases/steps.hpp"

#include "sim/run/linear_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace steplab {

namespace {

/// The limit, or that there is none.
std::string limit_cell(const Method& method, double limit) {
    if (method.info.adaptive) return "none (adaptive)";
    return std::isinf(limit) ? "none" : fmt::format("{:.4g}", limit);
}

// ---- at the edge of stability

constexpr double marginal_number = 1e6;

/// A run at this fraction of the limit. Methods without a limit are run far beyond the limits of all others, or, if
/// they are unstable at any dt, at a dt that is small for the others.
Trial marginal(const Method& method, double factor) {
    if (has_limit(method)) {
        const double dt = factor * limit_of(method);
        return trial("oscillator", {}, dt, marginal_number * dt);
    }
    return limit_of(method) == 0 ? trial("oscillator", {}, 0.1, 0.1 * marginal_number)
                                 : trial("oscillator", {}, 100, 1e4);
}

/// Calls `observe` at logarithmically spaced steps. False if the run diverged.
bool run_observed(Simulation& simulation, std::uint64_t most, const Observer& observe) {
    for (double steps = 1; steps <= static_cast<double>(most); steps = std::ceil(steps * 1.05)) {
        simulation.advance(static_cast<std::uint64_t>(steps) - simulation.step());
        if (simulation.divergence()) return false;
        observe(simulation);
    }
    return true;
}

/// The largest |x|, in units of the exact amplitude, and whether the motion decays.
std::string swing_cell(const Method& method, double factor) {
    const Trial trial = marginal(method, factor);
    Simulation simulation = trial.with(method.info.id);
    double largest = 0, late = 0;
    const bool whole = run_observed(simulation, trial.steps(), [&](Simulation& s) {
        const double swing = s.diagnostics().max_displacement;
        largest = std::max(largest, swing);
        if (s.step() > trial.steps() / 2) late = std::max(late, swing);
    });
    const std::string where = has_limit(method) ? "" : fmt::format(" (at ω dt = {:g})", trial.run.dt);
    if (!whole) return fmt::format("blows up in step {}{}", simulation.step() + 1, where);
    return fmt::format("{:.2g}{}{}", largest, late < 0.1 * largest ? ", decays" : "", where);
}

Table marginal_table() {
    const TableColumn columns[] = {
        {"stability limit of ω dt", [](const Method& method) { return limit_cell(method, limit_of(method)); }},
        {"largest amplitude at 0.999 of the limit", [](const Method& method) { return swing_cell(method, 0.999); }},
        {"at 1.001 of the limit",
         [](const Method& method) { return has_limit(method) ? swing_cell(method, 1.001) : std::string("–"); }}};
    return over_methods(columns);
}

/// The amplitude at each of these steps: the largest |x| of the last three observations.
plot::Curve swing_curve(const std::string& id, double factor, std::size_t colour) {
    plot::Curve curve{.name = fmt::format("{}, {}", id, factor),
                      .colour = colour,
                      .line = plot::dashed_if(factor > 1),
                      .marks = plot::Marks::never};
    Simulation simulation = marginal(method(id), factor).with(id);
    double last = 0, one_before = 0;
    run_observed(simulation, static_cast<std::uint64_t>(marginal_number), [&](Simulation& s) {
        const double now = s.diagnostics().max_displacement;
        curve.add(static_cast<double>(s.step()), std::max({now, last, one_before}));
        one_before = std::exchange(last, now);
    });
    return curve;
}

plot::Plot marginal_figure() {
    plot::Plot figure{.x = {.name = "steps", .scale = plot::Scale::logarithmic},
                      .y = {.name = "largest displacement [m], exact: 1",
                            .scale = plot::Scale::logarithmic,
                            .range = Range{1e-4, 1e4}}};
    std::size_t colour = 0;
    for (const char* id : {"verlet", "pefrl", "kahan-li-8", "rk4"}) {
        for (const double factor : {0.999, 1.001}) figure.curves.push_back(swing_curve(id, factor, colour));
        ++colour;
    }
    return figure;
}

// ---- dt changed during the run

constexpr int quarter_steps = 8;
constexpr double quarter = std::numbers::pi / 2;
constexpr int quarters = 400;

enum class Changes { none, once, always };

/// An oscillator over a hundred periods in steps of 1/8 of a quarter period, or half as long where changed; `observe`
/// is called after every quarter.
void swing(std::string_view method, Changes changes, const Observer& observe) {
    const double dt = quarter / quarter_steps;
    Simulation simulation = trial("oscillator", {}, dt, 0).with(method);
    for (int i = 0; i < quarters && !simulation.divergence(); ++i) {
        const bool halved = changes == Changes::once ? i >= quarters / 2 : changes == Changes::always && i % 2 == 1;
        RunDescription description = simulation.description();
        description.dt = halved ? dt / 2 : dt;
        simulation.change(description);
        simulation.advance(halved ? 2 * quarter_steps : quarter_steps);
        observe(simulation);
    }
}

TableColumn change_column(std::string head, Changes changes) {
    return {std::move(head), [changes](const Method& method) {
                double worst = 0;
                bool diverged = false;
                swing(method.info.id, changes, [&](Simulation& simulation) {
                    worst = std::max(worst, 2 * std::abs(simulation.energy_error()));
                    diverged = simulation.divergence().has_value();
                });
                return diverged || worst > 1e12 ? "blows up" : number_cell(worst);
            }};
}

Table change_table() {
    const TableColumn columns[] = {change_column("dt constant", Changes::none),
                                   change_column("halved once, after half the time", Changes::once),
                                   change_column("changed every quarter period", Changes::always)};
    return over_methods(columns);
}

plot::Plot change_figure() {
    plot::Plot figure{.x = {.name = "periods"},
                      .y = {.name = "|energy error| / energy", .scale = plot::Scale::logarithmic}};
    std::size_t colour = 0;
    for (const char* id : {"velocity-verlet", "pefrl", "srkn-11b", "rk4", "implicit-midpoint"}) {
        for (const Changes changes : {Changes::none, Changes::always}) {
            const bool changed = changes == Changes::always;
            plot::Curve curve{.name = std::string(id) + (changed ? ", dt changed" : ", dt constant"),
                              .colour = colour,
                              .line = plot::dashed_if(!changed),
                              .marks = plot::Marks::never};
            double worst = 0;
            int samples = 0;
            swing(id, changes, [&](Simulation& simulation) {
                worst = std::max(worst, 2 * std::abs(simulation.energy_error()));
                if (samples++ % 4 == 0) curve.add(simulation.time() / (4 * quarter), worst);
            });
            figure.curves.push_back(std::move(curve));
        }
        ++colour;
    }
    return figure;
}

// ---- resonances of the step

double growth_at(const Method& method, double phase) {
    return step_growth(method, ParameterValues(method.info.parameters), 1, 0, phase) - 1;
}

/// An interval of omega dt in which the motion grows, and the largest growth per step.
struct Band {
    double from = 0, to = infinity, growth = 0;
};

constexpr double scanned_to = 8, scan_step = 2e-4;

/// The bands beyond the declared limit; the last one is open.
std::vector<Band> bands(const Method& method) {
    std::vector<Band> all;
    bool inside = false;
    for (double phase = 0.99 * limit_of(method); phase < scanned_to; phase += scan_step) {
        const double growth = growth_at(method, phase);
        const bool grows = growth > 1e-9;
        if (grows && !inside) all.push_back({.from = phase});
        if (grows) all.back().growth = std::max(all.back().growth, growth);
        if (!grows && inside) all.back().to = phase;
        inside = grows;
    }
    return all;
}

std::string bands_cell(const Method& method) {
    std::string text;
    for (const Band& band : bands(method)) {
        if (!text.empty()) text += "; ";
        text += std::isinf(band.to)
                    ? fmt::format("above {:.4g}", band.from)
                    : fmt::format("{:.5g} to {:.5g}, by {:.1e} per step", band.from, band.to, band.growth);
    }
    return text;
}

Table resonance_table() {
    const auto cell = [](const Method& method) -> std::string {
        if (method.info.adaptive || std::isinf(limit_of(method))) return "none";
        if (limit_of(method) == 0) return "any";
        return limit_of(method) < scanned_to ? bands_cell(method) : fmt::format("above {:g}", limit_of(method));
    };
    const TableColumn columns[] = {{"unstable at ω dt", cell}};
    return over_methods(columns);
}

plot::Plot resonance_figure() {
    plot::Plot figure{
        .x = {.name = "ω dt"},
        .y = {.name = "growth of the amplitude per step", .scale = plot::Scale::logarithmic, .range = Range{1e-5, 1}}};
    for (const char* id : {"pefrl", "mclachlan-atela-5", "kahan-li-8", "srkn-11b"}) {
        plot::Curve curve{.name = id, .colour = figure.curves.size(), .marks = plot::Marks::never};
        for (double phase = 2.95; phase<3.55; phase += phase> 3.14 && phase < 3.144 ? 4e-5 : 2e-3)
            curve.add(phase, std::max(growth_at(method(id), phase), 1e-9));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

// ---- substeps back in time, with drag

std::string damped_limit_cell(const Method& method, double ratio) {
    return limit_cell(method, linear_limit(method, ParameterValues(method.info.parameters), 1, ratio));
}

Table drag_table() {
    std::vector<TableColumn> columns;
    for (const double ratio : {0.0, 0.2, 2.0, 20.0, 100.0}) {
        columns.push_back({fmt::format("γ/ω = {:g}", ratio),
                           [ratio](const Method& method) { return damped_limit_cell(method, ratio); }});
    }
    return over_methods(columns);
}

plot::Plot drag_figure() {
    plot::Plot figure{.x = {.name = "damping γ/ω", .scale = plot::Scale::logarithmic},
                      .y = {.name = "stability limit of ω dt", .scale = plot::Scale::logarithmic}};
    for (const char* id : {"euler", "rk4", "verlet", "velocity-verlet", "forest-ruth", "pefrl", "mclachlan-atela-5",
                           "srkn-11b", "kahan-li-8"}) {
        plot::Curve curve{.name = id, .colour = figure.curves.size(), .marks = plot::Marks::never};
        const Method& method = steplab::method(id);
        for (double ratio = 0.01; ratio < 150; ratio *= 1.25)
            curve.add(ratio, linear_limit(method, ParameterValues(method.info.parameters), 1, ratio));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

HardCase marginal_steps() {
    return {"marginal-dt",
            "Stability limit",
            "An oscillator over 10⁶ steps just below and just above each method's stability limit: below "
            "it the motion stays bounded, above it it grows without bound, however slowly. The exact motion "
            "has an amplitude of 1 m.",
            "Amplitude of an oscillator at 0.999 (solid) and 1.001 (dashed) of the stability limit",
            marginal_table,
            marginal_figure,
            [](const Method& method) { return std::vector{marginal(method, 1.001)}; }};
}

HardCase changed_steps() {
    return {"changed-dt",
            "Changing dt during a run",
            "An oscillator over 100 periods. A symplectic method conserves a modified energy that depends on "
            "dt: one change of dt has no visible effect, changes in phase with the motion add up.",
            "Energy error of an oscillator with dt constant (dashed) and changed every quarter period",
            change_table,
            change_figure};
}

HardCase step_resonances() {
    return {"step-resonance",
            "Step-size resonances",
            "Bands of ω dt in which the motion of an oscillator grows, from the eigenvalues of the matrix "
            "of one step: a method can be unstable in a narrow band below the dt at which it finally fails.",
            "Growth of an oscillator's amplitude per step, beyond the stability limits",
            resonance_table,
            resonance_figure};
}

HardCase backward_steps_with_drag() {
    return {"drag",
            "Negative substeps with drag",
            "Splitting methods of order above 2 have negative substeps, in which drag amplifies the "
            "velocity. Stability limit of ω dt of an oscillator with damping γ.",
            "Stability limit of ω dt against damping",
            drag_table,
            drag_figure};
}

}  // namespace steplab
