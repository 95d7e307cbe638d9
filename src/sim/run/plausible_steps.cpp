#include "sim/run/plausible_steps.hpp"

#include <algorithm>

namespace steplab {

void PlausibleSteps::advance(Simulation& simulation, std::uint64_t target) {
    walks_.walk(simulation, target);
    if (target > decided_ && !simulation.divergence() && !simulation.is_plausible()) decide(simulation);
}

void PlausibleSteps::decide(Simulation& simulation) {
    const std::uint64_t step = simulation.step(), interval = simulation.check_interval();
    const std::uint64_t next_check = std::min(end_, step - step % interval + interval);
    const Simulation::Snapshot here = simulation.save();
    walks_.walk(simulation, next_check);
    if (next_check == end_) simulation.conclude();
    if (simulation.divergence()) return;
    decided_ = next_check;
    simulation.restore(here);
}

}  // namespace steplab
