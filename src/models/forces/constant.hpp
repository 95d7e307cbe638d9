#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/sum.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/spring.hpp"

#include <array>

namespace steplab {

/// The engine of ConstantForces: a_i = (0, -step * i, 0).
template <class T>
class Constant {
public:
    static constexpr ForceCapabilities capabilities{};

    explicit Constant(const ConstantForces& forces)
        : forces_(forces), count_(forces.count), mass_(forces.mass), step_(static_cast<T>(forces.step)) {}

    /// The same forces in another number type.
    template <class N>
    Constant<N> in() const {
        return Constant<N>(forces_);
    }

    void accelerations(const Field<T>&, Field<T>& a) const {
        T* const ay = a.y();
        elementwise(count_,
                    [=, step = step_](std::size_t i) { ay[i] = -(step * static_cast<T>(static_cast<int>(i))); });
    }

    /// The potential energy, zero at y = 0 for every particle.
    PotentialEnergy potential(const Field<T>& u) const {
        CompensatedSum sum;
        for (std::size_t i = 0; i < count_; ++i)
            sum.add(step_ * static_cast<double>(i) * static_cast<double>(u.y()[i]));
        const double value = mass_ * sum.value();
        return {value, value < 0 ? -value : value, value};
    }

    /// Particles do not act on each other.
    template <class F>
    void passing_pairs(const Field<T>&, const Field<T>&, F) const {}
    Vector<T> separation(const Field<T>&, std::size_t, std::size_t) const { return {T(0), T(0), T(0)}; }

    Coupling coupling() const { return {Coupling::Kind::none, count_}; }
    bool moves(std::size_t) const { return true; }
    Vector<T> external(std::size_t i) const { return {T(0), -(step_ * static_cast<T>(static_cast<int>(i))), T(0)}; }

    std::array<SpringFormula<T>, 0> formulas() const { return {}; }

    template <class F>
    void each_interaction(const Field<T>&, F) const {}

private:
    ConstantForces forces_;
    std::size_t count_;
    double mass_;
    T step_;
};

}  // namespace steplab
