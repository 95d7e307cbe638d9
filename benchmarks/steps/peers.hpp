#pragma once

#include "../c_libraries.hpp"
#include "../composed_loops.hpp"
#include "../loops.hpp"
#include "hand_written.hpp"
#include "stepping.hpp"

#include <boost/array.hpp>
#include <boost/numeric/odeint.hpp>
#include <fmt/format.h>

#include <arkode/arkode_butcher.h>
#include <arkode/arkode_erkstep.h>
#include <gsl/gsl_odeiv2.h>
#include <memory>
#include <type_traits>
#include <utility>

namespace steplab::benchmark {

// How each peer steps with one of the loops: included by a source file for each precision.

namespace odeint = boost::numeric::odeint;

/// Adds a peer that is stepped by calling `step` of what `make` returns.
template <class Make>
void add(std::vector<Contestant>& to, std::string who, Make make) {
    to.push_back({std::move(who), [make] {
                      auto stepper = std::make_shared<decltype(make())>(make());
                      return Stepping{[stepper](std::size_t steps) {
                                          for (std::size_t i = 0; i < steps; ++i) stepper->step();
                                      },
                                      {}};
                  }});
}

template <class Loop, void (HandWritten<Loop>::*method)()>
struct ByHand {
    HandWritten<Loop> loops;
    void step() { (loops.*method)(); }
};

template <class Loop>
void add_hand_written(std::vector<Contestant>& to, const Problem& problem, const Loop& loop = {}) {
    const auto add_if = [&]<void (HandWritten<Loop>::*method)()>(std::string_view id) {
        if (problem.method != id) return;
        add(to, fmt::format("loops {}", Loop::way), [problem, loop] {
            return ByHand<Loop, method>{{placed<Loop>(problem.positions), placed<Loop>(problem.velocities),
                                         static_cast<typename Loop::Number>(problem.dt), loop}};
        });
    };
    add_if.template operator()<&HandWritten<Loop>::euler>("euler");
    add_if.template operator()<&HandWritten<Loop>::velocity_verlet>("velocity-verlet");
    add_if.template operator()<&HandWritten<Loop>::midpoint>("midpoint");
    add_if.template operator()<&HandWritten<Loop>::rk4>("rk4");
}

/// odeint with positions and velocities in two vectors.
template <class Loop, class Stepper>
struct OdeintPair {
    using Number = typename Loop::Number;
    typename Force<Loop>::Numbers x, v;
    Number dt;
    Loop loop{};
    Stepper stepper{};

    void step() {
        stepper.do_step(Force<Loop>{x.size() / 3, loop}, std::make_pair(std::ref(x), std::ref(v)), Number(0), dt);
    }
};

/// odeint with both in one vector.
template <class Loop, class Stepper>
struct OdeintVector {
    using Number = typename Loop::Number;
    typename Force<Loop>::Numbers state;
    Number dt;
    Stepper stepper;
    Loop loop{};

    void step() { stepper.do_step(Force<Loop>{state.size() / 6, loop}, state, Number(0), dt); }
};

template <class T>
using GenericMidpoint = odeint::explicit_generic_rk<2, 2, std::vector<T>, T, std::vector<T>, T>;

template <class T>
GenericMidpoint<T> generic_midpoint() {
    const boost::array<T, 1> a1{{T(0.5)}};
    const boost::array<T, 2> b{{T(0), T(1)}}, c{{T(0), T(0.5)}};
    return GenericMidpoint<T>(boost::fusion::make_vector(a1), b, c);
}

template <class Loop>
void add_odeint(std::vector<Contestant>& to, const Problem& problem, const Loop& loop = {}) {
    using T = typename Loop::Number;
    using Numbers = std::vector<T>;
    const std::string who = fmt::format("odeint {}", Loop::way);
    const auto add_pair = [&]<class Stepper>(std::type_identity<Stepper>) {
        add(to, who, [problem, loop] {
            return OdeintPair<Loop, Stepper>{placed<Loop>(problem.positions), placed<Loop>(problem.velocities),
                                             static_cast<T>(problem.dt), loop};
        });
    };
    const auto add_vector = [&](auto stepper) {
        add(to, who, [problem, stepper, loop] {
            return OdeintVector<Loop, decltype(stepper)>{placed<Loop>(problem.positions, problem.velocities),
                                                         static_cast<T>(problem.dt), stepper, loop};
        });
    };
    if (problem.method == "euler") add_pair(std::type_identity<odeint::symplectic_euler<Numbers, Numbers, T>>());
    if (problem.method == "velocity-verlet")
        add_pair(std::type_identity<odeint::velocity_verlet<Numbers, Numbers, T, Numbers, T>>());
    if (problem.method == "midpoint") add_vector(generic_midpoint<T>());
    if (problem.method == "rk4") add_vector(odeint::runge_kutta4<Numbers, T, Numbers, T>());
}

/// GSL's rk4, which estimates its error by half steps: 11 evaluations.
template <class Loop>
class GslRk4 {
public:
    explicit GslRk4(const Problem& problem)
        : dt_(problem.dt),
          force_(std::make_unique<Force<Loop>>(Force<Loop>{problem.positions.size()})),
          state_(placed<Loop>(problem.positions, problem.velocities)),
          error_(state_.size()),
          system_{gsl_rates<Loop>, nullptr, state_.size(), force_.get()},
          step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, state_.size()), gsl_odeiv2_step_free) {}

    void step() {
        gsl_odeiv2_step_apply(step_.get(), 0, dt_, state_.data(), error_.data(), nullptr, nullptr, &system_);
    }

private:
    double dt_;
    std::unique_ptr<Force<Loop>> force_;
    std::vector<double> state_, error_;
    gsl_odeiv2_system system_;
    std::unique_ptr<gsl_odeiv2_step, void (*)(gsl_odeiv2_step*)> step_;
};

/// The classic Runge-Kutta method for ARKODE. Its last c is a little below 1: with 1, ERKStep 6.4 takes the table for
/// one whose last slope is the next step's first.
inline ARKodeButcherTable classic_table() {
    double c[] = {0, 0.5, 0.5, 1 - 1e-9}, b[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    double a[] = {0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0};
    return ARKodeButcherTable_Create(4, 4, 0, c, a, b, nullptr);
}

template <class Loop>
class ArkodeRk4 {
public:
    explicit ArkodeRk4(const Problem& problem) : state_(std::make_unique<State>(problem)) {}
    void step() { succeeded(ERKStepEvolve(state_->memory, 1e300, state_->y, &state_->time, ARK_ONE_STEP)); }

private:
    struct State {
        explicit State(const Problem& problem)
            : force{problem.positions.size()},
              numbers(placed<Loop>(problem.positions, problem.velocities)),
              y(vector_over(numbers, context)),
              memory(ERKStepCreate(sundials_rates<Loop>, 0, y, context.context)) {
            const ARKodeButcherTable table = classic_table();
            succeeded(ERKStepSetTable(memory, table));
            ARKodeButcherTable_Free(table);
            succeeded(ERKStepSetFixedStep(memory, problem.dt));
            succeeded(ERKStepSetUserData(memory, &force));
        }
        ~State() {
            ERKStepFree(&memory);
            N_VDestroy(y);
        }
        State(const State&) = delete;
        State& operator=(const State&) = delete;

        SundialsContext context;
        Force<Loop> force;
        std::vector<double> numbers;
        N_Vector y;
        void* memory;
        realtype time = 0;
    };
    std::unique_ptr<State> state_;
};

template <class Loop>
void add_peers_with(std::vector<Contestant>& to, const Problem& problem) {
    add_hand_written<Loop>(to, problem);
    add_odeint<Loop>(to, problem);
    if constexpr (std::is_same_v<typename Loop::Number, double>) {
        if (problem.method != "rk4") return;
        add(to, fmt::format("GSL {}", Loop::way), [problem] { return GslRk4<Loop>(problem); });
        add(to, fmt::format("ARKODE {}", Loop::way), [problem] { return ArkodeRk4<Loop>(problem); });
    }
}

template <class T>
std::vector<Contestant> peers_in(const Problem& problem) {
    std::vector<Contestant> all;
    const auto add_both = [&]<class Plain, class Gather>(std::string_view model) {
        if (problem.model != model) return;
        add_peers_with<Plain>(all, problem);
        add_peers_with<Gather>(all, problem);
    };
    add_both.template operator()<PlainChain<T>, GatherChain<T>>("chain");
    add_both.template operator()<PlainMesh<T>, GatherMesh<T>>("mesh");
    add_both.template operator()<PlainMorse<T>, GatherMorse<T>>("morse");
    const auto add_composed = [&]<class Loop>(std::string_view model, const Loop& loop) {
        if (problem.model != model) return;
        add_hand_written<Loop>(all, problem, loop);
        add_odeint<Loop>(all, problem, loop);
    };
    add_composed("network", Network<T>{problem.springs});
    add_composed("liquid", Liquid<T>(problem.box));
    add_composed("gravity", PlainGravity<T>{});
    add_composed("gravity", GatherGravity<T>{});
    return all;
}

}  // namespace steplab::benchmark
