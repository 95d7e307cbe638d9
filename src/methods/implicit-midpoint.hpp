#pragma once

#include "methods/engines/halved_steps.hpp"
#include "methods/engines/implicit_stage.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/synchronised.hpp"

namespace steplab {

/// The implicit midpoint rule: x1 = x0 + h V, v1 = v0 + h (a(X) - gamma V) with X, V in the middle of the step.
struct ImplicitMidpoint {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static std::optional<std::string> refusal(const Coupling& coupling) { return refusal_by_linear_solver(coupling); }
    static double bytes_of_interactions(const Coupling& coupling, const Interactions& interactions) {
        return bytes_of_linear_solver(coupling, interactions);
    }

    static constexpr MethodInfo info{
        .id = "implicit-midpoint",
        .name = "Implicit midpoint",
        .what =
            "Conserves the energy of linear scenes exactly at any dt; stiff springs that rotate far in one step gain "
            "energy.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 4,
        .linear_limit = infinity,
        .symplectic = true,
        .reversible = true,
        .implicit = true,
        .conserves = "momentum, angular momentum; energy exactly on linear scenes",
        .source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, II.1.1, VI.4",
        .parameters = parameters,
        .refusal = refusal,
        .bytes_of_interactions = bytes_of_interactions,
    };

    template <class T>
    class Integrator : public Synchronised<T>, public CountsDragAtFrames {
    public:
        static constexpr IntegratorCapabilities capabilities{.emits = true, .drag_work = true};

        explicit Integrator(const ParameterValues& values) : Synchronised<T>(values) {}

        template <class System>
        void start(System& system, const State<T>& state) {
            this->begin(state);
            stage_ = ImplicitStage<T>(system.force().coupling());
            w_ = Field<T>(x_.count());
        }

        template <class System>
        void step(System& system) {
            step_in_halves(system.dt(), v_, [&](T h) { return attempt(system, h); });
        }

    private:
        using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;

        template <class System>
        bool attempt(System& system, T h) {
            if (!stage_.solve(system, x_, v_, h / T(2), w_)) return false;
            T *const x = x_.flat().data(), *const v = v_.flat().data();
            const T* const w = w_.flat().data();
            if (drag_.on()) {
                const auto middle = [v, w](std::size_t k) { return to_double(v[k]) + to_double(w[k]); };
                drag_.add(to_double(h) * drag_.power_of(v_, middle));
            }
            if (lost_.kept()) {
                T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
                elementwise(x_.flat().size(), [=](std::size_t k) {
                    add_compensated(x[k], lost_x[k], h * (v[k] + w[k]));
                    add_compensated(v[k], lost_v[k], T(2) * w[k]);
                });
                return true;
            }
            elementwise(x_.flat().size(), [=](std::size_t k) {
                x[k] += h * (v[k] + w[k]);
                v[k] += T(2) * w[k];
            });
            return true;
        }

        ImplicitStage<T> stage_;
        Field<T> w_;  ///< change of velocity up to the middle of the step
    };
};

}  // namespace steplab
