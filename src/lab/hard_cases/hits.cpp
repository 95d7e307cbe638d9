#include "lab/hard_cases/hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

constexpr std::string_view of_each_kind[] = {"velocity-verlet", "pefrl",  "srkn-11b",  "rk4",
                                             "dopri5",          "dop853", "rkn-12-10", "gauss-16"};

plot::Plot energy_figure(const Trial& trial, double scale = 1) {
    return {.x = {.name = "time", .unit = "s"},
            .y = {.name = "maximum |energy error| up to this time", .unit = "J", .scale = plot::Scale::logarithmic},
            .curves = energy_curves_of(trial, of_each_kind, scale)};
}

std::string collisions_cell(Simulation& simulation) {
    const CollisionRecord record = simulation.collisions();
    if (record.count() == 0) return "–";
    return fmt::format("{}, first at t = {:.4g}", record.count(), record.kept().front().time);
}

std::string evaluations_cell(Simulation& simulation) {
    return fmt::format("{:.2g}", static_cast<double>(simulation.evaluations()));
}

std::string error_cell(Simulation& simulation) {
    const auto error = simulation.diagnostics().error;
    return error ? number_cell(*error) : "unknown";
}

plot::Curve error_curve(const Trial& trial, std::string_view method, std::size_t colour) {
    return curve_over_time(trial, method, colour, [](const Simulation& simulation) {
        return std::max(1e-15, simulation.diagnostics().error.value_or(0));
    });
}

plot::Plot error_figure(const Trial& trial) {
    plot::Plot figure{.x = {.name = "time", .unit = "s"},
                      .y = {.name = "position error", .unit = "m", .scale = plot::Scale::logarithmic}};
    for (const std::string_view method : of_each_kind)
        figure.curves.push_back(error_curve(trial, method, figure.curves.size()));
    return figure;
}

// ---- neighbours that pass each other

Trial passing(double dt) { return trial("chain", {{"n", 3}, {"L", 1}, {"v0", 5}}, dt, 10); }

Table passing_table() {
    const TableColumn columns[] = {energy_column("dt = 0.01: energy error [J]", passing(0.01)),
                                   energy_column("dt = 0.001", passing(0.001)),
                                   end_column("collisions found", passing(0.01), collisions_cell)};
    return over_methods(columns);
}

// ---- a mesh that folds

Trial folding() { return trial("mesh", {{"v0", 40}}, 0.02, 7); }

/// Number of reversed springs of the mesh.
std::size_t reversed_springs(const Simulation& simulation) {
    const Frame frame = simulation.frame();
    const auto& springs = frame.shape->springs;
    return static_cast<std::size_t>(std::count_if(springs.begin(), springs.end(), [&](const auto& spring) {
        const Vec3 rest = frame.shape->rest[spring.second] - frame.shape->rest[spring.first];
        return dot(rest, frame.positions[spring.second] - frame.positions[spring.first]) < 0;
    }));
}

Table folding_table() {
    const auto most_reversed = [](const Method& method) {
        const Trial trial = folding();
        Simulation simulation = trial.with(method.info.id);
        std::size_t most = 0;
        observed(simulation, trial.steps(), 100, [&](Simulation& s) { most = std::max(most, reversed_springs(s)); });
        return std::to_string(most);
    };
    Trial fine = folding();
    fine.run.dt /= 4;
    fine.tolerance = 1e-12;
    const TableColumn columns[] = {{"largest number of reversed springs", most_reversed},
                                   energy_column("dt = 0.02, tolerance 1e-9: energy error [J]", folding()),
                                   energy_column("dt = 0.005, tolerance 1e-12", fine)};
    return over_methods(columns);
}

// ---- grazing hits

Trial grazing(double aside) {
    Trial hit = trial("morse", {{"edge", 1}, {"v0", 1}}, 0.01, 20);
    hit.prepare = [aside](Simulation& simulation) {
        if (aside > 0) simulation.act(Pull{0, {0, aside, 0}});
    };
    return hit;
}

Table grazing_table() {
    std::vector<TableColumn> columns;
    for (const double aside : {0.3, 1e-2, 1e-4, 1e-9, 0.0}) {
        columns.push_back(energy_column(
            aside > 0 ? fmt::format("impact parameter {:g}: energy error [J]", aside) : "head on", grazing(aside)));
    }
    return over_methods(columns);
}

plot::Plot grazing_figure() {
    plot::Plot figure{.x = {.name = "impact parameter", .unit = "m", .scale = plot::Scale::logarithmic},
                      .y = {.name = "largest |energy error|", .unit = "J", .scale = plot::Scale::logarithmic}};
    for (const std::string_view method : of_each_kind) {
        plot::Curve curve{.name = std::string(method), .colour = figure.curves.size()};
        for (double aside = 1; aside > 1e-7; aside /= 10) {
            const plot::Curve energy = energy_curves_of(grazing(aside), std::span(&method, 1)).front();
            curve.add(aside, std::max(1e-16, energy.y.back()));
        }
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

// ---- the threshold of escape

/// Kinetic energy equal to the depth of the potential at the start: the particles repel each other and separate for
/// ever, with velocities that tend to zero.
Trial escape(Precision precision) {
    constexpr double r0 = 4, b = 0.5;  // k = 0.5, D = 1
    const double e = std::exp(-b * (10 - r0));
    Trial trial = steplab::trial("morse", {{"edge", 1}, {"r0", r0}, {"v0", std::sqrt(4 * e * (2 - e))}}, 0.1, 2000);
    trial.run.precision = precision;
    trial.tolerance = precision == Precision::float_ ? 1e-6 : 1e-9;
    return trial;
}

double separation(const Simulation& simulation) {
    const State<double>& state = simulation.state();
    return length(state.displacement.at(0) - state.displacement.at(1));
}

/// Their final distance, and whether they have turned back.
TableColumn fate_column(std::string head, const Trial& trial) {
    return {std::move(head), [trial](const Method& method) {
                Simulation simulation = trial.with(method.info.id);
                double farthest = 0;
                const bool whole = observed(simulation, trial.steps(), 500, [&](const Simulation& s) {
                    if (s.time() > 20) farthest = std::max(farthest, separation(s));
                });
                if (!whole) return divergence_cell(simulation);
                const bool back = separation(simulation) < 0.999 * farthest;
                return fmt::format("{:.3g}{}", separation(simulation), back ? ", turned back" : "");
            }};
}

Table escape_table() {
    const Trial in_double = escape(Precision::double_);
    const TableColumn columns[] = {
        fate_column("distance at t = 2000", in_double), end_column("error [m]", in_double, error_cell),
        energy_column("energy error / D", in_double), fate_column("distance in float", escape(Precision::float_))};
    return over_methods(columns);
}

plot::Plot escape_figure() {
    plot::Plot figure{.x = {.name = "time", .unit = "s"},
                      .y = {.name = "distance of the particles", .unit = "m", .range = Range{0, 45}}};
    const auto add = [&](Precision precision, std::string_view method) {
        const bool in_float = precision == Precision::float_;
        plot::Curve curve = curve_over_time(escape(precision), method, figure.curves.size(), separation, 200);
        if (in_float) curve.name += ", float";
        curve.line = plot::dashed_if(in_float);
        figure.curves.push_back(std::move(curve));
    };
    for (const std::string_view method : {"gauss-16", "velocity-verlet", "rk4", "implicit-midpoint", "tr-bdf2"})
        add(Precision::double_, method);
    for (const std::string_view method : {"srkn-11b", "rk4", "taylor"}) add(Precision::float_, method);
    return figure;
}

// ---- deep repulsion

constexpr double deep = 1000;

/// Two hard cores (b = 5) that collide with 1000 times the depth of the well.
Trial deep_hit(double dt) {
    return trial("morse", {{"edge", 1}, {"k", 50}, {"r0", 2}, {"v0", std::sqrt(4 * deep)}}, dt, 0.3);
}

Table deep_table() {
    const TableColumn columns[] = {energy_column("dt = 0.0005: energy error / 1000 D", deep_hit(5e-4), deep),
                                   end_column("error at the end [m]", deep_hit(5e-4), error_cell),
                                   energy_column("dt = 0.01: energy error / 1000 D", deep_hit(0.01), deep),
                                   end_column("error at the end [m]", deep_hit(0.01), error_cell)};
    return over_methods(columns);
}

// ---- the cube that collides

Trial cube() {
    Trial trial = steplab::trial("morse", {{"v0", 1.5}}, 0.01, 2.5);
    trial.tolerance = 1e-10;
    return trial;
}

Table cube_table() {
    const TableColumn columns[] = {energy_column("energy error [J]", cube()),
                                   end_column("force evaluations", cube(), evaluations_cell),
                                   end_column("collisions found", cube(), collisions_cell)};
    return over_methods(columns);
}

// ---- at the same position

/// Two particles that start at the same position; or the eight of a cube, so close that they differ only in the last
/// digits.
Trial same_position() {
    Trial trial = steplab::trial("morse", {{"edge", 1}}, 0.01, 2);
    trial.prepare = [](Simulation& simulation) { simulation.act(Pull{0, simulation.frame().positions[1]}); };
    return trial;
}
Trial nearly_coincident(double spacing) {
    return steplab::trial("morse", {{"edge", 2}, {"spacing", spacing}}, 0.01, 2);
}

Table coincident_table() {
    const TableColumn columns[] = {energy_column("two at the same position: energy error [J]", same_position()),
                                   energy_column("eight 1e-3 apart", nearly_coincident(1e-3)),
                                   energy_column("eight 1e-9 apart", nearly_coincident(1e-9))};
    return over_methods(columns);
}

}  // namespace

HardCase passing_neighbours() {
    return {"passing",
            "Passing neighbours",
            "A chain of three particles, kicked with v0 = 5 m/s: where neighbours meet at distance 0, the "
            "direction of their force jumps. Adaptive methods locate these collisions and restart behind "
            "them, fixed steps do not.",
            "A chain of three particles with a hard kick: energy error; neighbours pass each other at t = 4.9 and 6.0",
            passing_table,
            [] { return energy_figure(passing(0.01)); }};
}

HardCase folding_mesh() {
    return {"folding",
            "Folding mesh",
            "A mesh whose centre is kicked across it with v0 = 40 m/s, an energy of 800 J: springs turn "
            "over, some through distance 0.",
            "A mesh that folds: energy error",
            folding_table,
            [] { return energy_figure(folding()); }};
}

HardCase grazing_hits() {
    return {"grazing",
            "Grazing and head-on collisions",
            "A bullet passes a Morse particle with an impact parameter in m, dt 0.01 s: the smaller it is, the shorter "
            "the time in which the force turns.",
            "Two particles that pass each other at t = 9: energy error against impact parameter",
            grazing_table,
            grazing_figure};
}

HardCase escape_threshold() {
    return {"escape",
            "Escape threshold",
            "Two Morse particles with exactly the escape energy separate ever more slowly, dt 0.1 s. An "
            "energy error of 1e-5 D is enough to make them return.",
            "Distance of two particles with exactly the escape energy (dashed: float)",
            escape_table,
            escape_figure};
}

HardCase deep_repulsion() {
    return {"deep",
            "Hard collision",
            "Two particles with hard cores (b = 5 1/m) collide with an energy of 1000 D; the force turns "
            "them within 0.003 s.",
            "Position error in a collision with 1000 times the depth of the well, dt = 0.0005",
            deep_table,
            [] { return error_figure(deep_hit(5e-4)); },
            [](const Method&) { return std::vector{deep_hit(0.01)}; }};
}

HardCase colliding_cube() {
    return {"cube",
            "Colliding cube",
            "27 Morse particles in a cube of spacing 0.5 m: mirror-image pairs meet head-on, first at t = "
            "0.938 s. Until t = 2.5 s, dt 0.01 s or tolerance 1e-10.",
            "The Morse cube with spacing 0.5, in which particles collide from t = 0.94 on: energy error",
            cube_table,
            [] { return energy_figure(cube()); }};
}

HardCase coincident_particles() {
    return {"coincident",
            "Coincident particles",
            "The force between coincident particles is zero. Two Morse particles that start at the same "
            "position, and eight so close together that only their last digits differ.",
            "Eight Morse particles that start 1e-9 apart: energy error",
            coincident_table,
            [] { return energy_figure(nearly_coincident(1e-9)); }};
}

}  // namespace steplab
