#pragma once

#include <cmath>

namespace steplab {

/// The whole number at or below x, at least `low` and at most `high` (low <= high); `low` for what is not a number. The
/// way from numbers that a run or a camera made to indices and counts: a plain cast of what is out of range is
/// undefined.
inline int clamped_floor(double x, int low, int high) {
    if (!(x > low)) return low;
    return x < high ? static_cast<int>(std::floor(x)) : high;
}

}  // namespace steplab
