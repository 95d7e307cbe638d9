#pragma once

#include "core/field.hpp"

#include <cstdint>
#include <utility>

namespace steplab {

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

    T drag() const { return drag_; }
    T dt() const { return dt_; }
    std::uint64_t evaluations() const { return evaluations_; }
    void evaluations(std::uint64_t count) { evaluations_ = count; }

private:
    Force force_;
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
