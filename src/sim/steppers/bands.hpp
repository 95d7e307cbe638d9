#pragma once

#include "sim/catalogue.hpp"
#include "sim/run/execution.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstddef>
#include <memory>

namespace steplab {

/// The method on a scene, with several threads where they help: long chains and large grids are divided into bands, for
/// methods whose steps have a bounded reach; forces between many pairs with a cut-off, and of springs between any
/// particles, are summed in parallel. Many of the latter are stepped in an order of their own (reordered.hpp).
std::unique_ptr<Stepper> make_stepper(const Method& method, const StepperSetup& setup, const Execution& execution);
/// The number of threads that it steps with.
std::size_t threads_for(const Method& method, const StepperSetup& setup, const Execution& execution);

}  // namespace steplab
