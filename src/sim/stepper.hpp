#pragma once

#include "core/collision.hpp"
#include "core/entry.hpp"
#include "core/instructions.hpp"
#include "core/precision.hpp"
#include "models/model.hpp"

#include <any>
#include <cstdint>
#include <memory>

namespace steplab {

/// A method at work on a scene in one precision; the face behind which everything is static.
class Stepper {
public:
    virtual ~Stepper() = default;
    virtual void advance(std::uint64_t steps) = 0;
    /// True if every number of the internal state is finite.
    virtual bool finite() const = 0;
    /// Displacement and velocity of one time, each number one that the precision holds. Changes nothing.
    virtual void synchronised(State<double>& out) const = 0;
    /// Accelerations computed since the stepper was made, start-up included.
    virtual std::uint64_t evaluations() const = 0;
    /// Collisions where a force jumps, as adaptive methods find them; their times since the stepper was made.
    virtual CollisionRecord collisions() const { return {}; }
    /// The internal state, to come back to; the memory of what `to` held before is used again.
    virtual void save(std::any& to) const = 0;
    virtual void restore(const std::any& saved) = 0;
    /// Size of the internal state.
    virtual std::size_t bytes() const = 0;
};

/// What a method needs to begin a segment.
struct StepperSetup {
    const Scene& scene;
    const State<double>& state;  ///< synchronised state to start from
    const ParameterValues& parameters;
    Precision precision;
    double dt;
    Instructions instructions = fastest_instructions();
};

}  // namespace steplab
