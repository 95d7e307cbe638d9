#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/phi.hpp"
#include "methods/synchronised.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

/// A kick v += kick dt a(x) and the drift x += drift dt v after it (McLachlan, Quispel, Acta Numerica 11 (2002) 341,
/// section 3). A zero leaves its part out; each kick costs one evaluation, but for a step's first where the step before
/// ended with a kick.
struct KickAndDrift {
    long double kick = 0;
    long double drift = 0;
};

/// velocity-verlet applied with w[0] dt, w[1] dt, ...; the half kicks between two of them are one.
template <std::size_t N>
constexpr std::array<KickAndDrift, N + 1> composition(const std::array<long double, N>& w) {
    std::array<KickAndDrift, N + 1> table{};
    for (std::size_t i = 0; i < N; ++i) {
        table[i].kick += w[i] / 2;
        table[i].drift = w[i];
        table[i + 1].kick = w[i] / 2;
    }
    return table;
}

/// Runs any splitting method; `Table::table` is its array of KickAndDrift, which the compiler unrolls. Drag belongs to
/// the kicks: v' = a - gamma v is solved exactly over each kick's time, v += tau phi_1(-gamma tau) (a - gamma v); a
/// Table with `explicit_drag` takes v += tau (a - gamma v) instead.
template <class T, class Table>
class Splitting : public Synchronised<T> {
public:
    explicit Splitting(const ParameterValues& values) : Synchronised<T>(values) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        this->begin(state);
        a_ = Field<T>(x_.count());
        for (std::size_t i = 0; i < parts; ++i) {
            const T tau = static_cast<T>(table[i].kick) * system.dt();
            kicks_[i] = explicit_drag ? tau : tau * phi_1(-system.drag() * tau);
            drifts_[i] = static_cast<T>(table[i].drift) * system.dt();
        }
        if constexpr (ends_with_kick) system.accelerations(x_, a_);
    }

    template <class System>
    void step(System& system) {
        all_parts(system, std::make_index_sequence<parts>{});
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        Synchronised<T>::each_part(self, f);
        if constexpr (ends_with_kick) f(self.a_);
    }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;

    static constexpr auto& table = Table::table;
    static constexpr std::size_t parts = Table::table.size();
    /// Then its accelerations are those the next step begins with.
    static constexpr bool ends_with_kick = table.back().drift == 0;
    static constexpr bool explicit_drag = requires { Table::explicit_drag; };

    template <class System, std::size_t... I>
    void all_parts(System& system, std::index_sequence<I...>) {
        (kick_and_drift<I>(system), ...);
    }

    template <std::size_t I, class System>
    void kick_and_drift(System& system) {
        constexpr bool kick = table[I].kick != 0, drift = table[I].drift != 0;
        if constexpr (kick && !(I == 0 && ends_with_kick)) system.accelerations(x_, a_);
        if (const T drag = system.drag(); drag != T(0)) {
            move<kick, drift>(I, [drag](T a, T v) { return a - drag * v; });
        } else {
            move<kick, drift>(I, [](T a, T) { return a; });
        }
    }

    template <bool Kick, bool Drift, class Acceleration>
    void move(std::size_t part, Acceleration acceleration) {
        const T kick = kicks_[part], drift = drifts_[part];
        T *const x = x_.flat().data(), *const v = v_.flat().data();
        const T* const a = a_.flat().data();
        if (lost_.kept()) {
            T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
            return elementwise(x_.flat().size(), [=](std::size_t k) {
                if constexpr (Kick) add_compensated(v[k], lost_v[k], kick * acceleration(a[k], v[k]));
                if constexpr (Drift) add_compensated(x[k], lost_x[k], drift * v[k]);
            });
        }
        elementwise(x_.flat().size(), [=](std::size_t k) {
            if constexpr (Kick) v[k] += kick * acceleration(a[k], v[k]);
            if constexpr (Drift) x[k] += drift * v[k];
        });
    }

    Field<T> a_;
    std::array<T, parts> kicks_{}, drifts_{};  ///< of each part, in the scene's time
};

}  // namespace steplab
