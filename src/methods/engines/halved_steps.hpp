#pragma once

#include "core/field.hpp"

#include <limits>

namespace steplab {

/// Takes a step of length h by `attempt(h)`; where that finds no solution, as two halves, these halved in turn. An
/// attempt that fails changes nothing. False if steps of h / 2^20 fail too.
template <class T, class Attempt>
bool in_halves(T h, Attempt attempt, int halvings = 20) {
    if (attempt(h)) return true;
    if (halvings == 0) return false;
    return in_halves(h / T(2), attempt, halvings - 1) && in_halves(h / T(2), attempt, halvings - 1);
}

/// The same for a step of dt, whose velocities are `v`: where no solution is found, the run has diverged.
template <class T, class Attempt>
void step_in_halves(T dt, Field<T>& v, Attempt attempt) {
    if (!in_halves(dt, attempt)) v.flat()[0] = std::numeric_limits<T>::quiet_NaN();
}

}  // namespace steplab
