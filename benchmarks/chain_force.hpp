#pragma once

#include "core/elementwise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace steplab::benchmark {

// The default chain (k = m = 1, L = 2, particle 0 fixed, the last one kicked) as users of general integrators write it:
// positions in a vector of 3 n numbers. A Force offers each of the call shapes that odeint's steppers ask for.

constexpr double rest_length = 2;
constexpr double kick = 2;

/// Points one after the other (x y z x y z ...), each spring once: the straightforward way.
template <class T>
struct PlainLoop {
    static std::size_t x_of(std::size_t, std::size_t i) { return 3 * i; }

    static void accelerations(const T* x, T* a, std::size_t n) {
        std::fill(a, a + 3 * n, T(0));
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const T *const p = x + 3 * i, *const q = p + 3;
            const T dx = q[0] - p[0], dy = q[1] - p[1], dz = q[2] - p[2];
            const T r = std::sqrt(dx * dx + dy * dy + dz * dz);
            const T s = (r - T(rest_length)) / r;
            T *const ap = a + 3 * i, *const aq = ap + 3;
            ap[0] += s * dx, ap[1] += s * dy, ap[2] += s * dz;
            aq[0] -= s * dx, aq[1] -= s * dy, aq[2] -= s * dz;
        }
        a[0] = a[1] = a[2] = T(0);
    }
};

/// All x, all y, all z; each particle gathers the pulls of both its springs: the way that compilers vectorise.
template <class T>
struct GatherLoop {
    static std::size_t x_of(std::size_t, std::size_t i) { return i; }

    static void accelerations(const T* x, T* a, std::size_t n) {
        const T *const y = x + n, *const z = y + n;
        T *const ax = a, *const ay = a + n, *const az = ay + n;
        const auto factor = [](T dx, T dy, T dz) {
            const T r = std::sqrt(dx * dx + dy * dy + dz * dz);
            return (r - T(rest_length)) / r;
        };
        elementwise(n - 2, [=](std::size_t k) {
            const std::size_t i = k + 1;
            const T fx = x[i + 1] - x[i], fy = y[i + 1] - y[i], fz = z[i + 1] - z[i];
            const T bx = x[i] - x[i - 1], by = y[i] - y[i - 1], bz = z[i] - z[i - 1];
            const T f = factor(fx, fy, fz), b = factor(bx, by, bz);
            ax[i] = f * fx - b * bx;
            ay[i] = f * fy - b * by;
            az[i] = f * fz - b * bz;
        });
        const std::size_t l = n - 1;
        const T bx = x[l] - x[l - 1], by = y[l] - y[l - 1], bz = z[l] - z[l - 1], b = factor(bx, by, bz);
        ax[l] = -b * bx, ay[l] = -b * by, az[l] = -b * bz;
        ax[0] = ay[0] = az[0] = T(0);
    }
};

/// The call shapes of odeint's steppers over one of the loops.
template <class T, class Loop>
struct ChainForce {
    using Numbers = std::vector<T>;
    std::size_t n;

    Numbers start_positions() const {
        Numbers x(3 * n);
        for (std::size_t i = 0; i < n; ++i) x[Loop::x_of(n, i)] = static_cast<T>(rest_length) * static_cast<T>(i);
        return x;
    }
    Numbers start_velocities() const {
        Numbers v(3 * n);
        v[Loop::x_of(n, n - 1)] = static_cast<T>(kick);
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
using PlainForce = ChainForce<T, PlainLoop<T>>;
template <class T>
using GatherForce = ChainForce<T, GatherLoop<T>>;

}  // namespace steplab::benchmark
