#include "sim/run/confirmed_steps.hpp"

#include <algorithm>
#include <optional>

namespace steplab {

void ConfirmedSteps::advance(Simulation& simulation, std::uint64_t target) {
    const std::uint64_t last_check = target - target % simulation.check_interval();
    if (confirmed_ < last_check) {
        walks_.walk(simulation, last_check);
        confirmed_ = simulation.step();
    }
    if (confirmed_ < target && !simulation.divergence()) confirm(simulation, target);
    walks_.walk(simulation, target);
}

/// Runs ahead to the next check, and comes back unless the target is not reached or is the end itself.
void ConfirmedSteps::confirm(Simulation& simulation, std::uint64_t target) {
    const std::uint64_t interval = simulation.check_interval();
    const std::uint64_t next_check = std::min(end_, target - target % interval + interval);
    std::optional<Simulation::Snapshot> here;
    if (next_check > target) here = simulation.save();
    walks_.walk(simulation, next_check);
    if (next_check == end_) simulation.conclude();
    confirmed_ = simulation.step();
    if (here && confirmed_ > target) simulation.restore(*here);
}

}  // namespace steplab
