#pragma once

#include "sim/catalogue.hpp"
#include "sim/run/execution.hpp"
#include "sim/steppers/stepper.hpp"

#include <memory>

namespace steplab {

/// The method at work on a scene, by several threads where they pay: chains and grids of many particles are cut into
/// bands, by methods whose steps reach only so far; forces between many pairs with a cut-off are summed side by side.
std::unique_ptr<Stepper> make_stepper(const Method& method, const StepperSetup& setup, const Execution& execution);

}  // namespace steplab
