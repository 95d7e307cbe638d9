#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/engines/integrator.hpp"

namespace steplab {

/// The Verlet method of the thesis as its program was printed, mistakes included (docs/curiosities.md): a particle
/// whose last two positions are equal takes an Euler step with its stored velocity, which the other steps store wrongly
/// as x(n+1) - x(n) / (2 dt). It works on absolute positions with the plain force loop.
struct Verlet2008 {
    static constexpr MethodInfo info{
        .id = "verlet-2008",
        .name = "Verlet as printed in 2008",
        .what = "A curiosity: Verlet with a missing bracket, kept to show its effect. Not for production runs.",
        .order = 2,
        .order_with_drag = 0,
        .evaluations = 1,
        .linear_limit = 2,
        .curiosity = true,
        .conserves = "nothing reliably",
        .source = "Sosnowski, thesis, UMK Toruń 2008, listing of Verlet",
    };

    template <class T>
    class Integrator {
    public:
        static constexpr IntegratorCapabilities capabilities{.forcing = Forcing::plain};

        explicit Integrator(const ParameterValues&) {}

        template <class System>
        void start(System&, const State<T>& state) {
            x_ = before_ = state.displacement;
            v_ = state.velocity;
            a_ = Field<T>(x_.count());
        }

        template <class System>
        void step(System& system) {
            system.accelerations(x_, a_);
            const T dt = system.dt(), drag = system.drag();
            for (std::size_t i = 0; i < x_.count(); ++i) {
                const bool restart =
                    x_.x()[i] == before_.x()[i] && x_.y()[i] == before_.y()[i] && x_.z()[i] == before_.z()[i];
                move(x_.x()[i], before_.x()[i], v_.x()[i], a_.x()[i], dt, drag, restart);
                move(x_.y()[i], before_.y()[i], v_.y()[i], a_.y()[i], dt, drag, restart);
                move(x_.z()[i], before_.z()[i], v_.z()[i], a_.z()[i], dt, drag, restart);
            }
        }

        template <class System>
        void synchronised(const System&, State<T>& out) const {
            out.displacement = x_;
            out.velocity = v_;
        }

        template <class Self, class F>
        static void each_part(Self& self, F f) {
            f(self.x_);
            f(self.before_);
            f(self.v_);
        }

    private:
        static void move(T& x, T& before, T& v, T acceleration, T dt, T drag, bool restart) {
            const T a = acceleration - drag * v;
            if (restart) {
                before = x;
                v += dt * a;
                x += dt * v;
                return;
            }
            const T next = T(2) * x - before + dt * dt * a;
            v = next - x / (T(2) * dt);
            before = x;
            x = next;
        }

        Field<T> x_, before_, v_;  ///< absolute positions, those of the previous step, stored velocities
        Field<T> a_;
    };
};

}  // namespace steplab
