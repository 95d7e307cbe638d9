#include "lab/study/thesis.hpp"

#include "lab/report/page.hpp"
#include "lab/study/measurement.hpp"
#include "lab/study/study.hpp"
#include "models/forces/morse_pair.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace steplab {

namespace {

/// The values printed in the thesis for a method: table 1; table 2 for one and ten points; table 3 in float and double
/// [ms].
struct Published {
    const char *method, *printed_as;  ///< the correct formula, and that of the listing where it differs
    const char* table_1;
    double one_point, ten_points;
    double float_ms, double_ms;
};

constexpr Published published[] = {{"euler", "euler", "25.7906", 1.8, 0.9, 25.1, 31.1},
                                   {"verlet", "verlet-2008", "25.7907", 1.8, 0.9, 29.7, 31.4},
                                   {"midpoint", "midpoint", "25.8029", 0.3, 0.2, 60.8, 63.8},
                                   {"rk4", "rk4", "25.7862", 1.9, 1.4, 139.1, 157.6},
                                   {"stoermer", "stoermer-2008", "25.7906", 0.6, 0.6, 321.6, 328.5}};

constexpr double by_eye = 20;

RunDescription chain(std::string_view method, Precision precision, double dt) {
    RunDescription run = describe("chain", method);
    run.precision = precision;
    run.dt = dt;
    return run;
}

double tenth_particle(std::string_view method, Precision precision) {
    RunDescription run = chain(method, precision, 0.1);
    run.scene.set("L", 3);
    run.scene.set("v0", 1);
    Simulation simulation(run);
    simulation.advance(681);
    return simulation.frame().positions[9].x;
}

/// True if 1000 steps stay within twenty times the largest displacement of the exact motion. Neighbours stay apart at
/// all amplitudes that occur, so that the chain stays linear.
bool seems_stable(RunDescription run) {
    if (run.scene.contains("L")) run.scene.set("L", 1e6);
    Simulation simulation(run);
    const double largest = by_eye * run.scene["v0"];  // amplitude of one point: v0 / omega
    for (int observe = 0; observe < 1000 && !simulation.divergence(); ++observe) {
        simulation.advance(1);
        if (!(simulation.diagnostics().max_displacement < largest)) return false;
    }
    return !simulation.divergence();
}

std::string largest_dt(std::string_view model_id, std::string_view method) {
    double largest = 0;
    for (int tenths = 1; tenths <= 250; ++tenths) {
        RunDescription run = describe(model_id, method);
        run.dt = 0.1 * tenths;
        if (!seems_stable(run)) break;
        largest = run.dt;
    }
    return largest > 0 ? fmt::format("{:.1f}", largest) : "below 0.1";
}

std::string theory(std::string_view model_id, std::string_view method) {
    const auto limit = stability_limit(describe(model_id, method));
    return limit && limit->limit > 0 ? fmt::format("{:.5g}", limit->limit) : "0";
}

double milliseconds(std::string_view method, Precision precision, double dt) {
    double least = infinity;
    for (int round = 0; round < 20; ++round)
        least = std::min(least, 1e3 * stepping_seconds(chain(method, precision, dt), 1000));
    return least;
}

/// The largest usable dt of the method for ten points: 0.95 of its limit, or the value judged by eye.
double usable_dt(const Published& row) {
    const auto limit = stability_limit(describe("chain", row.method));
    return limit && limit->limit > 0 ? 0.95 * limit->limit : row.ten_points;
}

plot::Curve displacement_curve(const RunDescription& run, std::size_t particle, std::uint64_t steps, std::string name,
                               std::size_t colour) {
    plot::Curve curve{.name = std::move(name), .colour = colour, .marks = plot::Marks::never};
    Simulation simulation(run);
    const double rest = simulation.shape()->rest[particle].x;
    for (std::uint64_t i = 0; i <= steps && !simulation.divergence(); ++i) {
        curve.add(simulation.time(), simulation.frame().positions[particle].x - rest);
        simulation.advance(1);
    }
    return curve;
}

plot::Curve exact_curve(const RunDescription& run, std::size_t particle, double time) {
    plot::Curve curve{.name = "exact", .colour = 0, .line = plot::Line::dashed, .marks = plot::Marks::never};
    const auto exact = model_of(run).exact(run.scene);
    for (int i = 0; i <= 400; ++i) {
        const double t = time * i / 400;
        curve.add(t, exact->displacement(particle, t).x);
    }
    return curve;
}

double largest(const plot::Curve& curve) {
    double value = 0;
    for (const double y : curve.y) value = std::max(value, std::abs(y));
    return value;
}

/// The range of the chart is that of the exact motion: unstable curves leave it.
ThesisChart displacement_chart(std::string title, std::string_view model_id, Precision precision, double dt,
                               double time) {
    plot::Plot figure{.x = {.name = "time", .unit = "s"}, .y = {.name = "displacement", .unit = "m"}};
    const std::size_t particle = model_id == "chain" ? 9 : 1;
    std::size_t colour = 1;
    for (const Published& row : published) {
        RunDescription run = describe(model_id, row.method);
        run.dt = dt;
        run.precision = precision;
        figure.curves.push_back(
            displacement_curve(run, particle, static_cast<std::uint64_t>(time / dt), row.method, colour++));
    }
    figure.curves.push_back(exact_curve(describe(model_id, "rk4"), particle, time));
    const double range = 1.6 * largest(figure.curves.back());
    figure.y.range = Range{-range, range};
    return {std::move(title), std::move(figure)};
}

ThesisChart morse_chart() {
    plot::Plot figure{.x = {.name = "distance", .unit = "m"},
                      .y = {.name = "potential [J], force [N]"},
                      .curves = {{.name = "potential", .colour = 1, .marks = plot::Marks::never},
                                 {.name = "force", .colour = 2, .marks = plot::Marks::never}}};
    const double b = std::sqrt(0.5);
    const MorseConstants<double> morse{1, b, 2, 2 * b};
    for (int i = 0; i <= 200; ++i) {
        const double r = 1 + 9.0 * i / 200;
        figure.curves[0].add(r, morse_energy(morse, r));
        figure.curves[1].add(r, morse_pull(morse, Vector<double>{r, 0, 0}).x);
    }
    return {"Morse potential and force, D = 1, k = 1, r0 = 2", std::move(figure)};
}

constexpr const char* table_1_explained =
    "<p>Euler, Runge-Kutta 4 and midpoint agree in all printed digits. Verlet's 25.7907 is due to rounding of "
    "differences of absolute positions in float; with increments the same formula gives 25.7906. Störmer's 25.7906 is "
    "the result of a single substep; ten substeps, as elsewhere in the thesis, give 25.7862, and its listing, which "
    "uses an outdated acceleration, 25.7890.</p>\n";

constexpr const char* table_2_explained =
    "<p>In multiples of 0.1 s, for 1000 steps. By eye: the displacement stays within twenty times that of the exact "
    "motion. Limit: the stability limit of linear theory. The thesis stopped below the limits of Euler and Verlet, "
    "took the loss of amplitude of Runge-Kutta 4 for instability, and was misled by the mistake in its listing of "
    "Störmer. Midpoint is unstable at any dt; its values are judged by eye.</p>\n";

constexpr const char* table_3_explained =
    "<p>The thesis used a desktop computer of 2008; the speed-up is due to eighteen years of hardware, compilers that "
    "use SIMD registers, and a memory layout that allows it.</p>\n";

constexpr const char* table_4_explained =
    "<p>With its true stability limit Störmer, the most expensive method in the thesis, is as efficient as Verlet, of "
    "which it is composed.</p>\n";

constexpr const char* charts_explained =
    "<p>Displacement against time; the exact motion is dashed. A curve that leaves its chart has blown up. In the "
    "Morse chart, b = 0.7.</p>\n";

std::string section(const char* title, const char* explained, const Table& table) {
    return fmt::format("<h2>{}</h2>\n{}{}", title, explained, html(table));
}

}  // namespace

Table thesis_table_1() {
    Table table{{"method", "thesis, float", "float", "double", "as printed in 2008, float"}, {}};
    for (const Published& row : published) {
        const bool differs = std::string_view(row.method) != row.printed_as;
        table.rows.push_back({row.method, row.table_1,
                              fmt::format("{:.4f}", tenth_particle(row.method, Precision::float_)),
                              fmt::format("{:.10f}", tenth_particle(row.method, Precision::double_)),
                              differs ? fmt::format("{:.4f}", tenth_particle(row.printed_as, Precision::float_)) : ""});
    }
    return table;
}

Table thesis_table_2() {
    Table table{
        {"method", "thesis, one point", "by eye", "limit", "thesis, ten points", "by eye", "as printed", "limit"}, {}};
    for (const Published& row : published) {
        const bool differs = std::string_view(row.method) != row.printed_as;
        table.rows.push_back({row.method, fmt::format("{:.1f}", row.one_point), largest_dt("oscillator", row.method),
                              theory("oscillator", row.method), fmt::format("{:.1f}", row.ten_points),
                              largest_dt("chain", row.method), differs ? largest_dt("chain", row.printed_as) : "",
                              theory("chain", row.method)});
    }
    return table;
}

Table thesis_table_3() {
    Table table{{"method", "thesis, float [ms]", "float [ms]", "thesis, double [ms]", "double [ms]", "speed-up"}, {}};
    for (const Published& row : published) {
        const double in_float = milliseconds(row.method, Precision::float_, 0.1);
        const double in_double = milliseconds(row.method, Precision::double_, 0.1);
        table.rows.push_back({row.method, fmt::format("{:.1f}", row.float_ms), fmt::format("{:.4f}", in_float),
                              fmt::format("{:.1f}", row.double_ms), fmt::format("{:.4f}", in_double),
                              fmt::format("{:.0f}", row.double_ms / in_double)});
    }
    return table;
}

Table thesis_table_4() {
    Table table{{"method", "thesis: simulated time of 1000 steps [s]", "thesis: ms per simulated second",
                 "simulated time of 1000 steps [s]", "µs per simulated second"},
                {}};
    for (const Published& row : published) {
        const double dt = usable_dt(row), simulated = 1000 * dt;
        table.rows.push_back(
            {row.method, fmt::format("{:.0f}", 1000 * row.ten_points),
             fmt::format("{:.3f}", row.double_ms / (1000 * row.ten_points)), fmt::format("{:.0f}", simulated),
             fmt::format("{:.4f}", 1e3 * milliseconds(row.method, Precision::double_, dt) / simulated)});
    }
    return table;
}

std::vector<ThesisChart> thesis_charts() {
    std::vector<ThesisChart> charts;
    charts.push_back(displacement_chart("One oscillator, dt = 0.5", "oscillator", Precision::double_, 0.5, 30));
    charts.push_back(morse_chart());
    for (const double dt : {0.1, 0.5, 0.9}) {
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            charts.push_back(
                displacement_chart(fmt::format("The tenth particle of a chain, dt = {}, {}", dt, id(precision)),
                                   "chain", precision, dt, 60));
        }
    }
    return charts;
}

std::string thesis_page() {
    std::string page = page_head(
        "The thesis, recomputed",
        "The tables and charts of the thesis of 2008, compared with results of the correct formulas.", circumstances());
    page += section("Table 1: position [m] of the tenth particle after 681 steps of 0.1 s; exact 25.78620",
                    table_1_explained, thesis_table_1());
    page += section("Table 2: largest dt [s]", table_2_explained, thesis_table_2());
    page += section("Table 3: time for 1000 steps of ten points", table_3_explained, thesis_table_3());
    page += section("Table 4: cost at the largest dt of each method", table_4_explained, thesis_table_4());
    page += std::string("<h2>Charts</h2>\n") + charts_explained + "<div class=\"diagrams\">\n";
    for (const ThesisChart& chart : thesis_charts()) page += captioned(chart.title, chart.figure);
    return page + "</div>\n" + page_end;
}

}  // namespace steplab
