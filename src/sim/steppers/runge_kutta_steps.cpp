#include "methods/engines/runge_kutta_steps.hpp"

#include "sim/ensemble/lane_stepper.hpp"

// The steps of explicit Runge-Kutta methods in lanes, on every layout of forces: compiled once, for all such methods.

namespace steplab {

template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<RungeKuttaMethod, float>(
    std::span<const StepperSetup>, const RungeKuttaSteps<InLanes<float>>&);
template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<RungeKuttaMethod, double>(
    std::span<const StepperSetup>, const RungeKuttaSteps<InLanes<double>>&);

}  // namespace steplab
