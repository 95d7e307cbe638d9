#include "lab/hard_cases/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

// ---- long time

/// dt rounded to float for both precisions: their difference is then rounding error.
Trial swing(Precision precision, bool compensated, double time) {
    Trial trial = steplab::trial("oscillator", {}, static_cast<double>(0.1f), time);
    trial.run.precision = precision;
    trial.compensated = compensated;
    trial.tolerance = precision == Precision::float_ ? 1e-7 : 1e-9;
    return trial;
}

constexpr double long_enough = 2e3;  // 2 10^4 steps

/// Radians by which x = sin, v = cos is ahead of the exact phase at time t.
double phase_ahead(const State<double>& state, double t) {
    const double x = state.displacement.x()[1], v = state.velocity.x()[1];
    return std::atan2(x * std::cos(t) - v * std::sin(t), v * std::cos(t) + x * std::sin(t));
}

double phase_after(const Trial& trial, const Method& method) {
    Simulation simulation = trial.with(method.info.id);
    simulation.advance(trial.steps() - simulation.step());
    return phase_ahead(simulation.state(), simulation.time());
}

/// The rounding error of the phase: the difference between float and double.
std::string float_phase_cell(const Method& method, bool compensated) {
    if (compensated && !ParameterValues(method.info.parameters).contains("compensated")) return "–";
    const double apart = phase_after(swing(Precision::float_, compensated, long_enough), method) -
                         phase_after(swing(Precision::double_, compensated, long_enough), method);
    return number_cell(std::remainder(apart, 6.283185307179586), 1e-8);
}

Table long_table() {
    const auto in_double = [](const Method& method) {
        return number_cell(phase_after(swing(Precision::double_, false, long_enough), method), 1e-10);
    };
    const TableColumn columns[] = {
        {"double: phase error [rad]", in_double},
        energy_column("relative energy error", swing(Precision::double_, false, long_enough), 0.5, 1e-10),
        {"float: difference from double [rad]", [](const Method& m) { return float_phase_cell(m, false); }},
        {"float, compensated [rad]", [](const Method& m) { return float_phase_cell(m, true); }}};
    return over_methods(columns);
}

/// The phase difference between float and double, at logarithmically spaced times.
plot::Curve float_phase_curve(std::string_view method, bool compensated, std::size_t colour) {
    plot::Curve curve{.name = std::string(method) + (compensated ? ", comp." : ""),
                      .colour = colour,
                      .line = plot::dashed_if(compensated),
                      .marks = plot::Marks::never};
    Simulation in_float = swing(Precision::float_, compensated, 0).with(method);
    Simulation in_double = swing(Precision::double_, compensated, 0).with(method);
    for (double steps = 10; steps <= 2e5; steps = std::ceil(steps * 1.3)) {
        for (Simulation* simulation : {&in_float, &in_double})
            simulation->advance(static_cast<std::uint64_t>(steps) - simulation->step());
        const double t = in_double.time();
        const double apart = phase_ahead(in_float.state(), t) - phase_ahead(in_double.state(), t);
        curve.add(steps, std::abs(std::remainder(apart, 6.283185307179586)));
    }
    return curve;
}

plot::Plot long_figure() {
    plot::Plot figure{.x = {.name = "steps", .scale = plot::Scale::logarithmic},
                      .y = {.name = "phase difference of float from double",
                            .unit = "rad",
                            .scale = plot::Scale::logarithmic,
                            .range = Range{1e-8, 1}}};
    std::size_t colour = 0;
    for (const char* method : {"velocity-verlet", "rk4", "pefrl", "stoermer"}) {
        for (const bool compensated : {false, true})
            figure.curves.push_back(float_phase_curve(method, compensated, colour));
        ++colour;
    }
    figure.curves.push_back(float_phase_curve("gauss-16", false, colour));
    return figure;
}

// ---- stagnation

constexpr double crawl = 1e-3, crawl_dt = 1e-4, crawl_time = 2;

/// A bullet at x = -10, where half an ulp of float is 4.8e-7, that moves by 1e-7 per step, with negligible force.
Trial crawling(Precision precision, bool compensated, double dt = crawl_dt) {
    Trial trial = steplab::trial("morse", {{"edge", 1}, {"k", 50}, {"v0", crawl}}, dt, crawl_time);
    trial.run.precision = precision;
    trial.compensated = compensated;
    trial.tolerance = precision == Precision::float_ ? 1e-6 : 1e-9;
    return trial;
}

/// The fraction of its distance that the bullet has covered.
double fraction_covered(const Simulation& simulation) {
    return (simulation.state().displacement.at(1).x + 10) / (crawl * crawl_time);
}

Table stagnation_table() {
    const auto found = [](Simulation& simulation) { return fmt::format("{:.3f}", fraction_covered(simulation)); };
    const TableColumn columns[] = {end_column("float", crawling(Precision::float_, false), found),
                                   {"float, compensated",
                                    [found](const Method& method) -> std::string {
                                        if (!ParameterValues(method.info.parameters).contains("compensated"))
                                            return "–";
                                        return end_column("", crawling(Precision::float_, true), found).cell(method);
                                    }},
                                   end_column("double", crawling(Precision::double_, false), found)};
    return over_methods(columns);
}

/// The distance covered in two seconds, for every dt.
plot::Plot stagnation_figure() {
    plot::Plot figure{.x = {.name = "dt", .unit = "s", .scale = plot::Scale::logarithmic},
                      .y = {.name = "fraction of the distance covered", .range = Range{0, 2.2}}};
    const auto add = [&](const char* method, bool compensated) {
        plot::Curve curve{.name = std::string(method) + (compensated ? ", comp." : ""),
                          .colour = figure.curves.size(),
                          .line = plot::dashed_if(compensated),
                          .marks = plot::Marks::never};
        for (double dt = 5e-5; dt < 0.05; dt *= 1.1) {
            const Trial trial = crawling(Precision::float_, compensated, dt);
            Simulation simulation = trial.with(method);
            simulation.advance(trial.steps() - simulation.step());
            curve.add(dt, fraction_covered(simulation) * crawl_time / simulation.time());
        }
        figure.curves.push_back(std::move(curve));
    };
    for (const char* method : {"velocity-verlet", "rk4", "stoermer", "dopri5"}) add(method, false);
    add("velocity-verlet", true);
    return figure;
}

// ---- decay to zero

Trial decaying(Precision precision) {
    Trial trial = steplab::trial("oscillator", {{"c", 1}}, 0.1, precision == Precision::float_ ? 250 : 1700);
    trial.run.precision = precision;
    trial.tolerance = 1e-6;
    return trial;
}

double smallest_normal(Precision precision) {
    return precision == Precision::float_ ? static_cast<double>(std::numeric_limits<float>::min())
                                          : std::numeric_limits<double>::min();
}

std::string decay_cell(const Method& method, Precision precision) {
    const Trial trial = decaying(precision);
    Simulation simulation = trial.with(method.info.id);
    std::size_t subnormal = 0;
    double left = 0;
    const bool whole = observed(simulation, trial.steps(), trial.steps(), [&](Simulation& s) {
        const double x = std::abs(s.state().displacement.x()[1]), v = std::abs(s.state().velocity.x()[1]);
        for (const double number : {x, v}) subnormal += number > 0 && number < smallest_normal(precision) ? 1 : 0;
        left = std::max(x, v);
    });
    if (!whole) return divergence_cell(simulation);
    return fmt::format("{} subnormal, finally {:.0e}", subnormal, left);
}

Table decay_table() {
    const TableColumn columns[] = {{"float", [](const Method& m) { return decay_cell(m, Precision::float_); }},
                                   {"double", [](const Method& m) { return decay_cell(m, Precision::double_); }}};
    return over_methods(columns);
}

plot::Plot decay_figure() {
    plot::Plot figure{.x = {.name = "time", .unit = "s"},
                      .y = {.name = "amplitude |(x, v)|",
                            .unit = "m, m/s",
                            .scale = plot::Scale::logarithmic,
                            .range = Range{1e-320, 1}}};
    for (const char* method : {"velocity-verlet", "rk4", "tr-bdf2", "dopri5", "gauss-16"}) {
        figure.curves.push_back(curve_over_time(
            decaying(Precision::double_), method, figure.curves.size(),
            [](const Simulation& s) { return std::hypot(s.state().displacement.x()[1], s.state().velocity.x()[1]); }));
    }
    return figure;
}

}  // namespace

HardCase long_time() {
    return {"long-time",
            "Long-time phase errors",
            "An oscillator over 2·10⁴ steps of 0.1 s: phase error and energy error in double, and what "
            "rounding in float adds to the phase, with plain and with compensated summation.",
            "Rounding error of an oscillator's phase in float (dashed: compensated summation)",
            long_table,
            long_figure,
            [](const Method&) { return std::vector{swing(Precision::double_, false, long_enough)}; }};
}

HardCase stagnation() {
    return {"stagnation",
            "Stagnation in float",
            "A bullet at x = -10 m moves by less than half an ulp of its position in each step: the fraction "
            "of its path that it covers in 2 s (1 is correct).",
            "Fraction of its distance that a slow bullet covers in float, against dt (dashed: compensated summation)",
            stagnation_table,
            stagnation_figure};
}

HardCase decay_to_zero() {
    return {"subnormal",
            "Subnormal numbers",
            "A damped oscillator decays to the smallest normal numbers: the subnormal numbers found on the "
            "way, and the amplitude at the end.",
            "A damped oscillator in double: decay beyond the smallest normal number, 2e-308, to zero",
            decay_table,
            decay_figure,
            [](const Method&) { return std::vector{decaying(Precision::double_)}; }};
}

}  // namespace steplab
