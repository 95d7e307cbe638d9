#pragma once

#include "sim/catalogue.hpp"
#include "sim/execution.hpp"
#include "sim/stepper.hpp"

#include <memory>

namespace steplab {

/// The method at work on a scene, by several threads where they pay: on chains and grids of many particles, by methods
/// whose steps reach only so far.
std::unique_ptr<Stepper> make_stepper(const Method& method, const StepperSetup& setup, const Execution& execution);

}  // namespace steplab
