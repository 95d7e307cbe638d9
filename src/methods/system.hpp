#pragma once

#include "core/field.hpp"
#include "core/stages.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace steplab {

/// The engine of a force in another number type; an engine that has none (Plain) stays out of it.
template <class N, class Force>
auto force_in(const Force& force) {
    if constexpr (requires { force.template in<N>(); }) {
        return force.template in<N>();
    } else {
        return force;
    }
}

/// What a method integrates: x'' = a(x) - gamma v, in steps of dt. Force is the layout's engine; it is known at compile
/// time, so nothing is called through a pointer inside a step.
template <class T, class Force>
class System {
public:
    System(Force force, T drag, T dt) : force_(std::move(force)), drag_(drag), dt_(dt) {}

    /// a(x) of all particles, drag not included: one evaluation.
    void accelerations(const Field<T>& x, Field<T>& a) {
        force_.accelerations(x, a);
        ++evaluations_;
    }

    /// a(x) at the eight stages of a step at once: eight evaluations.
    void accelerations(const Field<Stages<T>>& x, Field<Stages<T>>& a) {
        if (!force_at_stages_) force_at_stages_.emplace(force_in<Stages<T>>(force_));
        force_at_stages_->accelerations(x, a);
        evaluations_ += stage_count;
    }

    T drag() const { return drag_; }
    T dt() const { return dt_; }
    std::uint64_t evaluations() const { return evaluations_; }
    void evaluations(std::uint64_t count) { evaluations_ = count; }

private:
    Force force_;
    std::optional<decltype(force_in<Stages<T>>(std::declval<const Force&>()))> force_at_stages_;  ///< once asked for
    T drag_;
    T dt_;
    std::uint64_t evaluations_ = 0;
};

// An integrator (the class template Integrator<T> of a method) has
//   explicit Integrator(const ParameterValues&)
//   void start(System&, State<T>)             begins a segment at a synchronised state
//   void step(System&)                        one step of dt; an adaptive one takes steps of its own until dt is behind
//   void synchronised(const System&, State<T>& out) const   x and v of one time, without changing anything
//   static void each_part(self, f)             calls f(field) for every field of self's internal state
//   Progress progress() const; void progress(const Progress&)   where its internal state is more than fields: plain
//   data
// Everything else it holds is scratch: the internal state alone decides how the run goes on.

}  // namespace steplab
