#pragma once

#include "methods/engines/step_parts.hpp"
#include "models/model.hpp"
#include "sim/ensemble/ensemble_stepper.hpp"
#include "sim/steppers/stepper.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

namespace steplab {

/// A method: how it describes itself and how its integrator is made.
struct Method {
    MethodInfo info;
    /// Its integrator for each of the instruction sets that were compiled, null for the others: all are in a catalogue
    /// that only describes (off-screen modules).
    std::array<std::unique_ptr<Stepper> (*)(const StepperSetup&), 3> makers;
    /// The same for the runs of an ensemble in SIMD lanes; null for methods that have none.
    std::array<MakeEnsembleStepper, 3> ensemble_makers;
    StepParts parts;
    bool counts_drag = false;  ///< its steppers can count the work of drag

    std::unique_ptr<Stepper> make(const StepperSetup& setup) const {
        return makers[static_cast<std::size_t>(setup.instructions)](setup);
    }
    /// Whether the method can compute runs in SIMD lanes.
    bool runs_in_lanes(Instructions instructions) const {
        return ensemble_makers[static_cast<std::size_t>(instructions)] != nullptr;
    }
    std::unique_ptr<EnsembleStepper> make_ensemble_stepper(std::span<const StepperSetup> runs) const {
        return ensemble_makers[static_cast<std::size_t>(runs.front().instructions)](runs);
    }
};

/// All models and methods in the order of their lists (src/models/list.cmake, src/methods/list.cmake).
std::span<const Model> models();
std::span<const Method> methods();

/// The one with this id. Throws UsageError that names the nearest and all known ids.
const Model& model(std::string_view id);
const Method& method(std::string_view id);

}  // namespace steplab
