#pragma once

#include "sim/steppers/stepper.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace steplab {

/// In which order the particles of a scene are stepped, each by its index in the scene: near each other in memory where
/// they are so in space, and beside others with as many springs. Empty where the order of the scene serves: of few
/// particles, and where not springs alone join them.
std::vector<std::uint32_t> order_by_place(const Plan& scene);

/// Makes the stepper of a setup whose particles stand in this order, and shows them in the order of the scene. Methods
/// of fixed steps give the bits that they give in the order of the scene.
std::unique_ptr<Stepper> make_reordered(const StepperSetup& setup, std::vector<std::uint32_t> order,
                                        const std::function<std::unique_ptr<Stepper>(const StepperSetup&)>& make);

}  // namespace steplab
