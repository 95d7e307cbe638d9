#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "models/forces/composed_formula.hpp"
#include "models/forces/composed_particles.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace steplab {

/// The forces of all springs of a composition: a block of springs at a time in SIMD lanes, where numbers have them and
/// rows would not pay (spring_rows.hpp).
template <class T>
class ComposedSprings {
public:
    explicit ComposedSprings(const Composition& of) {
        for (const ComposedSpring& spring : of.springs) append(spring, of.mass);
        while (first_.size() % width != 0) append({}, of.mass);  // of the first particle with itself
    }

    void add(const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& a) const {
        for (std::size_t block = 0; block < first_.size(); block += width) add_block(particles, u, a, block);
    }

private:
    static constexpr bool in_lanes = std::same_as<T, float> || std::same_as<T, double>;
    static constexpr std::size_t width = in_lanes ? Field<T>::granule : 1;
    using N = std::conditional_t<in_lanes, RegisterLanes<T, in_lanes ? width : 1>, T>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    void append(const ComposedSpring& spring, double unit) {
        const SpringLaw<T> law = SpringLaw<T>::of(spring, unit);
        first_.push_back(spring.first);
        second_.push_back(spring.second);
        const Vector<T> rest = ComposedParticles<T>::vector(spring.rest);
        const std::array<T, 8> numbers{rest.x,      rest.y, rest.z,        law.length,
                                       law.stretch, law.k,  law.quadratic, law.cubic};
        for (std::size_t q = 0; q < numbers.size(); ++q) numbers_[q].push_back(numbers[q]);
        linear_ = linear_ && law.quadratic == T(0) && law.cubic == T(0);
    }

    N numbers(std::size_t quantity, std::size_t at) const {
        if constexpr (in_lanes)
            return N::load(numbers_[quantity].data() + at);
        else
            return numbers_[quantity][at];
    }

    /// The differences of displacements of a block of springs.
    Vector<N> differences(const ComposedParticles<T>& particles, const Field<T>& u, std::size_t block) const {
        if constexpr (in_lanes) {
            alignas(64) std::array<std::array<T, width>, 3> e;
            for (std::size_t lane = 0; lane < width; ++lane) {
                const Vector<T> d = particles.difference(u, first_[block + lane], second_[block + lane]);
                e[0][lane] = d.x, e[1][lane] = d.y, e[2][lane] = d.z;
            }
            return {N::load(e[0].data()), N::load(e[1].data()), N::load(e[2].data())};
        } else {
            return particles.difference(u, first_[block], second_[block]);
        }
    }

    void add_block(const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& a, std::size_t block) const {
        const Vector<N> rest{numbers(0, block), numbers(1, block), numbers(2, block)};
        const SpringGeometry<N> spring(rest, differences(particles, u, block));
        const SpringLaw<N> law{numbers(3, block), numbers(4, block), numbers(5, block), numbers(6, block),
                               numbers(7, block)};
        N factor = linear_ ? law.linear_factor(spring) : law.nonlinear_factor(spring);
        if (linear_) factor = where(law.length > N(T(0)), factor, law.k);
        const Vector<N> pull = factor * spring.d;
        if constexpr (in_lanes) {
            alignas(64) std::array<std::array<T, width>, 3> of;
            pull.x.store(of[0].data()), pull.y.store(of[1].data()), pull.z.store(of[2].data());
            for (std::size_t lane = 0; lane < width; ++lane)
                pull_ends(particles, a, block + lane, {of[0][lane], of[1][lane], of[2][lane]});
        } else {
            pull_ends(particles, a, block, pull);
        }
    }

    void pull_ends(const ComposedParticles<T>& particles, Field<T>& a, std::size_t spring,
                   const Vector<T>& pull) const {
        const std::size_t i = first_[spring], j = second_[spring];
        change(a, i, particles.inverse_mass(i), pull);
        change(a, j, T(0) - particles.inverse_mass(j), pull);
    }

    static void change(Field<T>& a, std::size_t i, const T& factor, const Vector<T>& vector) {
        a.x()[i] += factor * vector.x;
        a.y()[i] += factor * vector.y;
        a.z()[i] += factor * vector.z;
    }

    bool linear_ = true;
    std::vector<std::uint32_t> first_, second_;
    std::array<Numbers, 8> numbers_;  ///< of each spring: its vector at rest, length, stretch, k, quadratic, cubic
};

}  // namespace steplab
