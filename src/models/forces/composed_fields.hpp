#pragma once
// The fields of a composition: potentials that act on particles from outside.

#include "core/field.hpp"
#include "core/interval.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/composition.hpp"
#include "models/potentials/expression_potential.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

template <class T>
class ComposedFields {
public:
    explicit ComposedFields(const Composition& of) {
        auto potentials = std::make_shared<std::vector<FieldPotential<T>>>();
        for (const ComposedField& field : of.fields) potentials->emplace_back(field.expression);
        potentials_ = std::move(potentials);
        has_local_ = std::any_of(of.fields.begin(), of.fields.end(), is_local);
    }

    bool empty() const { return potentials_->empty(); }
    /// Stays where it is in copies, too.
    const FieldPotential<T>& operator[](std::size_t f) const { return (*potentials_)[f]; }

    void add(const ComposedParticles<T>& particles, const Field<T>& u, Field<T>& a) const {
        each(particles.terms(), [&](std::size_t f, std::size_t i) {
            const Vector<T> force = (*this)[f].force(particles.place(u, i), particles.mass(i), particles.charge(i));
            const Vector<T> now{a.x()[i], a.y()[i], a.z()[i]}, sum = now + particles.inverse_mass(i) * force;
            a.x()[i] = sum.x, a.y()[i] = sum.y, a.z()[i] = sum.z;
        });
    }

    /// Calls f(i, energy divided by the unit of mass) for every field and each of its particles.
    template <class F>
    void each_energy(const ComposedParticles<T>& particles, const Field<T>& u, F f) const {
        each(particles.terms(), [&](std::size_t field, std::size_t i) {
            f(i, (*this)[field].energy(particles.place(u, i), particles.mass(i), particles.charge(i)));
        });
    }

    /// Whether some are no polynomials: what they do at one place tells little of another.
    bool has_local() const { return has_local_; }
    /// Displacements, velocities and accelerations now.
    struct Motion {
        const Field<T>&u, &v, &a;
    };
    /// How large the acceleration of a particle by those is at most between two times from now, on its way if its
    /// acceleration stays as it is.
    double bound(const ComposedParticles<T>& particles, const Motion& now, std::size_t i, double from,
                 double to) const {
        const Vector<T> start = particles.place(now.u, i);
        const auto along = [=](T x, T speed, T pull) {
            const auto at = static_cast<double>(x), w = static_cast<double>(speed), a = static_cast<double>(pull) / 2;
            return Interval(at + from * w, at + to * w) + Interval(from * from * a, to * to * a);
        };
        const Vector<Interval> way{along(start.x, now.v.x()[i], now.a.x()[i]),
                                   along(start.y, now.v.y()[i], now.a.y()[i]),
                                   along(start.z, now.v.z()[i], now.a.z()[i])};
        const Interval mass(particles.mass(i)), charge(particles.charge(i));
        double sum = 0;
        for (std::size_t f = 0; f < potentials_->size(); ++f) {
            const ComposedField& field = particles.terms().fields[f];
            if (!is_local(field) || !std::binary_search(field.particles.begin(), field.particles.end(), i)) continue;
            const Vector<Interval> force = (*this)[f].force(way, mass, charge);
            sum += force.x.largest() + force.y.largest() + force.z.largest();
        }
        return sum * static_cast<double>(particles.inverse_mass(i));
    }

private:
    static bool is_local(const ComposedField& field) { return !field.expression->force.is_polynomial(); }

    template <class F>
    static void each(const Composition& of, F f) {
        for (std::size_t field = 0; field < of.fields.size(); ++field) {
            for (const std::uint32_t i : of.fields[field].particles) f(field, std::size_t{i});
        }
    }

    std::shared_ptr<const std::vector<FieldPotential<T>>> potentials_;
    bool has_local_ = false;
};

}  // namespace steplab
