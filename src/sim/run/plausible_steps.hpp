#pragma once

#include "sim/run/short_walks.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <utility>

namespace steplab {

/// Takes a simulation from stop to stop, each of them to be shown. It goes forward, and takes no step twice as long as
/// the energies at the stops are possible. Where one is not, the next check decides (divergence.md), as in the window:
/// the run then stands at its last good step, or comes back to the stop. ConfirmedSteps is for rows that are written.
class PlausibleSteps {
public:
    /// `end`: the last stop, where the energy is judged whatever the grid of checks. What `between` throws ends
    /// advance().
    PlausibleSteps(std::uint64_t end, ShortWalks::Between between) : end_(end), walks_(std::move(between)) {}

    /// Up to `target` <= end, or to the last good step if the run diverges before.
    void advance(Simulation& simulation, std::uint64_t target);

    std::uint64_t end() const { return end_; }

private:
    void decide(Simulation& simulation);

    std::uint64_t end_;
    ShortWalks walks_;
    std::uint64_t decided_ = 0;  ///< every step up to here is known to be good
};

}  // namespace steplab
