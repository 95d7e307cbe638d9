#include "app/pacer.hpp"

#include "io/interruption.hpp"

#include <algorithm>
#include <chrono>

namespace steplab {

void Pacer::advance(Simulation& simulation, std::uint64_t target, Progress& progress) {
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
