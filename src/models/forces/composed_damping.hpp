#pragma once

#include "core/block.hpp"
#include "core/field.hpp"
#include "core/number.hpp"
#include "core/phi.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_particles.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace steplab {

/// The forces of a composition that are linear in the velocities: dashpots, and drag that differs between particles.
template <class T>
class ComposedDamping {
public:
    ComposedDamping(const Composition& of, const ComposedParticles<T>& particles) {
        for (std::size_t i = 0; i < of.drag.size(); ++i)
            drag_.push_back(particles.moves(i) ? static_cast<T>(of.drag[i]) : T(0));
        for (const ComposedSpring& spring : of.springs) {
            const bool held = !particles.moves(spring.first) && !particles.moves(spring.second);
            if (spring.damping > 0 && !held) add_dashpot(spring, of.mass, particles);
        }
    }

    bool any() const { return !drag_.empty() || !dashpots_.empty(); }

    /// v by the flow over a time: each part exactly, forwards over half of the time and backwards over the other.
    void damp(const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& v, const T& time) const {
        const T half = time / T(2);
        slow(v, half);
        for (const Dashpot& dashpot : dashpots_) damp(dashpot, particles, u, v, half);
        for (std::size_t d = dashpots_.size(); d-- > 0;) damp(dashpots_[d], particles, u, v, half);
        slow(v, half);
    }

    /// a -= D(u) v.
    void add(const ComposedParticles<T>& particles, const Field<T>& u, const Field<T>& v, Field<T>& a) const {
        for (std::size_t i = 0; i < drag_.size(); ++i) change(a, i, T(0) - drag_[i], at(v, i));
        for (const Dashpot& dashpot : dashpots_) {
            const Along along(dashpot, particles, u, v);
            if (!(along.distance2 > T(0))) continue;
            const T force = dashpot.damping * along.closing / along.distance2;
            change(a, dashpot.first, dashpot.inverse_first * force, along.d);
            change(a, dashpot.second, T(0) - dashpot.inverse_second * force, along.d);
        }
    }

    /// f(i, j, block) as each_damping() of a layout (core/force_layout.hpp).
    template <class F>
    void each(const ComposedParticles<T>& particles, const Field<T>& u, F f) const {
        for (std::size_t i = 0; i < drag_.size(); ++i) f(i, i, Block<T>::diagonal(particles.mass(i) * drag_[i]));
        for (const Dashpot& dashpot : dashpots_) {
            const Vector<T> d = particles.separation(u, dashpot.first, dashpot.second);
            const T distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            if (!(distance2 > T(0))) continue;
            const T scale = dashpot.damping / distance2;
            Block<T> block;
            block.at = {{{scale * d.x * d.x, scale * d.x * d.y, scale * d.x * d.z},
                         {scale * d.y * d.x, scale * d.y * d.y, scale * d.y * d.z},
                         {scale * d.z * d.x, scale * d.z * d.y, scale * d.z * d.z}}};
            f(std::size_t(std::min(dashpot.first, dashpot.second)),
              std::size_t(std::max(dashpot.first, dashpot.second)), block);
        }
    }

private:
    /// Everything divided by the unit of mass; an inverse mass is 0 where the particle is held.
    struct Dashpot {
        std::uint32_t first, second;
        T damping, inverse_first, inverse_second;
    };

    /// How the ends of a dashpot move along it.
    struct Along {
        Vector<T> d;
        T distance2, closing;  ///< |d|^2, d.(v of the second - v of the first)

        Along(const Dashpot& dashpot, const ComposedParticles<T>& particles, const Field<T>& u, const Field<T>& v)
            : d(particles.separation(u, dashpot.first, dashpot.second)), distance2(d.x * d.x + d.y * d.y + d.z * d.z) {
            const Vector<T> w = at(v, dashpot.second) - at(v, dashpot.first);
            closing = d.x * w.x + d.y * w.y + d.z * w.z;
        }
    };

    void add_dashpot(const ComposedSpring& spring, double unit, const ComposedParticles<T>& particles) {
        const auto inverse = [&](std::size_t i) { return particles.moves(i) ? particles.inverse_mass(i) : T(0); };
        dashpots_.push_back({spring.first, spring.second, static_cast<T>(spring.damping / unit), inverse(spring.first),
                             inverse(spring.second)});
    }

    static Vector<T> at(const Field<T>& field, std::size_t i) { return {field.x()[i], field.y()[i], field.z()[i]}; }
    static void change(Field<T>& field, std::size_t i, const T& factor, const Vector<T>& vector) {
        field.x()[i] += factor * vector.x;
        field.y()[i] += factor * vector.y;
        field.z()[i] += factor * vector.z;
    }

    /// 1 - e^-z, accurate for small z, too.
    static T lost_part(const T& z) {
        if constexpr (std::floating_point<T>)
            return z * phi_1(-z);
        else
            return T(1) - exponential(T(0) - z);
    }

    void slow(Field<T>& v, const T& time) const {
        for (std::size_t i = 0; i < drag_.size(); ++i) change(v, i, T(0) - lost_part(drag_[i] * time), at(v, i));
    }

    /// The relative velocity along the dashpot decays by itself; the momentum of both ends stays.
    static void damp(const Dashpot& dashpot, const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& v,
                     const T& time) {
        const Along along(dashpot, particles, u, v);
        if (!(along.distance2 > T(0))) return;
        const T both = dashpot.inverse_first + dashpot.inverse_second;
        const T lost = lost_part(dashpot.damping * both * time);
        const T share = lost * along.closing / (both * along.distance2);
        change(v, dashpot.first, dashpot.inverse_first * share, along.d);
        change(v, dashpot.second, T(0) - dashpot.inverse_second * share, along.d);
    }

    std::vector<T> drag_;  ///< rate of each particle; empty where there is none of its own
    std::vector<Dashpot> dashpots_;
};

}  // namespace steplab
