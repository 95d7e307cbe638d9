#pragma once

#include "lab/report/table.hpp"
#include "plot/plot.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

struct Trial;

/// A scene, or a choice of steps, at which methods fail. docs/hard-cases.md shows its table and its diagram.
struct HardCase {
    std::string_view id;       ///< "stiff-rope": its section "hard case stiff-rope", its diagram hard-stiff-rope.svg
    std::string_view title;    ///< "Stiff ropes"
    std::string_view shows;    ///< the scene and the table, in a few sentences
    std::string_view caption;  ///< of the diagram
    Table (*table)();          ///< results of all methods of the catalogue, one row each. Throws Interrupted
    plot::Plot (*figure)();
    /// Runs of the table in which methods diverge; null where none does.
    std::vector<Trial> (*diverging)(const Method& method) = nullptr;
};

/// All of them, in the order of the page.
std::vector<HardCase> hard_cases();
/// The one with this id. Throws UsageError naming the nearest and the known ones.
HardCase hard_case(std::string_view id);

// The parts of the cases.

/// One run of a case, for any method.
struct Trial {
    RunDescription run;  ///< its method is ignored
    double time = 0;
    double tolerance = 1e-9;                                  ///< for adaptive methods
    bool compensated = false;                                 ///< for methods with compensated summation
    std::function<void(Simulation&)> prepare = [](auto&) {};  ///< changes before the first step

    Simulation with(std::string_view method) const;
    std::uint64_t steps() const { return steps_until(time, run.dt); }
};

/// The scene with these parameters, in double, with steps of dt over `time`.
using Settings = std::initializer_list<std::pair<std::string_view, double>>;
Trial trial(std::string_view model, Settings settings, double dt, double time);

using Observer = std::function<void(Simulation&)>;

/// Runs the steps of a trial and calls `observe` at `moments` evenly spaced times, the last one at its end. False if it
/// diverged.
bool observed(Simulation& simulation, std::uint64_t steps, std::uint64_t moments, const Observer& observe);

/// Largest stable omega dt of a method at its defaults, without drag: 0 = none, infinity = any.
double limit_of(const Method& method);
/// True if that limit is positive and finite, and the method is not adaptive.
bool has_limit(const Method& method);

/// A column of a table of methods.
struct TableColumn {
    std::string head;
    std::function<std::string(const Method&)> cell;
};

/// A table with a row for every method; cells say if a method cannot run the scene.
Table over_methods(std::span<const TableColumn> columns);

/// A number with two digits; below `least`, where rounding dominates, "< 1e-13".
std::string number_cell(double value, double least = 1e-13);
/// "blows up at t = 24".
std::string divergence_cell(const Simulation& simulation);

/// The largest |E - E0| over 64 samples, in units of `scale`.
std::string energy_cell(const Trial& trial, const Method& method, double scale = 1, double least = 1e-13);
/// The column of energy_cell().
TableColumn energy_column(std::string head, const Trial& trial, double scale = 1, double least = 1e-13);
/// The column of what `found` returns at the end of the run.
TableColumn end_column(std::string head, const Trial& trial, const std::function<std::string(Simulation&)>& found);

/// y of a run over time, at `moments` times; until it diverges.
plot::Curve curve_over_time(const Trial& trial, std::string_view method, std::size_t colour,
                            const std::function<double(const Simulation&)>& y, std::uint64_t moments = 200);
/// The running maximum of |E - E0| / scale over time, for several methods.
std::vector<plot::Curve> energy_curves_of(const Trial& trial, std::span<const std::string_view> methods,
                                          double scale = 1);

}  // namespace steplab
