#include "session/equal_cost.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Evaluations after which a measurement is long enough, and steps of dt at most.
constexpr std::uint64_t enough_evaluations = 2000, most_steps = 400;
/// Of the logarithm of the cost: a tolerance whose cost is within a hundredth is near enough.
constexpr double near_enough = 0.01;

/// 0 where it diverges.
double measured(const RunDescription& run) {
    Simulation simulation(run);
    const std::uint64_t at_start = simulation.evaluations();
    while (simulation.evaluations() < at_start + enough_evaluations && simulation.step() < most_steps &&
           !simulation.divergence())
        simulation.advance(1);
    if (simulation.divergence()) return 0;
    return static_cast<double>(simulation.evaluations() - at_start) / simulation.time();
}

/// By bisection of the decimal logarithm of what `set` sets: cost shrinks as it grows.
template <class Set>
RunDescription found_of_cost(RunDescription run, double cost, double fine, double coarse, Set set) {
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (fine + coarse);
        set(run, std::pow(10, middle));
        const double found = measured(run);
        if (std::abs(std::log(found / cost)) < near_enough) break;
        (found > cost ? fine : coarse) = middle;
    }
    return run;
}

RunDescription with_tolerance_of_cost(const RunDescription& run, double cost) {
    return found_of_cost(run, cost, -15, -1, [](RunDescription& tried, double tolerance) {
        tried.method_parameters.set("tolerance", tolerance);
    });
}

/// Solving takes fewer iterations the smaller dt is.
RunDescription with_dt_of_cost(const RunDescription& run, double cost) {
    const double guess = std::log10(run.dt);
    return found_of_cost(run, cost, guess - 1.5, guess + 1.5, [](RunDescription& tried, double dt) { tried.dt = dt; });
}

/// True if the evaluations of a step are known without taking it.
bool has_known_cost(const RunDescription& run) { return !chooses_its_steps(run) && !method(run.method).info.implicit; }

}  // namespace

double evaluations_per_second(const RunDescription& run) {
    if (!has_known_cost(run)) return measured(run);
    return evaluations_per_step(method(run.method).info, run.method_parameters) / std::abs(run.dt);
}

RunDescription at_equal_cost(const RunDescription& run, const RunDescription& other) {
    const double cost = evaluations_per_second(other);
    if (chooses_its_steps(run)) return with_tolerance_of_cost(run, cost);
    RunDescription equal = run;
    equal.dt = evaluations_per_step(method(run.method).info, run.method_parameters) / cost;
    return has_known_cost(run) ? equal : with_dt_of_cost(equal, cost);
}

}  // namespace steplab
