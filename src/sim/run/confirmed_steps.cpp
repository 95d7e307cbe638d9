#include "sim/run/confirmed_steps.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace steplab {

void ConfirmedSteps::advance(Simulation& simulation, std::uint64_t target) {
    const std::uint64_t last_check = target - target % simulation.check_interval();
    if (confirmed_ < last_check) {
        walk(simulation, last_check);
        confirmed_ = simulation.step();
    }
    if (confirmed_ < target && !simulation.divergence()) confirm(simulation, target);
    walk(simulation, target);
}

/// Runs ahead to the next check, and comes back unless the target is not reached or is the end itself.
void ConfirmedSteps::confirm(Simulation& simulation, std::uint64_t target) {
    const std::uint64_t interval = simulation.check_interval();
    const std::uint64_t next_check = std::min(end_, target - target % interval + interval);
    std::optional<Simulation::Snapshot> here;
    if (next_check > target) here = simulation.save();
    walk(simulation, next_check);
    if (next_check == end_) simulation.conclude();
    confirmed_ = simulation.step();
    if (here && confirmed_ > target) simulation.restore(*here);
}

void ConfirmedSteps::walk(Simulation& simulation, std::uint64_t target) {
    using Clock = std::chrono::steady_clock;
    while (simulation.step() < target && !simulation.divergence()) {
        const std::uint64_t steps = std::min(piece_, target - simulation.step());
        const auto begin = Clock::now();
        simulation.advance(steps);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (steps == piece_ && seconds < 0.01) piece_ *= 2;
        if (seconds > 0.04) piece_ = std::max<std::uint64_t>(1, piece_ / 2);
        between_(simulation.step());
    }
}

}  // namespace steplab
