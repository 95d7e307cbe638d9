#pragma once

#include "sim/run/run_description.hpp"

#include <optional>

namespace steplab {

/// How the steps of a run treat an oscillation x'' = -omega^2 x, from the matrix of one step.
struct Resolution {
    double steps_per_period = infinity;
    double amplification = 1;  ///< of the amplitude over one period: 1 if the method keeps it
    double error = 0;          ///< of the motion after one period, as part of its amplitude

    /// The amplitude stays within 1 % of itself over a period.
    bool keeps_motion() const;
    /// It keeps the motion, with an error below a tenth of the amplitude a period, and shows it in at least 4 steps.
    bool is_good() const;
};

/// Of the method and dt of this run. None where nothing oscillates, of a method that chooses its own steps, and of
/// those that demonstrate a mistake, whose steps are no linear map.
std::optional<Resolution> resolution(const RunDescription& run, double omega);

}  // namespace steplab
