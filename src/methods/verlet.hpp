#pragma once

#include "core/entry.hpp"
#include "methods/three_point.hpp"

namespace steplab {

/// Störmer-Verlet in three points. It starts from x(1) = x0 + dt (1 - f) v0 + dt^2/2 a0 and shows
/// v(n) = (x(n+1) - x(n-1)) / (2 dt), the velocity at the time of x(n).
struct Verlet {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static constexpr MethodInfo info{
        .id = "verlet",
        .name = "Störmer-Verlet",
        .what = "The workhorse of molecular dynamics: cheap, reversible, keeps energy within bounds for ever.",
        .order = 2,
        .order_with_drag = 2,
        .evaluations = 1,
        .start_evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum, energy within bounds",
        .source = "Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich, Wanner, Acta Numerica 12 (2003) 399",
        .parameters = parameters,
    };

    template <class T>
    class Integrator {
    public:
        explicit Integrator(const ParameterValues& values) : compensated_(values[compensated_sums.name] != 0) {}

        /// The mean velocity behind the start is the one that makes next() take the prescribed first step.
        template <class System>
        void start(System& system, const State<T>& state) {
            points_ = ThreePoint<T>(state, compensated_);
            system.accelerations(points_.x, points_.a);
            const T h = system.dt(), f = system.drag() * h / T(2);
            T* const w = points_.w.flat().data();
            const T* const a = points_.a.flat().data();
            elementwise(points_.w.flat().size(), [=](std::size_t k) { w[k] = (T(1) + f) * w[k] - h / T(2) * a[k]; });
        }

        template <class System>
        void step(System& system) {
            points_.next(system.dt(), system.drag());
            system.accelerations(points_.x, points_.a);
        }

        template <class System>
        void synchronised(const System& system, State<T>& out) const {
            out.displacement = points_.x;
            out.velocity = points_.w;
            T* const v = out.velocity.flat().data();
            const T* const a = points_.a.flat().data();
            elementwise(out.velocity.flat().size(), [=, h = system.dt(), drag = system.drag()](std::size_t k) {
                v[k] = ThreePoint<T>::velocity(v[k], a[k], h, drag);
            });
        }

        template <class Self, class F>
        static void each_part(Self& self, F f) {
            ThreePoint<T>::each_part(self.points_, f);
        }

    private:
        ThreePoint<T> points_;
        bool compensated_;
    };
};

}  // namespace steplab
