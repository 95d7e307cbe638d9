#pragma once

#include "loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace steplab::benchmark {

// The forces of composed scenes as users of general integrators write them (loops.hpp).

/// A spring of a network.
struct Join {
    std::uint32_t first, second;
    double length;
};

/// A network of springs, k = m = 1, each spring once.
template <class T>
struct Network : PointsInARow<T> {
    struct Spring {
        std::uint32_t first, second;
        T length;
    };
    Network() = default;
    explicit Network(const std::shared_ptr<const std::vector<Join>>& joins) {
        auto all = std::make_shared<std::vector<Spring>>();
        if (joins) {
            for (const Join& join : *joins) all->push_back({join.first, join.second, static_cast<T>(join.length)});
        }
        springs = std::move(all);
    }
    void accelerations(const T* x, T* a, std::size_t n) const {
        std::fill(a, a + 3 * n, T(0));
        for (const Spring& spring : *springs) {
            const std::size_t p = 3 * std::size_t(spring.first), q = 3 * std::size_t(spring.second);
            add_spring(x + p, x + q, a + p, a + q, spring.length);
        }
    }
    std::shared_ptr<const std::vector<Spring>> springs;
};

/// Lennard-Jones in a cubic box up to 2.5, shifted to zero there together with its slope, epsilon = sigma = m = 1: each
/// pair once, by lists of neighbours that reach 0.3 farther and are renewed when somebody has gone half of it.
template <class T>
class Liquid : public PointsInARow<T> {
public:
    Liquid() = default;
    explicit Liquid(double box) : box_(static_cast<T>(box)), state_(std::make_shared<Lists>()) {}

    void accelerations(const T* x, T* a, std::size_t n) const {
        if (has_moved(x, n)) make_lists(x, n);
        std::fill(a, a + 3 * n, T(0));
        const T cutoff2 = cutoff * cutoff, there = force_by_distance(cutoff2) * cutoff;
        for (std::size_t i = 0; i < n; ++i) {
            T sx = 0, sy = 0, sz = 0;
            for (std::size_t k = state_->begin[i]; k < state_->begin[i + 1]; ++k) {
                const std::size_t j = state_->others[k];
                const T dx = nearest(x[3 * i] - x[3 * j]), dy = nearest(x[3 * i + 1] - x[3 * j + 1]),
                        dz = nearest(x[3 * i + 2] - x[3 * j + 2]);
                const T r2 = dx * dx + dy * dy + dz * dz;
                if (r2 >= cutoff2) continue;
                const T f = force_by_distance(r2) - there / std::sqrt(r2);
                sx += f * dx, sy += f * dy, sz += f * dz;
                a[3 * j] -= f * dx, a[3 * j + 1] -= f * dy, a[3 * j + 2] -= f * dz;
            }
            a[3 * i] += sx, a[3 * i + 1] += sy, a[3 * i + 2] += sz;
        }
    }

private:
    static constexpr T cutoff = T(2.5), skin = T(0.3);
    struct Lists {
        std::vector<T> made_at;
        std::vector<std::size_t> begin;
        std::vector<std::uint32_t> others;
    };

    static T force_by_distance(T r2) {
        const T inverse = 1 / r2, s6 = inverse * inverse * inverse;
        return 24 * s6 * (2 * s6 - 1) * inverse;
    }
    T nearest(T d) const {
        const T half = box_ / 2;
        return d > half ? d - box_ : d < -half ? d + box_ : d;
    }

    bool has_moved(const T* x, std::size_t n) const {
        if (state_->made_at.size() != 3 * n) return true;
        for (std::size_t i = 0; i < n; ++i) {
            T square = 0;
            for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
                square += (x[c] - state_->made_at[c]) * (x[c] - state_->made_at[c]);
            if (square > skin * skin / 4) return true;
        }
        return false;
    }

    void make_lists(const T* x, std::size_t n) const {
        const auto side = static_cast<std::size_t>(box_ / (cutoff + skin));
        const auto cell = [&](T at) {
            const T within = at - box_ * std::floor(at / box_);
            return std::min(static_cast<std::size_t>(within / box_ * static_cast<T>(side)), side - 1);
        };
        std::vector<std::vector<std::uint32_t>> cells(side * side * side);
        for (std::size_t i = 0; i < n; ++i)
            cells[(cell(x[3 * i]) * side + cell(x[3 * i + 1])) * side + cell(x[3 * i + 2])].push_back(
                static_cast<std::uint32_t>(i));
        *state_ = {std::vector<T>(x, x + 3 * n), {}, {}};
        for (std::size_t i = 0; i < n; ++i) {
            state_->begin.push_back(state_->others.size());
            for (std::size_t d = 0; d < 27; ++d) {
                const auto beside = [&](T at, std::size_t step) { return (cell(at) + side + step - 1) % side; };
                const std::size_t place = (beside(x[3 * i], d % 3) * side + beside(x[3 * i + 1], d / 3 % 3)) * side +
                                          beside(x[3 * i + 2], d / 9);
                for (const std::uint32_t j : cells[place]) {
                    if (j <= i) continue;
                    const T dx = nearest(x[3 * i] - x[3 * j]), dy = nearest(x[3 * i + 1] - x[3 * j + 1]),
                            dz = nearest(x[3 * i + 2] - x[3 * j + 2]);
                    if (dx * dx + dy * dy + dz * dz < (cutoff + skin) * (cutoff + skin)) state_->others.push_back(j);
                }
            }
        }
        state_->begin.push_back(state_->others.size());
    }

    T box_ = 0;
    std::shared_ptr<Lists> state_;
};

constexpr double gravity_constant = 0.001, gravity_softening = 0.1;  // of bodies of mass 1

struct GravityFactor {
    template <class T>
    static T of(T dx, T dy, T dz) {
        const T softened = dx * dx + dy * dy + dz * dz + T(gravity_softening * gravity_softening);
        return T(-gravity_constant) / (softened * std::sqrt(softened));
    }
};

template <class T>
using PlainGravity = PlainPairs<T, GravityFactor>;
template <class T>
using GatherGravity = GatherPairs<T, GravityFactor>;

}  // namespace steplab::benchmark
