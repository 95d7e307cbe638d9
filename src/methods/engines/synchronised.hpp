#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "methods/engines/compensated.hpp"

#include <cstddef>
#include <utility>

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
    /// Calls sink(r, x, v) with displacements and velocities of every register r of particles in turn.
    template <class System, class Sink>
    void emit(const System&, Sink sink) const {
        const FieldLanes<const T> position(x_), velocity(v_);
        const std::size_t registers = (x_.count() + Lanes<T>::count - 1) / Lanes<T>::count;
        for (std::size_t r = 0; r < registers; ++r) sink(r, position.get(r), velocity.get(r));
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.Synchronised::x_);
        f(self.Synchronised::v_);
        f(self.Synchronised::lost_.x);
        f(self.Synchronised::lost_.v);
    }

protected:
    void begin(State<T> state) {
        x_ = std::move(state.displacement);
        v_ = std::move(state.velocity);
        lost_ = Lost<T>(compensated_, x_.count());
    }

    Field<T> x_;  ///< displacements; absolute positions in plain methods
    Field<T> v_;
    Lost<T> lost_;

private:
    bool compensated_ = false;
};

}  // namespace steplab
