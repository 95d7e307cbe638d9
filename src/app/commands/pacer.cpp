#include "app/commands/pacer.hpp"

#include "io/interruption.hpp"

#include <algorithm>
#include <chrono>
#include <optional>

namespace steplab {

void Pacer::advance(Simulation& simulation, std::uint64_t target, Progress& progress) {
    const std::uint64_t last_check = target - target % simulation.check_interval();
    if (sure_until_ < last_check) {
        walk(simulation, last_check, progress);
        sure_until_ = simulation.step();
    }
    if (sure_until_ < target && !simulation.divergence()) make_sure(simulation, target, progress);
    walk(simulation, target, progress);
}

/// Runs ahead to the next check, and comes back unless the target is not reached or is the end itself.
void Pacer::make_sure(Simulation& simulation, std::uint64_t target, Progress& progress) {
    const std::uint64_t interval = simulation.check_interval();
    const std::uint64_t next_check = std::min(end_, target - target % interval + interval);
    std::optional<Simulation::Snapshot> here;
    if (next_check > target) here = simulation.save();
    walk(simulation, next_check, progress);
    if (next_check == end_) simulation.conclude();
    sure_until_ = simulation.step();
    if (here && sure_until_ > target) simulation.restore(*here);
}

void Pacer::walk(Simulation& simulation, std::uint64_t target, Progress& progress) {
    using Clock = std::chrono::steady_clock;
    while (simulation.step() < target && !simulation.divergence()) {
        const std::uint64_t steps = std::min(piece_, target - simulation.step());
        const auto begin = Clock::now();
        simulation.advance(steps);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (steps == piece_ && seconds < 0.01) piece_ *= 2;
        if (seconds > 0.04) piece_ = std::max<std::uint64_t>(1, piece_ / 2);
        check_interruption();
        progress.at(simulation.step());
    }
}

}  // namespace steplab
