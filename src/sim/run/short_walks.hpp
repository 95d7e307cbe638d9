#pragma once

#include "sim/run/simulation.hpp"

#include <cstdint>
#include <functional>
#include <utility>

namespace steplab {

/// Takes a simulation forward in pieces of some hundredths of a second.
class ShortWalks {
public:
    /// Called with the step reached after each of them; what it throws ends walk().
    using Between = std::function<void(std::uint64_t)>;

    explicit ShortWalks(Between between) : between_(std::move(between)) {}

    /// Up to this step, or until the run diverges.
    void walk(Simulation& simulation, std::uint64_t target);

private:
    Between between_;
    std::uint64_t steps_ = 1;  ///< of a piece
};

}  // namespace steplab
