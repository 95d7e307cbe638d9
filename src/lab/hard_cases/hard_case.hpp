#pragma once

#include "lab/report/figure.hpp"
#include "lab/report/table.hpp"
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

/// A scene, or a way of stepping, at which methods fail. docs/hard-cases.md shows its table and its diagram.
struct HardCase {
    std::string_view id;       ///< "stiff-rope": its section "hard case stiff-rope", its diagram hard-stiff-rope.svg
    std::string_view title;    ///< "Stiff ropes"
    std::string_view shows;    ///< what is run, and what the table holds: a few sentences
    std::string_view caption;  ///< of the diagram
    Table (*table)();          ///< what every method of the catalogue does: a row for each. Throws Interrupted
    Figure (*figure)();
};

/// All of them, in the order of the page.
std::vector<HardCase> hard_cases();
/// The one with this id. Throws UsageError naming the nearest and the known ones.
HardCase hard_case(std::string_view id);

// What the cases are made of.

/// One run of a case, whatever the method.
struct Trial {
    RunDescription run;  ///< its method does not matter
    double time = 0;
    double tolerance = 1e-9;                                  ///< of the methods that choose their steps
    bool compensated = false;                                 ///< of those that have compensated sums
    std::function<void(Simulation&)> prepare = [](auto&) {};  ///< what is changed before the first step

    Simulation with(std::string_view method) const;
    std::uint64_t steps() const { return steps_until(time, run.dt); }
};

/// The scene with these parameters, double, to be stepped by dt for some time.
using Settings = std::initializer_list<std::pair<std::string_view, double>>;
Trial trial(std::string_view model, Settings settings, double dt, double time);

using Observer = std::function<void(Simulation&)>;

/// Takes a run to this step, or to its last valid one. Throws Interrupted soon after a signal (check_interruption()).
void advance_to(Simulation& simulation, std::uint64_t step);

/// Takes a trial's steps and looks at `moments` evenly spaced moments, its end being the last. False if it diverged.
bool watched(Simulation& simulation, std::uint64_t steps, std::uint64_t moments, const Observer& observe);

/// Largest stable omega dt of a method at its defaults, without drag: 0 = none, infinity = any.
double limit_of(const Method& method);
/// True if there is such a number between the two, and the method does not choose its steps.
bool has_limit(const Method& method);

/// What a column shows of a method.
struct Column {
    std::string head;
    std::function<std::string(const Method&)> cell;
};

/// A row for every method; a method that refuses the scene says so.
Table over_methods(std::span<const Column> columns);

/// A number of two digits; what is below `least`, where rounding decides, as "< 1e-13".
std::string number_cell(double value, double least = 1e-13);
/// "blows up at t = 24".
std::string divergence_cell(const Simulation& simulation);

/// The largest |E - E0| over 64 moments, in units of `scale`.
std::string energy_cell(const Trial& trial, const Method& method, double scale = 1, double least = 1e-13);
/// The column of energy_cell().
Column energy_column(std::string head, const Trial& trial, double scale = 1, double least = 1e-13);
/// What is found at the end of the run.
Column end_column(std::string head, const Trial& trial, const std::function<std::string(Simulation&)>& found);

/// y of a run over time, at so many moments; to where it diverged.
Curve curve_over_time(const Trial& trial, std::string_view method, int colour,
                      const std::function<double(const Simulation&)>& y, std::uint64_t moments = 200);
/// The largest |E - E0| / scale so far, over time, of several methods.
std::vector<Curve> energy_curves_of(const Trial& trial, std::span<const std::string_view> methods, double scale = 1);

}  // namespace steplab
