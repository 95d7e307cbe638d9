#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/compensated.hpp"

namespace steplab {

/// The internal state of methods that hold positions and velocities of one time and nothing else, with what rounding
/// has cut off them if their parameter `compensated` asks for it. Integrators inherit it.
template <class T>
class Synchronised {
public:
    Synchronised() = default;
    explicit Synchronised(const ParameterValues& values) : compensated_(asks_for_compensated_sums(values)) {}

    template <class System>
    void synchronised(const System&, State<T>& out) const {
        out.displacement = x_;
        out.velocity = v_;
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.Synchronised::x_);
        f(self.Synchronised::v_);
        f(self.Synchronised::lost_.x);
        f(self.Synchronised::lost_.v);
    }

protected:
    void begin(const State<T>& state) {
        x_ = state.displacement;
        v_ = state.velocity;
        lost_ = Lost<T>(compensated_, x_.count());
    }

    Field<T> x_;  ///< displacements; absolute positions in plain methods
    Field<T> v_;
    Lost<T> lost_;

private:
    bool compensated_ = false;
};

}  // namespace steplab
