#pragma once

#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_particles.hpp"

#include <cstddef>
#include <vector>

namespace steplab {

/// What a composition says of its particles one by one, in registers of them; nothing is kept of what is the same for
/// all. T is float or double.
template <class T>
class ParticleRegisters {
    using N = Lanes<T>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

public:
    explicit ParticleRegisters(const ComposedParticles<T>& particles) {
        const Composition& of = particles.terms();
        const std::size_t padded = (of.count + N::count - 1) / N::count * N::count;
        for (std::size_t i = 0; !of.masses.empty() && i < padded; ++i)
            inverse_masses_.push_back(i < of.count ? particles.inverse_mass(i) : T(1));
        for (std::size_t i = 0; !of.fixed.empty() && i < padded; ++i)
            moves_.push_back(i < of.count && particles.moves(i) ? T(1) : T(0));
        if (of.accelerations.size() == 1) common_ = ComposedParticles<T>::vector(of.accelerations.front());
        if (of.accelerations.size() < 2) return;
        outside_ = Field<T>(of.count);
        for (std::size_t i = 0; i < of.count; ++i) outside_.set(i, of.accelerations[i]);
    }

    /// The accelerations that no other particle causes.
    [[gnu::always_inline]] Vector<N> outside(std::size_t r) const {
        if (outside_.count() > 0) return FieldLanes<const T>(outside_).get(r);
        return {N(common_.x), N(common_.y), N(common_.z)};
    }
    /// Accelerations by forces divided by the unit of mass.
    [[gnu::always_inline]] Vector<N> of_forces(std::size_t r, const Vector<N>& forces) const {
        return inverse_masses_.empty() ? forces : N::load(inverse_masses_.data() + r * N::count) * forces;
    }
    /// The same accelerations, but none of fixed particles.
    [[gnu::always_inline]] Vector<N> held(std::size_t r, const Vector<N>& a) const {
        if (moves_.empty()) return a;
        const N zero(T(0));
        const auto moves = N::load(moves_.data() + r * N::count) > zero;
        return {where(moves, a.x, zero), where(moves, a.y, zero), where(moves, a.z, zero)};
    }

private:
    Numbers inverse_masses_;  ///< in the unit of mass
    Numbers moves_;           ///< 1, or 0 if fixed
    Vector<T> common_{T(0), T(0), T(0)};
    Field<T> outside_;
};

}  // namespace steplab
