#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/spring.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace steplab {

/// LineForces at work. Every spring is computed once; the acceleration of particle i is
/// (pull of the spring to i + 1) - (pull of the spring from i - 1), in this order, then gravity.
template <class T>
class Line {
public:
    explicit Line(const LineForces& forces)
        : forces_(forces),
          first_moving_(forces.first_fixed ? 1 : 0),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          gravity_(static_cast<T>(forces.gravity)) {}

    void accelerations(const Field<T>& u, Field<T>& a) {
        pulls_.fill(T(0));
        for (std::size_t begin = 0; begin < forces_.count; begin += block) {
            const std::size_t end = std::min(begin + block, forces_.count);
            if (begin > 0) carry_last_pull();
            compute_pulls(u, begin, std::min(end, forces_.count - 1));
            if (end == forces_.count) clear_pull_after_end(end - begin);
            combine(a, begin, end);
        }
        if (gravity_ != T(0)) add_gravity(a);
    }

    PotentialEnergy potential(const Field<T>& u) const {
        CompensatedSum springs, heights;
        for (std::size_t i = 0; i + 1 < forces_.count; ++i)
            springs.add(static_cast<double>(spring_energy(rest(), length_, difference(u, i))));
        if (gravity_ != T(0)) {
            for (std::size_t i = 0; i < forces_.count; ++i) heights.add(static_cast<double>(u.y()[i]));
        }
        const double elastic = forces_.k * springs.value();
        const double external = forces_.mass * forces_.gravity * heights.value();
        return {elastic + external, elastic + std::abs(external), external};
    }

private:
    /// Springs computed at a time: their pulls stay in the first-level cache.
    static constexpr std::size_t block = 256;
    /// Index in a row of pulls of a block's first spring; the one before it is the last spring of the block before.
    static constexpr std::size_t first = 16;
    static constexpr std::size_t row = first + block + first;

    Vector<T> rest() const { return {length_, T(0), T(0)}; }

    static Vector<T> difference(const Field<T>& u, std::size_t i) {
        return {u.x()[i + 1] - u.x()[i], u.y()[i + 1] - u.y()[i], u.z()[i + 1] - u.z()[i]};
    }

    void compute_pulls(const Field<T>& u, std::size_t begin, std::size_t end) {
        const T *const x = u.x() + begin, *const y = u.y() + begin, *const z = u.z() + begin;
        T* const pulls = pulls_.data() + first;
        elementwise(end - begin, [=, rest = rest(), length = length_, stiffness = stiffness_](std::size_t s) {
            const Vector<T> e{x[s + 1] - x[s], y[s + 1] - y[s], z[s + 1] - z[s]};
            const Vector<T> pull = spring_pull(rest, length, e);
            pulls[s] = stiffness * pull.x;
            pulls[s + row] = stiffness * pull.y;
            pulls[s + 2 * row] = stiffness * pull.z;
        });
    }

    void combine(Field<T>& a, std::size_t begin, std::size_t end) const {
        combine_component(a.x(), 0, begin, end);
        combine_component(a.y(), 1, begin, end);
        combine_component(a.z(), 2, begin, end);
    }

    void combine_component(T* a, std::size_t component, std::size_t begin, std::size_t end) const {
        const std::size_t from = std::max(begin, first_moving_);
        const T* const pulls = pulls_.data() + component * row + first + (from - begin);
        T* const out = a + from;
        elementwise(end - from, [=](std::size_t s) { out[s] = pulls[s] - pulls[s - 1]; });
    }

    void carry_last_pull() {
        for (std::size_t c = 0; c < 3; ++c) pulls_[c * row + first - 1] = pulls_[c * row + first + block - 1];
    }

    /// The last particle has no spring behind it.
    void clear_pull_after_end(std::size_t particles) {
        for (std::size_t c = 0; c < 3; ++c) pulls_[c * row + first + particles - 1] = T(0);
    }

    void add_gravity(Field<T>& a) const {
        T* const y = a.y() + first_moving_;
        elementwise(forces_.count - first_moving_, [=, gravity = gravity_](std::size_t i) { y[i] -= gravity; });
    }

    LineForces forces_;
    std::size_t first_moving_;
    T stiffness_;  ///< k / m
    T length_;
    T gravity_;
    alignas(64) std::array<T, 3 * row> pulls_{};  ///< pulls of a block's springs: x, y, z
};

}  // namespace steplab
