#pragma once

#include "lab/study/measurement.hpp"

#include <algorithm>

namespace steplab {

/// Whether a series of increasingly expensive runs still gains accuracy: it does not when two more expensive runs were
/// no better than a cheaper one. Rounding then dominates, or the error of the reference. A run that costs no more than
/// the previous one does not count: methods that reduce a dt which is too large for them repeat the same run for a
/// while.
class GainWatch {
public:
    bool gains_no_more(const Measurement& last) {
        if (last.diverged()) return false;
        if (last.error <= 0.7 * best_) {
            useless_ = 0;
        } else if (static_cast<double>(last.result.evaluations) > 1.1 * evaluations_) {
            ++useless_;
        }
        best_ = std::min(best_, last.error);
        evaluations_ = static_cast<double>(last.result.evaluations);
        return useless_ >= 2;
    }

private:
    double best_ = infinity, evaluations_ = infinity;
    int useless_ = 0;
};

}  // namespace steplab
