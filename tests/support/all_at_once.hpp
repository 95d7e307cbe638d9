#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "methods/engines/integrator.hpp"

#include <utility>

namespace steplab::test {

/// A layout that does not sweep: all accelerations first, then all moves.
template <class Force>
struct AllAtOnce {
    static constexpr ForceCapabilities capabilities{};
    Force force;

    template <class T>
    void accelerations(const Field<T>& x, Field<T>& a) {
        force.accelerations(x, a);
    }
};

/// The force for tests of an integrator in which sweeps do not matter: explicit Runge-Kutta methods get one without,
/// because the code of their sweeps takes long to compile.
template <class Integrator, class Force>
auto force_for(Force force) {
    if constexpr (Integrator::capabilities.forcing == Forcing::runge_kutta) {
        return AllAtOnce<Force>{std::move(force)};
    } else {
        return force;
    }
}

}  // namespace steplab::test
