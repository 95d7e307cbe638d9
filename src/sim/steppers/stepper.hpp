#pragma once

#include "core/collision.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/instructions.hpp"
#include "core/own_stop.hpp"
#include "core/precision.hpp"
#include "core/start.hpp"
#include "models/plan.hpp"

#include <any>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// Some particles as seen from outside: from `place` on, `state` holds the particles from `first` on.
struct Portion {
    std::size_t first, count;
    const State<double>& state;  ///< displacement and velocity of one time, each number one that the precision holds
    std::size_t place = 0;
    std::size_t part = 0;  ///< of the scene; only emit_parallel() has several
};
using PortionSink = std::function<void(const Portion&)>;

/// A method at work on a scene in one precision; the face behind which everything is static.
class Stepper {
public:
    virtual ~Stepper() = default;
    virtual void advance(std::uint64_t steps) = 0;
    /// True if every number of the internal state is finite.
    virtual bool finite() const = 0;
    virtual std::size_t particles() const = 0;
    /// Shows all particles at the present time, portion after portion in their order. Changes nothing.
    virtual void emit(const PortionSink& sink) const = 0;
    /// The same of parts of the scene, of which there are parts(), by threads of their own: portions of one part come
    /// in their order, those of different parts at the same time. Throws what the sink throws.
    virtual void emit_parallel(const PortionSink& sink) const { emit(sink); }
    virtual std::size_t parts() const { return 1; }
    /// The same as emit() in one piece; the memory of `out` is reused.
    void synchronised(State<double>& out) const;
    /// Accelerations computed since the stepper was made, start-up included.
    virtual std::uint64_t evaluations() const = 0;
    /// Collisions where a force jumps, as adaptive methods find them; their times since the stepper was made.
    virtual CollisionRecord collisions() const { return {}; }
    /// Where no step of the method met its tolerance. A number of its state is none then.
    virtual std::optional<OwnStop> stopped() const { return std::nullopt; }
    /// From here on the work of drag is counted beside the steps, no bit of which depends on it: of methods that can
    /// (Method::counts_drag). `coefficients`: c of each particle in their order [kg/s]; empty: no longer counted.
    virtual void count_drag_work(std::vector<double> coefficients) { static_cast<void>(coefficients); }
    /// Up to the present frame [J]: part of the internal state. It begins with 0 where the stepper was made.
    virtual double drag_work() const { return 0; }
    /// The internal state, to come back to; the memory of what `to` held before is used again.
    virtual void save(std::any& to) const = 0;
    virtual void restore(const std::any& saved) = 0;
    /// Size of the internal state.
    virtual std::size_t bytes() const = 0;

    /// How many springs far what happens to a particle reaches in one step; none: there is no such bound.
    virtual std::optional<std::size_t> reach() const = 0;
    /// Particles from `to` on become what those from `from` on are in a stepper of the same method, precision and
    /// layout that took as many steps.
    virtual void take_over(const Stepper& other, std::size_t from, std::size_t to, std::size_t count) = 0;
};

/// What a method needs to begin a segment.
struct StepperSetup {
    const Plan& scene;
    Start start;  ///< synchronised state to start from
    const ParameterValues& parameters;
    Precision precision;
    double dt;
    Instructions instructions = fastest_instructions();
};

}  // namespace steplab
