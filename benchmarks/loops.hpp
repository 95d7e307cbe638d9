#pragma once

#include "core/elementwise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
// The C library's exp of whole vector registers, which its header offers under -ffast-math only. clang++ has it by its
// option -fveclib=libmvec.
extern "C" __attribute__((simd("notinbranch"))) double exp(double) noexcept;
extern "C" __attribute__((simd("notinbranch"))) float expf(float) noexcept;
#endif

namespace steplab::benchmark {

// The forces of three scenes as users of general integrators write them, k = m = 1: positions in 3 n numbers. Plain:
// points one after the other (x y z x y z ...), each spring or pair once. Gather: all x, all y, all z, each particle
// gathers what pulls at it: the way that compilers vectorise. `place` is where component c of particle i stands.

template <class T>
struct PointsInARow {
    using Number = T;
    static constexpr const char* way = "plain";
    static std::size_t place(std::size_t, std::size_t i, std::size_t c) { return 3 * i + c; }
};
template <class T>
struct ComponentsInARow {
    using Number = T;
    static constexpr const char* way = "gather";
    static std::size_t place(std::size_t n, std::size_t i, std::size_t c) { return c * n + i; }
};

constexpr double spring_length = 2;
constexpr double diagonal_length = 2.8284271247461903;

/// Acceleration by a spring of rest length `length`, along d per unit of d.
template <class T>
T spring_factor(T dx, T dy, T dz, T length) {
    const T r = std::sqrt(dx * dx + dy * dy + dz * dz);
    return (r - length) / r;
}

/// Adds f d to the acceleration ap and takes it off aq.
template <class T>
void add_pair(T f, T dx, T dy, T dz, T* ap, T* aq) {
    ap[0] += f * dx, ap[1] += f * dy, ap[2] += f * dz;
    aq[0] -= f * dx, aq[1] -= f * dy, aq[2] -= f * dz;
}

/// Adds the pull of a spring of rest length `length` between points p and q to their accelerations.
template <class T>
void add_spring(const T* p, const T* q, T* ap, T* aq, T length) {
    const T dx = q[0] - p[0], dy = q[1] - p[1], dz = q[2] - p[2];
    add_pair(spring_factor(dx, dy, dz, length), dx, dy, dz, ap, aq);
}

template <class T>
struct PlainChain : PointsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        std::fill(a, a + 3 * n, T(0));
        for (std::size_t i = 0; i + 1 < n; ++i)
            add_spring(x + 3 * i, x + 3 * i + 3, a + 3 * i, a + 3 * i + 3, T(spring_length));
        a[0] = a[1] = a[2] = T(0);
    }
};

template <class T>
struct GatherChain : ComponentsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        const T *const y = x + n, *const z = y + n;
        T *const ay = a + n, *const az = ay + n;
        elementwise(n - 2, [=](std::size_t k) {
            const std::size_t i = k + 1;
            const T fx = x[i + 1] - x[i], fy = y[i + 1] - y[i], fz = z[i + 1] - z[i];
            const T bx = x[i] - x[i - 1], by = y[i] - y[i - 1], bz = z[i] - z[i - 1];
            const T f = spring_factor(fx, fy, fz, T(spring_length)), b = spring_factor(bx, by, bz, T(spring_length));
            a[i] = f * fx - b * bx;
            ay[i] = f * fy - b * by;
            az[i] = f * fz - b * bz;
        });
        const std::size_t l = n - 1;
        const T bx = x[l] - x[l - 1], by = y[l] - y[l - 1], bz = z[l] - z[l - 1];
        const T b = spring_factor(bx, by, bz, T(spring_length));
        a[l] = -b * bx, ay[l] = -b * by, az[l] = -b * bz;
        a[0] = ay[0] = az[0] = T(0);
    }
};

/// Particles along the side of a square mesh of n.
inline std::size_t side_of(std::size_t n) {
    return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
}

template <class T>
struct PlainMesh : PointsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        std::fill(a, a + 3 * n, T(0));
        const std::size_t dim = side_of(n), last = dim - 1;
        const auto spring = [&](std::size_t p, std::size_t q, double length) {
            add_spring(x + 3 * p, x + 3 * q, a + 3 * p, a + 3 * q, T(length));
        };
        for (std::size_t row = 0; row < dim; ++row) {
            for (std::size_t column = 0; column < dim; ++column) {
                const std::size_t p = row * dim + column;
                if (column < last) spring(p, p + 1, spring_length);
                if (row == last) continue;
                spring(p, p + dim, spring_length);
                if (column < last) spring(p, p + dim + 1, diagonal_length);
                if (column > 0) spring(p, p + dim - 1, diagonal_length);
            }
        }
        const auto hold = [=](std::size_t p) { a[3 * p] = a[3 * p + 1] = a[3 * p + 2] = T(0); };
        for (std::size_t i = 0; i < dim; ++i) hold(i), hold(last * dim + i), hold(i * dim), hold(i * dim + last);
    }
};

template <class T>
struct GatherMesh : ComponentsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        const std::size_t dim = side_of(n);
        const T *const y = x + n, *const z = y + n;
        T *const ay = a + n, *const az = ay + n;
        for (T* const rows : {a, ay, az}) {
            std::fill(rows, rows + dim, T(0));
            std::fill(rows + n - dim, rows + n, T(0));
        }
        for (std::size_t row = 1; row + 1 < dim; ++row) {
            elementwise(dim - 2, [=](std::size_t k) {
                const std::size_t i = row * dim + k + 1;
                T sx = 0, sy = 0, sz = 0;
                const auto pull = [&](std::size_t j, double length) {
                    const T dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
                    const T s = spring_factor(dx, dy, dz, T(length));
                    sx += s * dx, sy += s * dy, sz += s * dz;
                };
                pull(i - 1, spring_length), pull(i + 1, spring_length);
                pull(i - dim, spring_length), pull(i + dim, spring_length);
                pull(i - dim - 1, diagonal_length), pull(i - dim + 1, diagonal_length);
                pull(i + dim - 1, diagonal_length), pull(i + dim + 1, diagonal_length);
                a[i] = sx, ay[i] = sy, az[i] = sz;
            });
            const std::size_t first = row * dim, last = first + dim - 1;
            a[first] = ay[first] = az[first] = a[last] = ay[last] = az[last] = T(0);
        }
    }
};

constexpr double morse_depth = 1, morse_b = 0.5, morse_r0 = 0.5;  // b = sqrt(k / (2 D)) with k = 0.5

inline double exponential(double u) { return ::exp(u); }
inline float exponential(float u) { return ::expf(u); }

struct MorseFactor {
    template <class T>
    static T of(T dx, T dy, T dz) {
        const T r = std::sqrt(dx * dx + dy * dy + dz * dz), e = exponential(T(-morse_b) * (r - T(morse_r0)));
        return T(-2 * morse_b * morse_depth) * e * (1 - e) / r;
    }
};

/// A force between all pairs, of which Factor::of(dx, dy, dz) is the acceleration along d per unit of d.
template <class T, class Factor>
struct PlainPairs : PointsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        std::fill(a, a + 3 * n, T(0));
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                const T *const p = x + 3 * i, *const q = x + 3 * j;
                const T dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2];
                add_pair(Factor::of(dx, dy, dz), dx, dy, dz, a + 3 * i, a + 3 * j);
            }
        }
    }
};

template <class T, class Factor>
struct GatherPairs : ComponentsInARow<T> {
    static void accelerations(const T* x, T* a, std::size_t n) {
        const T *const y = x + n, *const z = y + n;
        T *const ay = a + n, *const az = ay + n;
        std::fill(a, a + 3 * n, T(0));
        for (std::size_t j = 0; j < n; ++j) {
            elementwise(n, [=](std::size_t i) {
                const T dx = x[i] - x[j], dy = y[i] - y[j], dz = z[i] - z[j];
                const T f = i == j ? T(0) : Factor::of(dx, dy, dz);
                a[i] += f * dx, ay[i] += f * dy, az[i] += f * dz;
            });
        }
    }
};

template <class T>
using PlainMorse = PlainPairs<T, MorseFactor>;
template <class T>
using GatherMorse = GatherPairs<T, MorseFactor>;

}  // namespace steplab::benchmark
