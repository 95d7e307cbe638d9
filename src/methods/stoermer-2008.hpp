#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/synchronised.hpp"
#include "methods/stoermer.hpp"

#include <utility>

namespace steplab {

/// The Störmer method of the thesis as its program was printed, mistake included (docs/curiosities.md): the velocity at
/// the end of a step uses the acceleration of the previous substep. It works on absolute positions with the plain force
/// loop.
struct Stoermer2008 {
    static constexpr ParameterInfo parameters[] = {Stoermer::substeps};

    static constexpr MethodInfo info{
        .id = "stoermer-2008",
        .name = "Störmer as printed in 2008",
        .what =
            "A curiosity: Störmer with an outdated acceleration at the end of each step; it gains energy. Not for "
            "production runs.",
        .order = 1,
        .order_with_drag = 1,
        .evaluations = 1,
        .linear_limit = 0,
        .curiosity = true,
        .conserves = "momentum",
        .source = "Sosnowski, thesis, UMK Toruń 2008, listing of Störmer",
        .parameters = parameters,
    };

    template <class T>
    class Integrator : public Synchronised<T> {
    public:
        static constexpr IntegratorCapabilities capabilities{.forcing = Forcing::plain, .emits = true};

        explicit Integrator(const ParameterValues& values) : substeps_(values.count("substeps")) {}

        template <class System>
        void start(System&, const State<T>& state) {
            this->begin(state);
            before_ = Field<T>(x_.count());
            a_ = Field<T>(x_.count());
        }

        template <class System>
        void step(System& system) {
            const T h = system.dt() / static_cast<T>(substeps_), f = system.drag() * h / T(2);
            evaluate(system);
            each_number([=](T& x, T& before, T v, T a) {
                before = x;
                x += h * ((T(1) - f) * v + h / T(2) * a);
            });
            for (std::size_t substep = 1; substep < substeps_; ++substep) {
                evaluate(system);
                each_number([=](T& x, T& before, T, T a) {
                    before = (T(2) * x - (T(1) - f) * before + h * h * a) / (T(1) + f);
                    std::swap(x, before);
                });
            }
            each_number([=](T& x, T& before, T& v, T a) { v = ((x - before) / h + h / T(2) * a) / (T(1) + f); });
        }

    private:
        using Synchronised<T>::x_, Synchronised<T>::v_;

        template <class System>
        void evaluate(System& system) {
            system.accelerations(x_, a_);
        }

        template <class F>
        void each_number(F f) {
            for (std::size_t k = 0; k < x_.flat().size(); ++k) {
                f(x_.flat()[k], before_.flat()[k], v_.flat()[k], a_.flat()[k]);
            }
        }

        Field<T> before_, a_;
        std::size_t substeps_;
    };
};

}  // namespace steplab
