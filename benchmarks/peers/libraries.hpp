#pragma once

#include "../c_libraries.hpp"
#include "../loops.hpp"
#include "../planet_loops.hpp"
#include "solver.hpp"

#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <gsl/gsl_odeiv2.h>
#include <memory>
#include <stdexcept>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab::benchmark {

// How each library is driven, over one of the loops: included by a source file for each way to write the force, because
// these are compiled with different flags.

namespace odeint = boost::numeric::odeint;
using Numbers = std::vector<double>;

template <class Loop>
Loop loop_of(const Problem& problem) {
    if constexpr (std::is_constructible_v<Loop, const std::vector<double>&>) return Loop(problem.strengths);
    return {};
}

template <class Loop>
struct Case {
    double time;
    std::size_t n;
    Force<Loop> force;
    Numbers x, v;
    std::size_t most_steps;

    explicit Case(const Problem& problem)
        : time(problem.time),
          n(problem.positions.size()),
          force{n, loop_of<Loop>(problem)},
          x(placed<Loop>(problem.positions)),
          v(placed<Loop>(problem.velocities)),
          most_steps(problem.most_steps) {}

    Numbers state() const {
        Numbers both = x;
        both.insert(both.end(), v.begin(), v.end());
        return both;
    }
    std::vector<Vec3> points(const double* numbers) const {
        std::vector<Vec3> out(n);
        for (std::size_t i = 0; i < n; ++i)
            out[i] = {numbers[Loop::place(n, i, 0)], numbers[Loop::place(n, i, 1)], numbers[Loop::place(n, i, 2)]};
        return out;
    }
};

/// What odeint calls after every step: nothing else ends a run whose steps become ever shorter.
class StepLimit {
public:
    explicit StepLimit(std::size_t most) : left_(most) {}
    void operator()(const Numbers&, double) {
        if (left_-- == 0) throw std::runtime_error("too many steps");
    }

private:
    std::size_t left_;
};

template <class Loop, class Stepper>
Solver odeint_adaptive(std::string name, const Case<Loop>& c) {
    return {"odeint " + std::move(name), true, [c](double tolerance) {
                Numbers state = c.state();
                odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, Stepper()), c.force, state,
                                           0.0, c.time, 0.01, StepLimit(c.most_steps));
                return c.points(state.data());
            }};
}

/// `relative`: the tolerance is also one relative to the state and its slope.
template <class Loop>
Solver odeint_bulirsch_stoer(std::string name, bool relative, const Case<Loop>& c) {
    return {"odeint " + std::move(name), true, [c, relative](double tolerance) {
                Numbers state = c.state();
                odeint::bulirsch_stoer<Numbers> stepper(tolerance, relative ? tolerance : 0.0, 1.0, 1.0);
                odeint::integrate_adaptive(stepper, c.force, state, 0.0, c.time, 0.1, StepLimit(c.most_steps));
                return c.points(state.data());
            }};
}

template <class Loop, class Stepper>
Solver odeint_fixed(std::string name, const Case<Loop>& c) {
    return {"odeint " + std::move(name), false, [c](double steps) {
                Numbers state = c.state();
                Stepper stepper;
                const Force<Loop> force = c.force;
                const double dt = c.time / steps;
                for (double i = 0; i < steps; ++i) stepper.do_step(force, state, i * dt, dt);
                return c.points(state.data());
            }};
}

template <class Loop, class Stepper>
Solver odeint_pair(std::string name, const Case<Loop>& c) {
    return {"odeint " + std::move(name), false, [c](double steps) {
                Numbers x = c.x, v = c.v;
                Stepper stepper;
                const Force<Loop> force = c.force;
                const double dt = c.time / steps;
                for (double i = 0; i < steps; ++i)
                    stepper.do_step(force, std::make_pair(std::ref(x), std::ref(v)), i * dt, dt);
                return c.points(x.data());
            }};
}

template <class Loop>
Solver gsl_adaptive(std::string name, const gsl_odeiv2_step_type* type, const Case<Loop>& c) {
    return {"GSL " + std::move(name), true, [c, type](double tolerance) {
                Numbers state = c.state();
                Force<Loop> force = c.force;
                gsl_odeiv2_system system{gsl_rates<Loop>, nullptr, state.size(), &force};
                const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
                    gsl_odeiv2_driver_alloc_y_new(&system, type, 0.01, tolerance, tolerance), gsl_odeiv2_driver_free);
                gsl_odeiv2_driver_set_nmax(driver.get(), c.most_steps);
                double t = 0;
                if (gsl_odeiv2_driver_apply(driver.get(), &t, c.time, state.data()) != GSL_SUCCESS)
                    throw std::runtime_error("GSL gave up");
                return c.points(state.data());
            }};
}

template <class Loop>
Solver sundials_erk(int order, const Case<Loop>& c) {
    return {"SUNDIALS ERKStep " + std::to_string(order), true, [c, order](double tolerance) {
                const SundialsContext context;
                Numbers state = c.state();
                Force<Loop> force = c.force;
                const N_Vector y = vector_over(state, context);
                void* memory = ERKStepCreate(sundials_rates<Loop>, 0, y, context.context);
                succeeded(ERKStepSetOrder(memory, order));
                succeeded(ERKStepSStolerances(memory, tolerance, tolerance));
                succeeded(ERKStepSetUserData(memory, &force));
                succeeded(ERKStepSetErrFile(memory, nullptr));
                succeeded(ERKStepSetMaxNumSteps(memory, static_cast<long>(c.most_steps)));
                succeeded(ERKStepSetStopTime(memory, c.time));
                realtype t = 0;
                const int result = ERKStepEvolve(memory, c.time, y, &t, ARK_NORMAL);
                ERKStepFree(&memory);
                N_VDestroy(y);
                succeeded(result);
                return c.points(state.data());
            }};
}

template <class Loop>
Solver sundials_adams(const Case<Loop>& c) {
    return {"SUNDIALS CVODE Adams", true, [c](double tolerance) {
                const SundialsContext context;
                Numbers state = c.state();
                Force<Loop> force = c.force;
                const N_Vector y = vector_over(state, context);
                void* memory = CVodeCreate(CV_ADAMS, context.context);
                succeeded(CVodeInit(memory, sundials_rates<Loop>, 0, y));
                succeeded(CVodeSStolerances(memory, tolerance, tolerance));
                succeeded(CVodeSetUserData(memory, &force));
                succeeded(CVodeSetErrFile(memory, nullptr));
                succeeded(CVodeSetMaxNumSteps(memory, static_cast<long>(c.most_steps)));
                SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(y, 0, context.context);
                succeeded(CVodeSetNonlinearSolver(memory, solver));
                succeeded(CVodeSetStopTime(memory, c.time));
                realtype t = 0;
                const int result = CVode(memory, c.time, y, &t, CV_NORMAL);
                CVodeFree(&memory);
                SUNNonlinSolFree(solver);
                N_VDestroy(y);
                succeeded(result);
                return c.points(state.data());
            }};
}

template <class Loop>
std::vector<Solver> odeint_solvers(const Case<Loop>& c) {
    using Fehlberg = odeint::runge_kutta_fehlberg78<Numbers>;
    using CashKarp = odeint::runge_kutta_cash_karp54<Numbers>;
    using Dopri = odeint::runge_kutta_dopri5<Numbers>;
    return {odeint_fixed<Loop, Fehlberg>("fehlberg78 fixed", c),
            odeint_adaptive<Loop, Fehlberg>("fehlberg78", c),
            odeint_fixed<Loop, CashKarp>("cash_karp54 fixed", c),
            odeint_adaptive<Loop, CashKarp>("cash_karp54", c),
            odeint_adaptive<Loop, Dopri>("dopri5", c),
            odeint_fixed<Loop, odeint::runge_kutta4<Numbers>>("rk4", c),
            odeint_fixed<Loop, odeint::adams_bashforth_moulton<5, Numbers>>("adams 5", c),
            odeint_fixed<Loop, odeint::adams_bashforth_moulton<8, Numbers>>("adams 8", c),
            odeint_bulirsch_stoer("bulirsch_stoer", true, c),
            odeint_bulirsch_stoer("bulirsch_stoer absolute", false, c),
            odeint_pair<Loop, odeint::velocity_verlet<Numbers>>("velocity_verlet", c),
            odeint_pair<Loop, odeint::symplectic_rkn_sb3a_mclachlan<Numbers>>("sb3a", c)};
}

/// Without those that ask for the Jacobian, which are for stiff systems.
template <class Loop>
std::vector<Solver> gsl_solvers(const Case<Loop>& c) {
    gsl_set_error_handler_off();
    return {gsl_adaptive<Loop>("rk8pd", gsl_odeiv2_step_rk8pd, c),
            gsl_adaptive<Loop>("rkf45", gsl_odeiv2_step_rkf45, c),
            gsl_adaptive<Loop>("rkck", gsl_odeiv2_step_rkck, c),
            gsl_adaptive<Loop>("rk4", gsl_odeiv2_step_rk4, c),
            gsl_adaptive<Loop>("rk2", gsl_odeiv2_step_rk2, c),
            gsl_adaptive<Loop>("msadams", gsl_odeiv2_step_msadams, c)};
}

template <class Loop>
std::vector<Solver> solvers_with(const Problem& problem) {
    const Case<Loop> c(problem);
    std::vector<Solver> all = odeint_solvers(c);
    for (Solver& solver : gsl_solvers(c)) all.push_back(std::move(solver));
    for (const int order : {2, 3, 4, 5, 6, 8}) all.push_back(sundials_erk<Loop>(order, c));
    all.push_back(sundials_adams<Loop>(c));
    return all;
}

template <class Chain, class Mesh, class Morse, class Sun, class Planets>
std::vector<Solver> solvers_of(const Problem& problem) {
    if (problem.scene == "chain") return solvers_with<Chain>(problem);
    if (problem.scene == "mesh") return solvers_with<Mesh>(problem);
    if (problem.scene == "kepler") return solvers_with<Sun>(problem);
    if (problem.scene == "outer-solar-system") return solvers_with<Planets>(problem);
    return solvers_with<Morse>(problem);
}

}  // namespace steplab::benchmark
