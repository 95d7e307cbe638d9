#include "lab/limits/remedy_trial.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// Particles and pairs of all evaluations: some tenths of a second.
constexpr double most_work = 5e7;
/// Moments at which the energy is measured.
constexpr std::uint64_t moments = 64;
/// A run that ended after some steps says little about how long another one has to last.
constexpr double fewest_tried_steps = 1000;
/// Of the energy at the start; a run that is further off shows another motion.
constexpr double most_energy_error = 0.1;

double energy_scale(const Diagnostics& start) { return start.kinetic + std::abs(start.potential); }

/// Steps that may be tried.
double affordable_steps(const RunDescription& run) {
    const Plan scene = plan_of(as_held(run));
    const double work = static_cast<double>(scene.reference.count) + 2 * interacting_pairs(scene);
    return std::max(static_cast<double>(moments),
                    most_work / (work * evaluations_per_step(method(run.method).info, run.method_parameters)));
}

/// To the end of the trial, measuring on the way.
void take(Simulation& trial, std::uint64_t steps, TriedRemedy& result) {
    const double scale = energy_scale(trial.diagnostics());
    const std::uint64_t before = trial.evaluations(), first = trial.step();
    const double energy = trial.energy_error();
    double largest = 0;
    result.from = trial.time();
    for (std::uint64_t i = 1; i <= moments && !trial.divergence(); ++i) {
        trial.advance(first + steps * i / moments - trial.step());
        trial.conclude();
        largest = std::max(largest, std::abs(trial.energy_error() - energy));
    }
    result.until = trial.time();
    if (trial.divergence()) return;
    result.cost = static_cast<double>(trial.evaluations() - before) / std::abs(result.until - result.from);
    if (!has_drag(result.run)) result.energy_error = scale > 0 ? largest / scale : 0;
    result.works = result.energy_error.value_or(0) <= most_energy_error;
}

}  // namespace

RemedyTrial::RemedyTrial(Simulation::Snapshot last, const RunDescription& run, double until, double cost)
    : last_(std::move(last)), run_(run), until_(until), cost_(cost) {}

TriedRemedy RemedyTrial::of(const RunDescription& remedy) const {
    TriedRemedy result{.run = remedy};
    const double wanted = std::max(std::ceil(1.25 * until_ / std::abs(remedy.dt)), fewest_tried_steps);
    const double affordable = affordable_steps(remedy);
    Simulation trial(remedy);
    if (wanted > affordable) {
        trial.begin(run_);
        trial.restore(last_);
        trial.change(remedy);
    }
    take(trial, static_cast<std::uint64_t>(std::min(wanted, affordable)), result);
    result.cost /= cost_;
    return result;
}

}  // namespace steplab
