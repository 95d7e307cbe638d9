#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/vector.hpp"
#include "models/forces/composition.hpp"
#include "models/periods.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace steplab {

/// The particles of a composition and the space they are in.
template <class T>
class ComposedParticles {
public:
    explicit ComposedParticles(std::shared_ptr<const Composition> of)
        : of_(std::move(of)), periods_{Periods<T>(of_->box.x), Periods<T>(of_->box.y), Periods<T>(of_->box.z)} {
        for (const double mass : of_->masses) {
            masses_.push_back(static_cast<T>(mass));
            inverse_masses_.push_back(T(1) / masses_.back());
        }
        for (const double charge : of_->charges) charges_.push_back(static_cast<T>(charge));
        for (const Vec3 at : of_->reference) reference_.push_back(vector(at));
    }

    const Composition& terms() const { return *of_; }
    std::size_t count() const { return of_->count; }
    bool moves(std::size_t i) const { return of_->fixed.empty() || of_->fixed[i] == 0; }

    /// In the unit of mass; empty where all are 1.
    const std::vector<T>& masses() const { return masses_; }
    T mass(std::size_t i) const { return masses_.empty() ? T(1) : masses_[i]; }
    T inverse_mass(std::size_t i) const { return masses_.empty() ? T(1) : inverse_masses_[i]; }
    T charge(std::size_t i) const { return charges_.empty() ? T(0) : charges_[i]; }
    PairProperties<T> properties(std::size_t i, std::size_t j) const {
        return {mass(i), mass(j), charge(i), charge(j)};
    }

    Vector<T> place(const Field<T>& u, std::size_t i) const {
        const Vector<T> at{u.x()[i], u.y()[i], u.z()[i]};
        return reference_.empty() ? at : reference_[i] + at;
    }
    /// u_j - u_i; in a box to the nearest image.
    Vector<T> difference(const Field<T>& u, std::size_t i, std::size_t j) const {
        return {periods_[0].within(u.x()[j] - u.x()[i]), periods_[1].within(u.y()[j] - u.y()[i]),
                periods_[2].within(u.z()[j] - u.z()[i])};
    }
    /// The vector from particle i to the nearest image of particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const Vector<T> d = difference(u, i, j);
        if (reference_.empty()) return d;
        return {d.x + (reference_[j].x - reference_[i].x), d.y + (reference_[j].y - reference_[i].y),
                d.z + (reference_[j].z - reference_[i].z)};
    }

    static Vector<T> vector(Vec3 v) { return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)}; }

private:
    std::shared_ptr<const Composition> of_;
    std::vector<T> masses_, inverse_masses_, charges_;
    std::vector<Vector<T>> reference_;
    std::array<Periods<T>, 3> periods_;
};

}  // namespace steplab
