#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/synchronised.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

/// A kick v += kick dt (a(x) - gamma v) and the drift x += drift dt v after it (McLachlan, Quispel, Acta Numerica 11
/// (2002) 341, section 3). A zero leaves its part out; each kick costs one evaluation.
struct KickAndDrift {
    double kick = 0;
    double drift = 0;
};

/// Runs any splitting method; `Table::table` is its array of KickAndDrift, which the compiler unrolls. Drag is taken
/// explicitly, with the velocity before the kick.
template <class T, class Table>
class Splitting : public Synchronised<T> {
public:
    explicit Splitting(const ParameterValues&) {}

    template <class System>
    void start(System&, const State<T>& state) {
        this->begin(state);
        a_ = Field<T>(x_.count());
    }

    template <class System>
    void step(System& system) {
        all_parts(system, std::make_index_sequence<Table::table.size()>{});
    }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_;

    template <class System, std::size_t... I>
    void all_parts(System& system, std::index_sequence<I...>) {
        (kick_and_drift<I>(system), ...);
    }

    template <std::size_t I, class System>
    void kick_and_drift(System& system) {
        constexpr KickAndDrift part = Table::table[I];
        if constexpr (part.kick != 0) system.accelerations(x_, a_);
        const T kick = static_cast<T>(part.kick) * system.dt();
        const T drift = static_cast<T>(part.drift) * system.dt();
        if (const T drag = system.drag(); drag != T(0)) {
            move<part.kick != 0, part.drift != 0>(kick, drift, [drag](T a, T v) { return a - drag * v; });
        } else {
            move<part.kick != 0, part.drift != 0>(kick, drift, [](T a, T) { return a; });
        }
    }

    template <bool Kick, bool Drift, class Acceleration>
    void move(T kick, T drift, Acceleration acceleration) {
        T *const x = x_.flat().data(), *const v = v_.flat().data();
        const T* const a = a_.flat().data();
        elementwise(x_.flat().size(), [=](std::size_t k) {
            if constexpr (Kick) v[k] += kick * acceleration(a[k], v[k]);
            if constexpr (Drift) x[k] += drift * v[k];
        });
    }

    Field<T> a_;
};

}  // namespace steplab
