#include "models/forces/plain.hpp"

#include "core/number.hpp"

#include <cmath>

namespace steplab {

template <class T>
Plain<T>::Plain(const Forces& forces) {
    std::visit([this](const auto& layout) { this->add(layout); }, forces);
}

template <class T>
void Plain<T>::add(const ConstantForces& forces) {
    constant_step_ = static_cast<T>(forces.step);
}

template <class T>
void Plain<T>::add(const LineForces& forces) {
    mass_ = static_cast<T>(forces.mass);
    k_ = static_cast<T>(forces.k);
    gravity_ = static_cast<T>(forces.gravity);
    for (std::size_t i = 0; i + 1 < forces.count; ++i)
        springs_.push_back({i, i + 1, static_cast<T>(forces.rest_length)});
    if (forces.first_fixed) fixed_.push_back(0);
}

template <class T>
void Plain<T>::add(const GridForces& forces) {
    mass_ = static_cast<T>(forces.mass);
    k_ = static_cast<T>(forces.k);
    const std::size_t rows = forces.rows, columns = forces.columns;
    const T length = static_cast<T>(forces.rest_length), diagonal = static_cast<T>(std::sqrt(2.0) * forces.rest_length);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const std::size_t p = i * columns + j;
            if (j + 1 < columns) springs_.push_back({p, p + 1, length});
            if (i + 1 < rows) springs_.push_back({p, p + columns, length});
            if (i + 1 < rows && j + 1 < columns) springs_.push_back({p, p + columns + 1, diagonal});
            if (i + 1 < rows && j > 0) springs_.push_back({p, p + columns - 1, diagonal});
            if (i == 0 || j == 0 || i + 1 == rows || j + 1 == columns) fixed_.push_back(p);
        }
    }
}

template <class T>
void Plain<T>::add(const PairForces& forces) {
    mass_ = static_cast<T>(forces.mass);
    morse_ = true;
    depth_ = static_cast<T>(forces.depth);
    b_ = square_root(static_cast<T>(forces.k) / (T(2) * depth_));
    r0_ = static_cast<T>(forces.r0);
}

template <class T>
void Plain<T>::add(const NearPairForces& forces) {
    add(static_cast<const PairForces&>(forces));
    cutoff_ = static_cast<T>(forces.cutoff);
    force_at_cutoff_ = morse_force(cutoff_);
    period_ = static_cast<T>(forces.period);
}

/// Refused before the run (sim/run/run_description.cpp): the programs of 2008 had nothing of the kind.
template <class T>
void Plain<T>::add(const ComposedForces&) {}

template <class T>
void Plain<T>::accelerations(const Field<T>& positions, Field<T>& a) const {
    for (std::size_t i = 0; i < a.count(); ++i) {
        a.x()[i] = T(0);
        a.y()[i] = -(constant_step_ * static_cast<T>(i)) - gravity_;
        a.z()[i] = T(0);
    }
    add_springs(positions, a);
    if (morse_) add_pairs(positions, a);
    for (const std::size_t i : fixed_) a.set(i, {});
}

template <class T>
void Plain<T>::add_springs(const Field<T>& positions, Field<T>& a) const {
    const T *const x = positions.x(), *const y = positions.y(), *const z = positions.z();
    for (const auto& [i, j, length] : springs_) {
        const T dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
        const T distance = std::sqrt(dx * dx + dy * dy + dz * dz);
        const T s = distance > T(0) ? k_ * (distance - length) / distance : T(0);
        const T fx = s * dx, fy = s * dy, fz = s * dz;
        a.x()[i] += fx / mass_;
        a.y()[i] += fy / mass_;
        a.z()[i] += fz / mass_;
        a.x()[j] -= fx / mass_;
        a.y()[j] -= fy / mass_;
        a.z()[j] -= fz / mass_;
    }
}

template <class T>
T Plain<T>::morse_force(T distance) const {
    const T e = exponential(-(b_ * (distance - r0_)));
    return -(T(2) * b_ * depth_ * e * (T(1) - e));
}

template <class T>
void Plain<T>::add_pairs(const Field<T>& positions, Field<T>& a) const {
    const T *const x = positions.x(), *const y = positions.y(), *const z = positions.z();
    const auto to_nearest_image = [period = period_](T d) {
        return period > T(0) ? d - period * std::nearbyint(d / period) : d;
    };
    for (std::size_t i = 0; i < positions.count(); ++i) {
        for (std::size_t j = i + 1; j < positions.count(); ++j) {
            const T dx = to_nearest_image(x[i] - x[j]), dy = to_nearest_image(y[i] - y[j]),
                    dz = to_nearest_image(z[i] - z[j]);
            const T distance = std::sqrt(dx * dx + dy * dy + dz * dz);
            if (!(distance > T(0)) || (cutoff_ > T(0) && !(distance < cutoff_))) continue;
            const T s = (morse_force(distance) - force_at_cutoff_) / distance;
            a.x()[i] += s * dx / mass_;
            a.y()[i] += s * dy / mass_;
            a.z()[i] += s * dz / mass_;
            a.x()[j] -= s * dx / mass_;
            a.y()[j] -= s * dy / mass_;
            a.z()[j] -= s * dz / mass_;
        }
    }
}

template class Plain<float>;
template class Plain<double>;

}  // namespace steplab
