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

/// a(x) - gamma v.
template <class T, class System>
void accelerate(System& system, const Field<T>& x, const Field<T>& v, Field<T>& a) {
    system.accelerations(x, a);
    add_drag(system.drag(), v, a);
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

private:
    const System& system_;
};

}  // namespace steplab
