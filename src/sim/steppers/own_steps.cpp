#include "core/instruction_set.hpp"
#include "methods/engines/synchronised.hpp"
#include "sim/own_methods.hpp"
#include "sim/steppers/method_check.hpp"
#include "sim/steppers/stepper_of.hpp"

#include <algorithm>
#include <cassert>
#include <deque>
#include <utility>

// The steps of methods that are not of the catalogue, on every layout of forces. Compiled once for each instruction
// set.

namespace steplab::STEPLAB_INSTRUCTION_SET {

namespace {

/// The integrator of all of them, which differ in what their step calls.
struct OwnMethod {
    template <class T>
    class Integrator : public Synchronised<T> {
    public:
        static constexpr IntegratorCapabilities capabilities{.emits = true};

        explicit Integrator(const ParameterValues& values) : Synchronised<T>(values) {}
        explicit Integrator(std::shared_ptr<const OwnSteps> steps) : steps_(std::move(steps)) {}

        template <class System>
        void start(System&, const State<T>& state) {
            this->begin(state);
        }
        template <class System>
        void step(System& system) {
            Motion<System> motion(*this, system);
            steps_->step(motion);
        }

    private:
        using Synchronised<T>::x_, Synchronised<T>::v_;

        template <class System>
        class Motion final : public OwnMotion {
        public:
            Motion(Integrator& integrator, System& system) : own_(integrator), system_(system) {}
            double dt() const override { return system_.dt(); }
            std::span<double> positions() override { return own_.x_.flat(); }
            std::span<double> velocities() override { return own_.v_.flat(); }
            std::span<const double> accelerations(std::span<const double> x, std::span<const double> v) override {
                return own_.accelerations(system_, x, v);
            }
            std::span<double> scratch(std::size_t number) override { return own_.scratch(number); }

        private:
            Integrator& own_;
            System& system_;
        };

        template <class System>
        std::span<const double> accelerations(System& system, std::span<const double> x, std::span<const double> v) {
            assert(x.size() == x_.flat().size() && v.size() == x.size());
            const bool here = x.data() == x_.flat().data();
            if (a_.count() != x_.count()) a_ = Field<T>(x_.count());
            if (!here) {
                if (at_.count() != x_.count()) at_ = Field<T>(x_.count());
                std::copy(x.begin(), x.end(), at_.flat().begin());
            }
            system.accelerations(here ? x_ : at_, a_);
            const T drag = system.drag();
            if (drag != T(0)) {
                const std::span<T> a = a_.flat();
                for (std::size_t i = 0; i < a.size(); ++i) a[i] -= drag * v[i];
            }
            return a_.flat();
        }

        std::span<double> scratch(std::size_t number) {
            while (scratch_.size() <= number) scratch_.emplace_back(x_.count());
            return scratch_[number].flat();
        }

        std::shared_ptr<const OwnSteps> steps_;
        Field<T> at_, a_;               ///< where accelerations were computed, and they
        std::deque<Field<T>> scratch_;  ///< spans of those that are there stay valid
    };
};
static_assert(IntegratorOf<OwnMethod::Integrator<double>, double, System<double, ErasedForce<double>>>);

}  // namespace

std::unique_ptr<Stepper> make_own_stepper(const StepperSetup& setup, std::shared_ptr<const OwnSteps> steps);

std::unique_ptr<Stepper> make_own_stepper(const StepperSetup& setup, std::shared_ptr<const OwnSteps> steps) {
    return make_erased_stepper<OwnMethod, double>(setup, OwnMethod::Integrator<double>(std::move(steps)));
}

}  // namespace steplab::STEPLAB_INSTRUCTION_SET
