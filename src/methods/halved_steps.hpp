#pragma once

namespace steplab {

/// Takes a step of length h by `attempt(h)`; where that finds no solution, as two halves, these halved in turn. An
/// attempt that fails changes nothing. False if steps of h / 2^20 fail too.
template <class T, class Attempt>
bool in_halves(T h, Attempt attempt, int halvings = 20) {
    if (attempt(h)) return true;
    if (halvings == 0) return false;
    return in_halves(h / T(2), attempt, halvings - 1) && in_halves(h / T(2), attempt, halvings - 1);
}

}  // namespace steplab
