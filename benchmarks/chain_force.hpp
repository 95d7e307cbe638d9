#pragma once

#include "loops.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace steplab::benchmark {

// The default chain (k = m = 1, L = 2, particle 0 fixed, the last one kicked) as users of general integrators write it:
// positions in a vector of 3 n numbers. A Force offers each of the call shapes that odeint's steppers ask for.

constexpr double kick = 2;

/// The call shapes of odeint's steppers over one of the loops.
template <class T, class Loop>
struct ChainForce {
    using Numbers = std::vector<T>;
    std::size_t n;

    Numbers start_positions() const {
        Numbers x(3 * n);
        for (std::size_t i = 0; i < n; ++i) x[Loop::place(n, i, 0)] = static_cast<T>(spring_length) * static_cast<T>(i);
        return x;
    }
    Numbers start_velocities() const {
        Numbers v(3 * n);
        v[Loop::place(n, n - 1, 0)] = static_cast<T>(kick);
        return v;
    }

    /// Symplectic steppers: the rate of change of momentum.
    void operator()(const Numbers& x, Numbers& a) const { Loop::accelerations(x.data(), a.data(), n); }
    /// velocity_verlet.
    void operator()(const Numbers& x, const Numbers&, Numbers& a, T) const {
        Loop::accelerations(x.data(), a.data(), n);
    }
    /// Runge-Kutta steppers: positions and velocities in one vector.
    void operator()(const Numbers& state, Numbers& rate, T) const {
        std::copy(state.begin() + static_cast<std::ptrdiff_t>(3 * n), state.end(), rate.begin());
        Loop::accelerations(state.data(), rate.data() + 3 * n, n);
    }
};

template <class T>
using PlainForce = ChainForce<T, PlainChain<T>>;
template <class T>
using GatherForce = ChainForce<T, GatherChain<T>>;

}  // namespace steplab::benchmark
