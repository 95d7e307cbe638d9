#pragma once

#include "core/elementwise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace steplab::benchmark {

// The forces of three scenes as users of general integrators write them, k = m = 1: positions in 3 n numbers. Plain:
// points one after the other (x y z x y z ...), each spring or pair once. Gather: all x, all y, all z, each particle
// gathers what pulls at it: the way that compilers vectorise. `place` is where component c of particle i stands.

struct PointsInARow {
    static std::size_t place(std::size_t, std::size_t i, std::size_t c) { return 3 * i + c; }
};
struct ComponentsInARow {
    static std::size_t place(std::size_t n, std::size_t i, std::size_t c) { return c * n + i; }
};

/// Adds the pull of a spring of rest length `length` between points p and q to their accelerations.
template <class T>
void add_spring(const T* p, const T* q, T* ap, T* aq, T length) {
    const T dx = q[0] - p[0], dy = q[1] - p[1], dz = q[2] - p[2];
    const T r = std::sqrt(dx * dx + dy * dy + dz * dz), s = (r - length) / r;
    ap[0] += s * dx, ap[1] += s * dy, ap[2] += s * dz;
    aq[0] -= s * dx, aq[1] -= s * dy, aq[2] -= s * dz;
}

constexpr double spring_length = 2;

template <class T>
struct PlainChain : PointsInARow {
    static void accelerations(const T* x, T* a, std::size_t n) {
        std::fill(a, a + 3 * n, T(0));
        for (std::size_t i = 0; i + 1 < n; ++i)
            add_spring(x + 3 * i, x + 3 * i + 3, a + 3 * i, a + 3 * i + 3, T(spring_length));
        a[0] = a[1] = a[2] = T(0);
    }
};

template <class T>
struct GatherChain : ComponentsInARow {
    static void accelerations(const T* x, T* a, std::size_t n) {
        const T *const y = x + n, *const z = y + n;
        T *const ay = a + n, *const az = ay + n;
        const auto factor = [](T dx, T dy, T dz) {
            const T r = std::sqrt(dx * dx + dy * dy + dz * dz);
            return (r - T(spring_length)) / r;
        };
        elementwise(n - 2, [=](std::size_t k) {
            const std::size_t i = k + 1;
            const T fx = x[i + 1] - x[i], fy = y[i + 1] - y[i], fz = z[i + 1] - z[i];
            const T bx = x[i] - x[i - 1], by = y[i] - y[i - 1], bz = z[i] - z[i - 1];
            const T f = factor(fx, fy, fz), b = factor(bx, by, bz);
            a[i] = f * fx - b * bx;
            ay[i] = f * fy - b * by;
            az[i] = f * fz - b * bz;
        });
        const std::size_t l = n - 1;
        const T bx = x[l] - x[l - 1], by = y[l] - y[l - 1], bz = z[l] - z[l - 1], b = factor(bx, by, bz);
        a[l] = -b * bx, ay[l] = -b * by, az[l] = -b * bz;
        a[0] = ay[0] = az[0] = T(0);
    }
};

constexpr std::size_t mesh_dim = 10;
constexpr double diagonal_length = 2.8284271247461903;

inline bool on_border(std::size_t i) {
    const std::size_t row = i / mesh_dim, column = i % mesh_dim, last = mesh_dim - 1;
    return row == 0 || row == last || column == 0 || column == last;
}

struct PlainMesh : PointsInARow {
    static void accelerations(const double* x, double* a, std::size_t n) {
        std::fill(a, a + 3 * n, 0.0);
        const auto spring = [&](std::size_t p, std::size_t q, double length) {
            add_spring(x + 3 * p, x + 3 * q, a + 3 * p, a + 3 * q, length);
        };
        for (std::size_t p = 0; p < n; ++p) {
            const bool right = p % mesh_dim + 1 < mesh_dim, down = p + mesh_dim<n, left = p % mesh_dim> 0;
            if (right) spring(p, p + 1, spring_length);
            if (down) spring(p, p + mesh_dim, spring_length);
            if (down && right) spring(p, p + mesh_dim + 1, diagonal_length);
            if (down && left) spring(p, p + mesh_dim - 1, diagonal_length);
        }
        for (std::size_t p = 0; p < n; ++p) {
            if (on_border(p)) a[3 * p] = a[3 * p + 1] = a[3 * p + 2] = 0;
        }
    }
};

struct GatherMesh : ComponentsInARow {
    static void accelerations(const double* x, double* a, std::size_t n) {
        const double *const y = x + n, *const z = y + n;
        double *const ay = a + n, *const az = ay + n;
        std::fill(a, a + 3 * n, 0.0);
        for (std::size_t row = 1; row + 1 < mesh_dim; ++row) {
            elementwise(mesh_dim - 2, [=](std::size_t k) {
                const std::size_t i = row * mesh_dim + k + 1;
                double sx = 0, sy = 0, sz = 0;
                const auto pull = [&](std::size_t j, double length) {
                    const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
                    const double r = std::sqrt(dx * dx + dy * dy + dz * dz), s = (r - length) / r;
                    sx += s * dx, sy += s * dy, sz += s * dz;
                };
                pull(i - 1, spring_length), pull(i + 1, spring_length);
                pull(i - mesh_dim, spring_length), pull(i + mesh_dim, spring_length);
                pull(i - mesh_dim - 1, diagonal_length), pull(i - mesh_dim + 1, diagonal_length);
                pull(i + mesh_dim - 1, diagonal_length), pull(i + mesh_dim + 1, diagonal_length);
                a[i] = sx, ay[i] = sy, az[i] = sz;
            });
        }
    }
};

constexpr double morse_depth = 1, morse_b = 0.5, morse_r0 = 0.5;  // b = sqrt(k / (2 D)) with k = 0.5

/// Acceleration along d per unit of d.
inline double morse_factor(double dx, double dy, double dz) {
    const double r = std::sqrt(dx * dx + dy * dy + dz * dz), e = std::exp(-morse_b * (r - morse_r0));
    return -2 * morse_b * morse_depth * e * (1 - e) / r;
}

struct PlainMorse : PointsInARow {
    static void accelerations(const double* x, double* a, std::size_t n) {
        std::fill(a, a + 3 * n, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                const double *const p = x + 3 * i, *const q = x + 3 * j;
                const double dx = p[0] - q[0], dy = p[1] - q[1], dz = p[2] - q[2], f = morse_factor(dx, dy, dz);
                double *const ap = a + 3 * i, *const aq = a + 3 * j;
                ap[0] += f * dx, ap[1] += f * dy, ap[2] += f * dz;
                aq[0] -= f * dx, aq[1] -= f * dy, aq[2] -= f * dz;
            }
        }
    }
};

struct GatherMorse : ComponentsInARow {
    static void accelerations(const double* x, double* a, std::size_t n) {
        const double *const y = x + n, *const z = y + n;
        double *const ay = a + n, *const az = ay + n;
        std::fill(a, a + 3 * n, 0.0);
        for (std::size_t j = 0; j < n; ++j) {
            elementwise(n, [=](std::size_t i) {
                const double dx = x[i] - x[j], dy = y[i] - y[j], dz = z[i] - z[j];
                const double r = std::sqrt(dx * dx + dy * dy + dz * dz), e = std::exp(-morse_b * (r - morse_r0));
                const double f = i == j ? 0 : -2 * morse_b * morse_depth * e * (1 - e) / r;
                a[i] += f * dx, ay[i] += f * dy, az[i] += f * dz;
            });
        }
    }
};

}  // namespace steplab::benchmark
