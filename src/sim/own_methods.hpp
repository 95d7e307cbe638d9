#pragma once

#include "sim/catalogue.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// What a step of a method of one's own works on. All spans have the same length: three components of every particle,
/// in an order of the scene's own, and padding that is zero; steps treat them element by element.
class OwnMotion {
public:
    virtual ~OwnMotion() = default;
    virtual double dt() const = 0;
    /// Displacements from the reference positions [m], and velocities [m/s]: what the step changes.
    virtual std::span<double> positions() = 0;
    virtual std::span<double> velocities() = 0;
    /// a(x) - gamma v [m/s^2] there: one evaluation. Valid until the next one.
    virtual std::span<const double> accelerations(std::span<const double> positions,
                                                  std::span<const double> velocities) = 0;
    /// Memory for intermediate values by its number; what it holds is not part of the state.
    virtual std::span<double> scratch(std::size_t number) = 0;
};

/// The step of a method of one's own: used by several runs and threads at once, so it keeps nothing.
class OwnSteps {
public:
    virtual ~OwnSteps() = default;
    virtual void step(OwnMotion& motion) const = 0;
};

/// How such a method describes itself.
struct OwnMethodDescription {
    std::string id, name, what;
    int order = 1;
    int order_with_drag = 1;
    int evaluations = 1;  ///< of the forces per step
    bool symplectic = false, reversible = false;
};

/// Adds a method to those that method() finds, for as long as the program runs; methods() stays what it is. Its runs
/// are in double, on scenes without dashpots. Its stability limit is measured here. Throws UsageError if the id is
/// taken or no word in lower case, or a number is out of range.
void add_own_method(const OwnMethodDescription& description, std::shared_ptr<const OwnSteps> steps);

/// The one with this id; null if there is none.
const Method* own_method(std::string_view id);
/// The ids of all of them.
std::vector<std::string_view> own_method_ids();

/// What makes their steppers in an instruction set; null where it was not compiled.
using MakeOwnStepper = std::unique_ptr<Stepper> (*)(const StepperSetup& setup, std::shared_ptr<const OwnSteps> steps);
MakeOwnStepper own_stepper_maker(Instructions instructions);

}  // namespace steplab
