#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"

#include <cstddef>

namespace steplab {

/// a -= gamma v.
template <class T>
void add_drag(T drag, const Field<T>& v, Field<T>& a) {
    if (drag == T(0)) return;
    T* const out = a.flat().data();
    const T* const velocity = v.flat().data();
    elementwise(a.flat().size(), [=](std::size_t k) { out[k] -= drag * velocity[k]; });
}

/// a -= gamma v + D(x) v.
template <class T, class System>
void resist(System& system, const Field<T>& x, const Field<T>& v, Field<T>& a) {
    add_drag(system.drag(), v, a);
    if (system.damped()) system.add_damping(x, v, a);
}

/// a(x) - gamma v - D(x) v.
template <class T, class System>
void accelerate(System& system, const Field<T>& x, const Field<T>& v, Field<T>& a) {
    system.accelerations(x, a);
    resist(system, x, v, a);
}

/// A system for evaluations that are not counted because they are for output.
template <class System>
class Uncounted {
public:
    explicit Uncounted(const System& system) : system_(system) {}
    template <class Field>
    void accelerations(const Field& x, Field& a) {
        system_.uncounted_accelerations(x, a);
    }
    auto drag() const { return system_.drag(); }
    bool damped() const { return system_.damped(); }
    template <class Field, class Time>
    void damp(const Field& x, Field& v, Time time) const {
        system_.damp(x, v, time);
    }
    template <class Field>
    void add_damping(const Field& x, const Field& v, Field& a) const {
        system_.add_damping(x, v, a);
    }

private:
    const System& system_;
};

}  // namespace steplab
