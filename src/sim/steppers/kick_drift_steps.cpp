#include "methods/engines/kick_drift.hpp"
#include "sim/ensemble/lane_stepper.hpp"
#include "sim/steppers/stepper_of.hpp"

// The steps of kicks and drifts on every layout of forces, alone and in lanes: compiled once, for all methods that are
// such steps.

namespace steplab {

template std::unique_ptr<Stepper> make_stepper_with<KickDriftMethod, float>(const StepperSetup&, KickDriftSteps<float>);
template std::unique_ptr<Stepper> make_stepper_with<KickDriftMethod, double>(const StepperSetup&,
                                                                             KickDriftSteps<double>);
template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<KickDriftMethod, float>(
    std::span<const StepperSetup>, const KickDriftSteps<InLanes<float>>&);
template std::unique_ptr<EnsembleStepper> make_lane_stepper_with<KickDriftMethod, double>(
    std::span<const StepperSetup>, const KickDriftSteps<InLanes<double>>&);

}  // namespace steplab
