#pragma once

#include "core/number.hpp"

#include <limits>

namespace steplab {

/// Over which distances the force between two particles changes.
template <class T>
struct PairRange {
    T r0;      ///< distance of the minimum of the potential
    T length;  ///< over which the force changes by a factor e, at most half of a cut-off
    T gain;    ///< square of the speed, relative to each other, that two particles gain on the way from afar to r0
    T cutoff = std::numeric_limits<T>::infinity();
    T period = T(0);  ///< of space; 0: none
};

/// Nearer to a cut-off than this a pair counts as on it: half of the digits, as what a step leaves out beyond it goes
/// with the square.
template <class T>
T cutoff_width(T cutoff) {
    return cutoff * square_root(std::numeric_limits<T>::epsilon()) / T(2);
}

}  // namespace steplab
