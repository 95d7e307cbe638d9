#pragma once

#include "sim/run/short_walks.hpp"
#include "sim/run/simulation.hpp"

#include <cstdint>
#include <utility>

namespace steplab {

/// Takes a simulation from stop to stop so that every stop is confirmed: if the run diverges afterwards, its last good
/// step is there or later, so that no row that was written has to be taken back. Between two checks of the energy it
/// runs ahead to the next one and comes back.
class ConfirmedSteps {
public:
    /// `end`: the last step of the run, where its energy is judged whatever the grid of checks. What `between` throws
    /// ends advance().
    explicit ConfirmedSteps(
        std::uint64_t end, ShortWalks::Between between = [](std::uint64_t) {})
        : end_(end), walks_(std::move(between)) {}

    /// Up to `target` <= end, or to the last good step if the run diverges before.
    void advance(Simulation& simulation, std::uint64_t target);

private:
    void confirm(Simulation& simulation, std::uint64_t target);

    std::uint64_t end_;
    ShortWalks walks_;
    std::uint64_t confirmed_ = 0;  ///< every step up to here is known to be good
};

}  // namespace steplab
