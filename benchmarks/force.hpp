#pragma once

#include "core/vec3.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace steplab::benchmark {

/// One of the forces of loops.hpp in the call shapes of the libraries.
template <class Loop>
struct Force {
    using Number = typename Loop::Number;
    using Numbers = std::vector<Number>;
    std::size_t n;
    Loop loop{};  ///< what it knows of the scene

    /// odeint's symplectic steppers: the rate of change of momentum.
    void operator()(const Numbers& x, Numbers& a) const { loop.accelerations(x.data(), a.data(), n); }
    /// odeint's velocity_verlet.
    void operator()(const Numbers& x, const Numbers&, Numbers& a, Number) const {
        loop.accelerations(x.data(), a.data(), n);
    }
    /// Positions and velocities in one vector.
    void operator()(const Numbers& state, Numbers& rate, Number) const { rates(state.data(), rate.data()); }
    void rates(const Number* state, Number* rate) const {
        std::copy(state + 3 * n, state + 6 * n, rate);
        loop.accelerations(state, rate + 3 * n, n);
    }
};

/// Points as a loop wants its numbers.
template <class Loop>
typename Force<Loop>::Numbers placed(const std::vector<Vec3>& points) {
    using Number = typename Loop::Number;
    const std::size_t count = points.size();
    typename Force<Loop>::Numbers numbers(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        numbers[Loop::place(count, i, 0)] = static_cast<Number>(points[i].x);
        numbers[Loop::place(count, i, 1)] = static_cast<Number>(points[i].y);
        numbers[Loop::place(count, i, 2)] = static_cast<Number>(points[i].z);
    }
    return numbers;
}

/// Positions and then velocities.
template <class Loop>
typename Force<Loop>::Numbers placed(const std::vector<Vec3>& positions, const std::vector<Vec3>& velocities) {
    auto both = placed<Loop>(positions);
    const auto v = placed<Loop>(velocities);
    both.insert(both.end(), v.begin(), v.end());
    return both;
}

}  // namespace steplab::benchmark
