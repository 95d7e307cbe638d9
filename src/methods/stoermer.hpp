#pragma once

#include "core/entry.hpp"
#include "methods/three_point.hpp"

namespace steplab {

/// Störmer's rule: z substeps of the three-point rule, started and ended with velocities at full steps.
struct Stoermer {
    static constexpr ParameterInfo substeps{.name = "substeps",
                                            .kind = ParameterInfo::Kind::integer,
                                            .unit = "",
                                            .minimum = 1,
                                            .maximum = 1000000,
                                            .default_value = 10,
                                            .what = "substeps z of a step",
                                            .slider_low = 1,
                                            .slider_high = 50};
    static constexpr ParameterInfo parameters[] = {substeps, compensated_sums};

    static constexpr MethodInfo info{
        .id = "stoermer",
        .name = "Störmer",
        .what = "Verlet in substeps: z times the work, z² times smaller errors, z times the stable dt.",
        .order = 2,
        .order_with_drag = 2,
        .evaluations = 1,
        .start_evaluations = 1,
        .linear_limit = 2,
        .symplectic = true,
        .reversible = true,
        .conserves = "momentum, angular momentum, energy within bounds",
        .source = "Störmer 1907; Press et al., Numerical Recipes, 17.4",
        .parameters = parameters,
    };

    template <class T>
    class Integrator {
    public:
        explicit Integrator(const ParameterValues& values)
            : substeps_(values.count("substeps")), compensated_(values[compensated_sums.name] != 0) {}

        template <class System>
        void start(System& system, const State<T>& state) {
            points_ = ThreePoint<T>(state, compensated_);
            system.accelerations(points_.x, points_.a);
        }

        template <class System>
        void step(System& system) {
            const T h = system.dt() / static_cast<T>(substeps_), drag = system.drag();
            points_.first(h, drag);
            system.accelerations(points_.x, points_.a);
            for (std::size_t substep = 1; substep < substeps_; ++substep) {
                points_.next(h, drag);
                system.accelerations(points_.x, points_.a);
            }
            end_step(h, drag);
        }

        template <class System>
        void synchronised(const System&, State<T>& out) const {
            out.displacement = points_.x;
            out.velocity = points_.w;
        }

        template <class Self, class F>
        static void each_part(Self& self, F f) {
            ThreePoint<T>::each_part(self.points_, f);
        }

    private:
        void end_step(T h, T drag) {
            T* const v = points_.w.flat().data();
            const T* const a = points_.a.flat().data();
            elementwise(points_.w.flat().size(),
                        [=](std::size_t k) { v[k] = ThreePoint<T>::velocity(v[k], a[k], h, drag); });
        }

        ThreePoint<T> points_;
        std::size_t substeps_;
        bool compensated_;
    };
};

}  // namespace steplab
