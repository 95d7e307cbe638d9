#pragma once

#include "methods/engines/halved_steps.hpp"
#include "methods/engines/implicit_stage.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/synchronised.hpp"

namespace steplab {

/// The trapezoidal rule to t + gamma h, gamma = 2 - sqrt(2), then the second backward difference formula to t + h: one
/// diagonally implicit Runge-Kutta method of two implicit stages (Hosea, Shampine 1996, table 1).
struct TrBdf2 {
    static constexpr ParameterInfo parameters[] = {compensated_sums};

    static std::optional<std::string> refusal(const Coupling& coupling) { return refusal_by_linear_solver(coupling); }
    static double bytes_of_interactions(const Coupling& coupling, const Interactions& interactions) {
        return bytes_of_linear_solver(coupling, interactions);
    }

    static constexpr double gamma = 0.58578643762690497;   // 2 - sqrt(2)
    static constexpr double diagonal = gamma / 2;          // weight of a stage's own derivative
    static constexpr double before = 0.35355339059327379;  // sqrt(2) / 4: weight of the two earlier derivatives

    static constexpr MethodInfo info{
        .id = "tr-bdf2",
        .name = "TR-BDF2",
        .what = "For stiff scenes: stable at any dt; motion that dt cannot resolve is damped.",
        .order = 2,
        .order_with_drag = 2,
        .order_with_damping = 2,
        .evaluations = 8,
        .start_evaluations = 1,
        .linear_limit = infinity,
        .implicit = true,
        .conserves = "momentum",
        .source =
            "Bank et al., IEEE Trans. Electron Devices 32 (1985) 1992; Hosea, Shampine, Appl. Numer. Math. 20 (1996) "
            "21",
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
            const std::size_t count = x_.count();
            stage_ = ImplicitStage<T>(system.force().coupling());
            for (Field<T>* field : {&slope_, &first_, &second_, &from_x_, &from_v_}) *field = Field<T>(count);
            system.accelerations(x_, slope_);
            T* const slope = slope_.flat().data();
            const T* const v = v_.flat().data();
            elementwise(x_.flat().size(), [=, drag = system.drag()](std::size_t k) { slope[k] -= drag * v[k]; });
            if (system.damped()) system.add_damping(x_, v_, slope_);
        }

        template <class System>
        void step(System& system) {
            step_in_halves(system.dt(), v_, [&](T h) { return attempt(system, h); });
        }

        template <class Self, class F>
        static void each_part(Self& self, F f) {
            Synchronised<T>::each_part(self, f);
            f(self.slope_);
        }

    private:
        using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;

        template <class System>
        bool attempt(System& system, T h) {
            const T tau = static_cast<T>(diagonal) * h;
            begin_first_stage(tau);
            if (!stage_.solve(system, from_x_, from_v_, tau, first_)) return false;
            begin_second_stage(h, tau);
            if (!stage_.solve(system, from_x_, from_v_, tau, second_)) return false;
            if (drag_.on()) count_drag(h, tau);
            finish(h, tau);
            return true;
        }

        void begin_first_stage(T tau) {
            const T *const x = x_.flat().data(), *const v = v_.flat().data(), *const slope = slope_.flat().data();
            T *const from_x = from_x_.flat().data(), *const from_v = from_v_.flat().data();
            elementwise(x_.flat().size(), [=](std::size_t k) {
                from_x[k] = x[k] + tau * v[k];
                from_v[k] = v[k] + tau * slope[k];
            });
        }

        /// The velocity of the first stage is from_v + first, its slope first / tau.
        void begin_second_stage(T h, T tau) {
            const T *const x = x_.flat().data(), *const v = v_.flat().data(), *const slope = slope_.flat().data();
            const T* const first = first_.flat().data();
            T *const from_x = from_x_.flat().data(), *const from_v = from_v_.flat().data();
            const T weight = static_cast<T>(before) * h, of_first = weight / tau;
            elementwise(x_.flat().size(), [=](std::size_t k) {
                from_x[k] = x[k] + weight * (v[k] + (from_v[k] + first[k]));
                from_v[k] = v[k] + (weight * slope[k] + of_first * first[k]);
            });
        }

        /// By the weights of the derivatives.
        void count_drag(T h, T tau) {
            const auto number = [](const Field<T>& field, std::size_t k) { return to_double(field.flat()[k]); };
            const auto first_v = [&](std::size_t k) {
                return number(v_, k) + to_double(tau) * number(slope_, k) + number(first_, k);
            };
            const auto last_v = [&](std::size_t k) { return number(from_v_, k) + number(second_, k); };
            const double earlier = drag_.power(v_) + drag_.power_of(v_, first_v), last = drag_.power_of(v_, last_v);
            drag_.add(to_double(h) * (before * earlier + diagonal * last));
        }

        void finish(T h, T tau) {
            T *const x = x_.flat().data(), *const v = v_.flat().data(), *const slope = slope_.flat().data();
            const T *const first = first_.flat().data(), *const second = second_.flat().data();
            const T weight = static_cast<T>(before) * h, of_first = weight / tau;
            const auto change_of_x = [=](std::size_t k) {
                const T first_v = (v[k] + tau * slope[k]) + first[k];
                const T last_v = (v[k] + (weight * slope[k] + of_first * first[k])) + second[k];
                return weight * (v[k] + first_v) + tau * last_v;
            };
            const auto change_of_v = [=](std::size_t k) {
                return (weight * slope[k] + of_first * first[k]) + second[k];
            };
            if (lost_.kept()) {
                T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
                return elementwise(x_.flat().size(), [=](std::size_t k) {
                    add_compensated(x[k], lost_x[k], change_of_x(k));
                    add_compensated(v[k], lost_v[k], change_of_v(k));
                    slope[k] = second[k] / tau;
                });
            }
            elementwise(x_.flat().size(), [=](std::size_t k) {
                x[k] += change_of_x(k);
                v[k] += change_of_v(k);
                slope[k] = second[k] / tau;
            });
        }

        ImplicitStage<T> stage_;
        Field<T> slope_;            ///< a - gamma v at x, v
        Field<T> first_, second_;   ///< changes of velocity computed by the two stages
        Field<T> from_x_, from_v_;  ///< starting values of a stage
    };
};

}  // namespace steplab
