#include "lab/hard_cases/ropes.hpp"

#include "lab/study/lyapunov.hpp"
#include "lab/study/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace steplab {

namespace {

// ---- stiff ropes

constexpr double stiff = 2e7;

/// Without drag, long enough for the end to whip round once.
Trial whip() { return trial("rope", {{"k", stiff}, {"c", 0}}, 0.01, 1.5); }
/// A heavy rope with drag, until its slowest motion has decayed to e^-27.
Trial settling() { return trial("rope", {{"k", stiff}, {"m", 30}, {"c", 90}}, 0.01, 18); }
/// A light rope with strong drag: its springs relax in a tenth of a millisecond, it sinks in a minute.
Trial sinking() { return trial("rope", {{"k", stiff}, {"m", 0.003}, {"c", 3}}, 0.01, 0.5); }

constexpr double whip_energy = 60;  // the energy that the rope gains from gravity when it falls by its length

/// The whip at 0.9 of the method's stability limit.
std::string own_step_cell(const Method& method) {
    if (!has_limit(method)) return "–";
    Trial trial = whip();
    trial.run.dt = 0.9 * stability_limit(with_method(trial.run, method.info.id))->limit;
    return energy_cell(trial, method, whip_energy, 1e-12);
}

double distance_from_rest(const Simulation& simulation) {
    return error_against(*resting_reference(simulation.description()), simulation.state().displacement);
}

/// The position of the free end of the rope.
Vec3 end_of(const Simulation& simulation) {
    const State<double>& state = simulation.state();
    return state.displacement.at(state.displacement.count() - 1);
}

TableColumn sinking_column() {
    Trial fine = sinking();
    fine.tolerance = 1e-13;
    Simulation accurate = fine.with("rkn-12-10");
    accurate.advance(fine.steps() - accurate.step());
    return end_column("overdamped, t = 0.5: error of the end [m]", sinking(),
                      [end = end_of(accurate)](Simulation& simulation) {
                          return number_cell(length(end_of(simulation) - end), 1e-11);
                      });
}

Table stiff_table() {
    const TableColumn columns[] = {
        energy_column("whip without drag, dt = 0.01: relative energy error", whip(), whip_energy, 1e-12),
        {"at 0.9 of the stability limit", own_step_cell},
        end_column("with drag, t = 18: distance from equilibrium [m]", settling(),
                   [](Simulation& simulation) { return number_cell(distance_from_rest(simulation), 1e-10); }),
        sinking_column()};
    return over_methods(columns);
}

plot::Plot stiff_figure() {
    plot::Plot figure{.x = {.name = "time", .unit = "s"},
                      .y = {.name = "distance from equilibrium", .unit = "m", .scale = plot::Scale::logarithmic}};
    for (const char* method : {"dop853", "tr-bdf2", "implicit-midpoint"})
        figure.curves.push_back(curve_over_time(settling(), method, figure.curves.size(), distance_from_rest));
    return figure;
}

// ---- chaos

const std::vector<double> chaos_times{2, 5, 10, 18};

Trial chaotic() {
    Trial trial = steplab::trial("rope", {{"c", 0}}, 0.005, chaos_times.back());
    trial.tolerance = 1e-11;
    return trial;
}

Reference chaos_reference(const std::vector<double>& times) {
    return reference(chaotic().run, times, {.most_particle_evaluations = 1e7});
}

/// The errors at the times of the reference.
std::vector<double> errors_at(const Method& method, const Reference& reference) {
    const Trial trial = chaotic();
    Simulation simulation = trial.with(method.info.id);
    std::vector<double> errors;
    for (const ReferenceMoment& moment : reference.moments) {
        simulation.advance(steps_until(moment.time, trial.run.dt) - simulation.step());
        if (simulation.divergence()) break;
        errors.push_back(error_against(moment, simulation.state().displacement));
    }
    return errors;
}

Table chaos_table() {
    const Reference right = chaos_reference(chaos_times);
    std::map<std::string_view, std::vector<double>> errors;
    for (const Method& method : methods()) errors[method.info.id] = errors_at(method, right);
    std::vector<TableColumn> columns;
    for (std::size_t i = 0; i < chaos_times.size(); ++i) {
        columns.push_back({fmt::format("error at t = {:g} [m]", chaos_times[i]), [i, &errors](const Method& method) {
                               const std::vector<double>& all = errors.at(method.info.id);
                               return i < all.size() ? number_cell(all[i], 1e-12) : "blew up";
                           }});
    }
    return over_methods(columns);
}

plot::Plot chaos_figure() {
    std::vector<double> times;
    for (int i = 1; i <= 30; ++i) times.push_back(0.6 * i);
    const Reference right = chaos_reference(times);
    plot::Plot figure{
        .x = {.name = "time", .unit = "s"},
        .y = {.name = "position error", .unit = "m", .scale = plot::Scale::logarithmic, .range = Range{1e-16, 100}}};
    const auto add = [&](std::string name, const std::vector<double>& values) {
        plot::Curve curve{.name = std::move(name), .colour = figure.curves.size(), .marks = plot::Marks::never};
        for (std::size_t i = 0; i < values.size(); ++i) curve.add(times[i], values[i]);
        figure.curves.push_back(std::move(curve));
    };
    for (const char* id : {"velocity-verlet", "pefrl", "srkn-11b", "rk4", "dop853", "gauss-16"})
        add(id, errors_at(method(id), right));
    const Plan scene = model("rope").plan(chaotic().run.scene);
    const double exponent = lyapunov_exponent(scene, model("rope").shape(chaotic().run.scene), times.back()).exponent;
    std::vector<double> growth, certain;
    for (std::size_t i = 0; i < times.size(); ++i) {
        growth.push_back(1e-16 * std::exp(exponent * times[i]));
        certain.push_back(right.moments[i].error);
    }
    add(fmt::format("e^({:.1f} t)", exponent), growth);
    figure.curves.back().line = plot::Line::dashed;
    add("error of the reference", certain);
    figure.curves.back().line = plot::Line::dashed;
    return figure;
}

}  // namespace

HardCase stiff_rope() {
    return {"stiff-rope",
            "Stiff ropes",
            "A rope of k = 2·10⁷ 1/s², whose fastest period is 0.7 ms, in steps of 10 ms, forty times "
            "the explicit limit: without drag, its end whipping; heavy, with drag, until it hangs at rest; "
            "light, and so overdamped that it sinks.",
            "A rope with k = 2e7 1/s² comes to rest: distance from the exact equilibrium",
            stiff_table,
            stiff_figure,
            [](const Method&) {
                return std::vector{whip(), settling(), sinking()};
            }};
}

HardCase chaos() {
    return {"chaos",
            "Chaos",
            "A rope that whips without drag: errors grow as e^(λt) until they are as large as the motion. "
            "Errors of positions against a reference solution, dt 0.005 s or tolerance 1e-11.",
            "A rope that whips without drag: errors grow as e^(λt)",
            chaos_table,
            chaos_figure};
}

}  // namespace steplab
