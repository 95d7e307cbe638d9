#pragma once

#include "models/model.hpp"
#include "sim/stepper.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace steplab {

/// A method: how it describes itself and how its integrator is made.
struct Method {
    MethodInfo info;
    std::unique_ptr<Stepper> (*make)(const StepperSetup&);
};

/// All models and methods in the order of their lists (src/models/list.cmake, src/methods/list.cmake).
std::span<const Model> models();
std::span<const Method> methods();

/// The one with this id. Throws UsageError that names the nearest and all known ids.
const Model& model(std::string_view id);
const Method& method(std::string_view id);

}  // namespace steplab
