#pragma once

#include "methods/engines/moving_axes.hpp"
#include "methods/engines/runge_kutta_steps.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "sim/ensemble/ensemble_stepper.hpp"
#include "sim/ensemble/lanes_of_runs.hpp"
#include "sim/steppers/method_check.hpp"
#include "sim/steppers/stepper_of.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace steplab {

/// A method in one precision on one layout of forces, for a run in each lane.
template <class Method, class T, template <class> class Force>
class LaneStepper final : public EnsembleStepper {
public:
    using N = InLanes<T>;

    /// At least one run, at most N::count. Lanes without a run of their own repeat the last one.
    template <class Forces>
    LaneStepper(std::span<const StepperSetup> runs, const std::vector<Forces>& forces,
                typename Method::template Integrator<N> integrator)
        : runs_(runs.size()),
          system_(forces_in_lanes<Force, T>(forces), drag_in_lanes<T>(runs), dt_in_lanes<T>(runs)),
          integrator_(std::move(integrator)) {
        std::vector<State<T>> starts;
        for (const StepperSetup& run : runs) starts.push_back(run.start.template state<T>());
        start(starts);
    }

    std::size_t runs() const override { return runs_; }

    void advance(std::uint64_t steps) override {
        integrator_.advance(system_, steps);
        forget();
    }

    void restart(std::span<const State<double>> states) override {
        std::vector<State<T>> starts;
        for (const State<double>& state : states)
            starts.push_back({converted<T>(state.displacement), converted<T>(state.velocity)});
        start(starts);
        forget();
    }

    std::uint64_t evaluations() const override { return system_.evaluations(); }

    bool finite(std::size_t run) const override {
        if (!finite_known_) differences_ = sum_of_differences();
        finite_known_ = true;
        return differences_[run] == T(0);
    }

    double energy_bound(std::size_t run) const override {
        if constexpr (Force<N>::capabilities.bounds_energy) {
            if (!bound_known_) bound_ = kinetic(seen().velocity) + system_.force().elastic_bound(seen().displacement);
            bound_known_ = true;
            return static_cast<double>(bound_[run]);
        } else {
            return infinity;
        }
    }

    void synchronised(std::size_t run, State<double>& out) const override {
        take_lane(seen().displacement, run, out.displacement);
        take_lane(seen().velocity, run, out.velocity);
    }

    void along(const Field<double>& shape, const Field<double>& origin, std::span<Along> out) const override {
        const auto x = sums_along(shape, seen().displacement,
                                  [&](std::size_t k, double number) { return number - origin.flat()[k]; });
        const auto v = sums_along(shape, seen().velocity, [](std::size_t, double number) { return number; });
        for (std::size_t run = 0; run < runs_; ++run) out[run] = {x[run], v[run]};
    }

private:
    using Integrator = typename Method::template Integrator<N>;

    void start(const std::vector<State<T>>& states) {
        State<N> all = state_in_lanes(states);
        system_.axes(axes_of_steps(system_.force(), all));
        integrator_.start(system_, std::move(all));
    }

    void forget() { seen_known_ = finite_known_ = bound_known_ = false; }

    const State<N>& seen() const {
        if (!seen_known_) integrator_.synchronised(system_, seen_);
        seen_known_ = true;
        return seen_;
    }

    /// Zero in the lanes of runs all of whose numbers are finite: only these are zero less themselves.
    N sum_of_differences() const {
        N sum(T(0));
        Integrator::each_part(integrator_, [&](const Field<N>& part) {
            for (const N& number : part.flat()) sum += number - number;
        });
        return sum;
    }

    template <class F>
    static std::array<double, N::count> sums_along(const Field<double>& shape, const Field<N>& field, F of) {
        std::array<double, N::count> sums{};
        alignas(64) std::array<T, N::count> numbers;
        for (std::size_t k = 0; k < field.flat().size(); ++k) {
            field.flat()[k].store(numbers.data());
            for (std::size_t lane = 0; lane < N::count; ++lane)
                sums[lane] += shape.flat()[k] * of(k, static_cast<double>(numbers[lane]));
        }
        return sums;
    }

    static N kinetic(const Field<N>& velocity) {
        N sum(T(0));
        for (const N& number : velocity.flat()) sum += number * number;
        return sum / N(T(2));
    }

    std::size_t runs_;
    System<N, Force<N>> system_;
    Integrator integrator_;
    // of the present time, once asked for
    mutable State<N> seen_;
    mutable N differences_, bound_;
    mutable bool seen_known_ = false, finite_known_ = false, bound_known_ = false;
};

template <class Method, class T, template <class> class Force, class Forces>
std::unique_ptr<EnsembleStepper> make_lane_stepper_on(
    std::span<const StepperSetup> runs, const Forces&,
    const typename Method::template Integrator<InLanes<T>>& integrator) {
    std::vector<Forces> forces;
    for (const StepperSetup& run : runs) forces.push_back(std::get<Forces>(run.scene.forces));
    return std::make_unique<LaneStepper<Method, T, Force>>(runs, forces, integrator);
}

/// Chooses the layout of forces.
template <class Method, class T>
std::unique_ptr<EnsembleStepper> make_lane_stepper_with(
    std::span<const StepperSetup> runs, const typename Method::template Integrator<InLanes<T>>& integrator) {
    const Forces& forces = runs.front().scene.forces;
    if (const auto* line = std::get_if<LineForces>(&forces))
        return make_lane_stepper_on<Method, T, Line>(runs, *line, integrator);
    if (const auto* grid = std::get_if<GridForces>(&forces))
        return make_lane_stepper_on<Method, T, Grid>(runs, *grid, integrator);
    if (const auto* pairs = std::get_if<PairForces>(&forces))
        return make_lane_stepper_on<Method, T, Pairs>(runs, *pairs, integrator);
    return nullptr;
}
// kick_drift_steps.cpp
extern template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<KickDriftMethod, float>(
    std::span<const StepperSetup>, const KickDriftSteps<InLanes<float>>&);
extern template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<KickDriftMethod, double>(
    std::span<const StepperSetup>, const KickDriftSteps<InLanes<double>>&);

/// What explicit Runge-Kutta methods are in lanes: one stepper serves them.
struct RungeKuttaMethod {
    template <class N>
    using Integrator = RungeKuttaSteps<N>;
};
// runge_kutta_steps.cpp
extern template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<RungeKuttaMethod, float>(
    std::span<const StepperSetup>, const RungeKuttaSteps<InLanes<float>>&);
extern template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<RungeKuttaMethod, double>(
    std::span<const StepperSetup>, const RungeKuttaSteps<InLanes<double>>&);

/// In lanes, the slopes of longer lines no longer fit the first-level cache; alone, such lines fill registers anyway.
template <class Method, class N>
bool is_too_long(const Plan& scene) {
    constexpr std::size_t longest = 64;
    return Method::template Integrator<N>::capabilities.forcing == Forcing::runge_kutta &&
           std::holds_alternative<LineForces>(scene.forces) && scene.reference.count > longest;
}

/// As many of the runs as have room; none if most lanes stayed empty, or if they are faster alone.
template <class Method, class T>
std::unique_ptr<EnsembleStepper> make_lane_stepper_in(std::span<const StepperSetup> all) {
    using N = InLanes<T>;
    const auto runs = all.first(std::min(all.size(), N::count));
    if (2 * runs.size() < N::count || is_too_long<Method, N>(runs.front().scene)) return nullptr;
    using Integrator = typename Method::template Integrator<N>;
    const ParameterValues& parameters = runs.front().parameters;
    if constexpr (Integrator::capabilities.forcing == Forcing::runge_kutta) {
        return make_lane_stepper_with<RungeKuttaMethod, T>(
            runs, RungeKuttaSteps<N>(Integrator::stages_of_steps(), parameters));
    } else if constexpr (Integrator::capabilities.forcing == Forcing::kick_drift) {
        const Integrator integrator(parameters);
        return make_lane_stepper_with<KickDriftMethod, T>(
            runs, kick_drift_steps(integrator, dt_in_lanes<T>(runs), drag_in_lanes<T>(runs)));
    } else {
        return make_lane_stepper_with<Method, T>(runs, Integrator(parameters));
    }
}

/// `runs`: at least one, all compatible (lane_compatible.hpp).
template <class Method>
std::unique_ptr<EnsembleStepper> make_ensemble_stepper(std::span<const StepperSetup> runs) {
    if constexpr (goes_in_lanes<Method>) {
        return runs.front().precision == Precision::float_ ? make_lane_stepper_in<Method, float>(runs)
                                                           : make_lane_stepper_in<Method, double>(runs);
    } else {
        return nullptr;
    }
}

}  // namespace steplab
