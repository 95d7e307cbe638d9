#include "sim/run/short_walks.hpp"

#include <algorithm>
#include <chrono>

namespace steplab {

void ShortWalks::walk(Simulation& simulation, std::uint64_t target) {
    using Clock = std::chrono::steady_clock;
    while (simulation.step() < target && !simulation.divergence()) {
        const std::uint64_t steps = std::min(steps_, target - simulation.step());
        const auto begin = Clock::now();
        simulation.advance(steps);
        const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
        if (steps == steps_ && seconds < 0.01) steps_ *= 2;
        if (seconds > 0.04) steps_ = std::max<std::uint64_t>(1, steps_ / 2);
        between_(simulation.step());
    }
}

}  // namespace steplab
