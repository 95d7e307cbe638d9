#include "sim/ensemble/ensemble.hpp"

#include "core/team.hpp"
#include "sim/ensemble/lane_runs.hpp"
#include "sim/run/simulation_body.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace steplab {

namespace {

/// Runs that a thread takes at once: several groups of the widest registers.
constexpr std::size_t runs_at_once = 64;
/// Steps of a particle between two calls of the watch, about.
constexpr std::uint64_t steps_of_a_piece = std::uint64_t{1} << 21;

std::uint64_t piece(std::size_t particles) {
    return std::max<std::uint64_t>(1, steps_of_a_piece / std::max<std::size_t>(1, particles));
}

/// The energy error over some steps of a run, of which those after the last good one do not count.
class EnergyErrors {
public:
    void add(std::uint64_t step, double error) {
        if (step >= sure_from_ + steps_between_checks) {
            for (const auto& [at, size] : open_) sure_ = std::max(sure_, size);
            open_.clear();
            sure_from_ = step - step % steps_between_checks;
        }
        open_.emplace_back(step, std::abs(error));
    }
    double largest(std::uint64_t last_good) const {
        double largest = sure_;
        for (const auto& [at, size] : open_) largest = at <= last_good ? std::max(largest, size) : largest;
        return largest;
    }

private:
    double sure_ = 0;
    std::uint64_t sure_from_ = 0;  ///< a step at which the energy was judged
    std::vector<std::pair<std::uint64_t, double>> open_;
};

/// A run by itself.
EnsembleResult run_alone(const EnsembleRun& run, std::uint64_t every, Execution execution, const StepsDone& done) {
    execution.threads = 1;
    Simulation simulation(run.description, execution);
    simulation.end_at(run.end);
    if (run.with_errors) simulation.count_drag_work();
    const std::uint64_t steps = run.end.step;
    const double energy_start = simulation.energy();
    EnergyErrors errors;
    const std::uint64_t most = piece(simulation.particles());
    for (std::uint64_t at = 0; at < steps && !simulation.divergence();) {
        const std::uint64_t row = std::min(steps, at - at % every + every), to = std::min(row, at + most);
        simulation.advance(to - at);
        if (to == steps) simulation.conclude();
        if (to == row || simulation.divergence()) errors.add(simulation.step(), simulation.energy_error());
        done(to - at);
        at = to;
    }
    RunResult result = result_of(simulation, energy_start, errors.largest(simulation.step()));
    if (run.with_errors) result.error = error_at_end(simulation);
    return {.result = std::move(result)};
}

/// Hands out the runs to threads.
class Work {
public:
    Work(std::span<const EnsembleRun> runs, std::uint64_t every, const Execution& execution,
         const std::function<void(std::uint64_t)>& watch)
        : runs_(runs), every_(every), execution_(execution), watch_(watch), results_(runs.size()) {}

    std::vector<EnsembleResult> results() {
        const std::size_t count = (runs_.size() + runs_at_once - 1) / runs_at_once;
        const std::size_t most = execution_.threads > 0 ? execution_.threads : processors();
        Team(std::min(most, count)).share(count, [this](std::size_t i) {
            const std::size_t first = i * runs_at_once;
            compute(first, std::min(first + runs_at_once, runs_.size()));
        });
        return std::move(results_);
    }

private:
    void compute(std::size_t first, std::size_t end) {
        const StepsDone done = [this](std::uint64_t steps) { report(steps); };
        while (first < end) {
            const std::span<const EnsembleRun> left = runs_.subspan(first, end - first);
            const auto together = run_in_lanes(left, every_, execution_, done);
            for (std::size_t i = 0; i < std::max<std::size_t>(1, together.size()); ++i, ++first)
                results_[first] = i < together.size() && together[i]
                                      ? *together[i]
                                      : run_alone(runs_[first], every_, execution_, done);
        }
    }

    void report(std::uint64_t steps) {
        const std::lock_guard lock(mutex_);
        done_ += steps;
        if (watch_) watch_(done_);
    }

    std::span<const EnsembleRun> runs_;
    std::uint64_t every_;
    Execution execution_;
    const std::function<void(std::uint64_t)>& watch_;
    std::vector<EnsembleResult> results_;
    std::mutex mutex_;  ///< of what follows
    std::uint64_t done_ = 0;
};

}  // namespace

std::vector<EnsembleResult> run_ensemble(std::span<const EnsembleRun> runs, std::uint64_t every,
                                         const Execution& execution, const std::function<void(std::uint64_t)>& watch) {
    return Work(runs, every, execution, watch).results();
}

}  // namespace steplab
