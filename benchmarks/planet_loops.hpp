#pragma once

#include "loops.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace steplab::benchmark {

// The forces of planets as users of general integrators write them (loops.hpp).

/// Bodies that feel a fixed sun at 0 alone, G M = 1; the same in both layouts of numbers.
template <class Layout>
struct FixedSun : Layout {
    using T = typename Layout::Number;

    static void accelerations(const T* x, T* a, std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t p = Layout::place(n, i, 0), q = Layout::place(n, i, 1), r = Layout::place(n, i, 2);
            const T square = x[p] * x[p] + x[q] * x[q] + x[r] * x[r], f = T(-1) / (square * std::sqrt(square));
            a[p] = f * x[p], a[q] = f * x[q], a[r] = f * x[r];
        }
    }
};

/// The sun and five planets: how many there are is known to the compiler, as in a program written for them.
template <class T>
struct SixBodies {
    static constexpr std::size_t count = 6;
    std::array<T, count> strengths{};  ///< G m

    SixBodies() = default;
    explicit SixBodies(const std::vector<double>& numbers) {
        for (std::size_t i = 0; i < count; ++i) strengths[i] = static_cast<T>(numbers.at(i));
    }
};

template <class T>
struct PlainPlanets : PointsInARow<T>, SixBodies<T> {
    using SixBodies<T>::SixBodies;
    using SixBodies<T>::count;

    void accelerations(const T* x, T* a, std::size_t) const {
        std::fill(a, a + 3 * count, T(0));
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + 1; j < count; ++j) {
                const T *const p = x + 3 * i, *const q = x + 3 * j;
                const T dx = q[0] - p[0], dy = q[1] - p[1], dz = q[2] - p[2];
                const T square = dx * dx + dy * dy + dz * dz, f = T(1) / (square * std::sqrt(square));
                const T by_q = this->strengths[j] * f, by_p = this->strengths[i] * f;
                T *const ap = a + 3 * i, *const aq = a + 3 * j;
                ap[0] += by_q * dx, ap[1] += by_q * dy, ap[2] += by_q * dz;
                aq[0] -= by_p * dx, aq[1] -= by_p * dy, aq[2] -= by_p * dz;
            }
        }
    }
};

template <class T>
struct GatherPlanets : ComponentsInARow<T>, SixBodies<T> {
    using SixBodies<T>::SixBodies;
    using SixBodies<T>::count;

    void accelerations(const T* x, T* a, std::size_t) const {
        const T *const y = x + count, *const z = y + count;
        T *const ay = a + count, *const az = ay + count;
        std::fill(a, a + 3 * count, T(0));
        for (std::size_t j = 0; j < count; ++j) {
            const T strength = this->strengths[j];
            elementwise(count, [=](std::size_t i) {
                const T dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
                const T square = dx * dx + dy * dy + dz * dz;
                const T f = i == j ? T(0) : strength / (square * std::sqrt(square));
                a[i] += f * dx, ay[i] += f * dy, az[i] += f * dz;
            });
        }
    }
};

}  // namespace steplab::benchmark
