#pragma once

#include <cmath>

namespace steplab {

/// The larger absolute value; what is not a number stays so, where std::max would forget it.
inline double larger_magnitude(double largest, double value) {
    return std::isnan(largest) || std::abs(value) <= largest ? largest : std::abs(value);
}

}  // namespace steplab
