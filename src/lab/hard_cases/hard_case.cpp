#include "lab/hard_cases/hard_case.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "sim/run/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

Simulation Trial::with(std::string_view method) const {
    RunDescription description = with_method(run, method);
    ParameterValues& parameters = description.method_parameters;
    if (steplab::method(method).info.adaptive) parameters.set("tolerance", tolerance);
    if (parameters.contains("compensated")) parameters.set("compensated", compensated ? 1 : 0);
    Simulation simulation(description);
    prepare(simulation);
    return simulation;
}

Trial trial(std::string_view model, Settings settings, double dt, double time) {
    Trial trial{.run = describe(model, "rk4"), .time = time};
    for (const auto& [name, value] : settings) trial.run.scene.set(name, value);
    trial.run.dt = dt;
    return trial;
}

bool observed(Simulation& simulation, std::uint64_t steps, std::uint64_t moments, const Observer& observe) {
    for (Samples samples(steps, moments); samples.advance(simulation);) {
        if (simulation.divergence()) return false;
        observe(simulation);
    }
    return true;
}

double limit_of(const Method& method) { return linear_limit(method.info, ParameterValues(method.info.parameters)); }

bool has_limit(const Method& method) {
    return !method.info.adaptive && limit_of(method) > 0 && std::isfinite(limit_of(method));
}

Table over_methods(std::span<const TableColumn> columns) {
    Table table{{"method"}, {}};
    for (const TableColumn& column : columns) table.head.push_back(column.head);
    for (const Method& method : methods()) {
        std::vector<std::string> row{fmt::format("`{}`", method.info.id)};
        for (const TableColumn& column : columns) {
            check_interruption();
            try {
                row.push_back(column.cell(method));
            } catch (const UsageError&) {
                row.emplace_back("cannot run this scene");
            }
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string number_cell(double value, double least) {
    if (!std::isfinite(value)) return "not finite";
    if (std::abs(value) < least) return fmt::format("< {:.0e}", least);
    return std::abs(value) >= 0.01 && std::abs(value) < 100 ? fmt::format("{:.2g}", value)
                                                            : fmt::format("{:.1e}", value);
}

std::string divergence_cell(const Simulation& simulation) {
    return fmt::format("blows up at t = {:.2g}", simulation.divergence()->time);
}

std::string energy_cell(const Trial& trial, const Method& method, double scale, double least) {
    Simulation simulation = trial.with(method.info.id);
    double worst = 0;
    const bool whole = observed(simulation, trial.steps(), 64,
                                [&](Simulation& s) { worst = std::max(worst, std::abs(s.energy_error()) / scale); });
    return whole ? number_cell(worst, least) : divergence_cell(simulation);
}

TableColumn energy_column(std::string head, const Trial& trial, double scale, double least) {
    return {std::move(head), [=](const Method& method) { return energy_cell(trial, method, scale, least); }};
}

TableColumn end_column(std::string head, const Trial& trial, const std::function<std::string(Simulation&)>& found) {
    return {std::move(head), [=](const Method& method) {
                Simulation simulation = trial.with(method.info.id);
                const bool whole = observed(simulation, trial.steps(), 1, [](Simulation&) {});
                return whole ? found(simulation) : divergence_cell(simulation);
            }};
}

plot::Curve curve_over_time(const Trial& trial, std::string_view method, std::size_t colour,
                            const std::function<double(const Simulation&)>& y, std::uint64_t moments) {
    plot::Curve curve{.name = std::string(method), .colour = colour, .marks = plot::Marks::never};
    Simulation simulation = trial.with(method);
    observed(simulation, trial.steps(), moments, [&](const Simulation& s) { curve.add(s.time(), y(s)); });
    return curve;
}

std::vector<plot::Curve> energy_curves_of(const Trial& trial, std::span<const std::string_view> methods, double scale) {
    std::vector<plot::Curve> curves;
    for (const std::string_view method : methods) {
        double worst = 0;
        const auto largest_so_far = [&](const Simulation& simulation) {
            return worst = std::max(worst, std::abs(simulation.energy_error()) / scale);
        };
        curves.push_back(curve_over_time(trial, method, curves.size(), largest_so_far));
    }
    return curves;
}

}  // namespace steplab
