#pragma once

#include "core/field.hpp"

namespace steplab {

/// The internal state of methods that hold positions and velocities of one time and nothing else. Integrators inherit
/// it.
template <class T>
class Synchronised {
public:
    template <class System>
    void synchronised(const System&, State<T>& out) const {
        out.displacement = x_;
        out.velocity = v_;
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.Synchronised::x_);
        f(self.Synchronised::v_);
    }

protected:
    void begin(const State<T>& state) {
        x_ = state.displacement;
        v_ = state.velocity;
    }

    Field<T> x_;  ///< displacements; absolute positions in plain methods
    Field<T> v_;
};

}  // namespace steplab
