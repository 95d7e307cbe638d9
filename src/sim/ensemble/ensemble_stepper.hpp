#pragma once

#include "core/field.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace steplab {

/// No group holds more runs.
inline constexpr std::size_t most_lanes = 16;

/// What of a state is along a shape: sums over all numbers, of shape * (displacement - origin) and of shape * velocity.
struct Along {
    double displacement = 0, velocity = 0;
};

/// Several runs of one method, each in a lane of vector registers: with the bits that it has alone.
class EnsembleStepper {
public:
    virtual ~EnsembleStepper() = default;
    /// Number of runs it holds: the first ones of those that were given.
    virtual std::size_t runs() const = 0;
    virtual void advance(std::uint64_t steps) = 0;
    /// Restarts at these states, one for each run, as a new stepper would.
    virtual void restart(std::span<const State<double>> starts) = 0;
    /// Accelerations computed for each run since the group was made.
    virtual std::uint64_t evaluations() const = 0;
    /// True if every number of the internal state of a run is finite.
    virtual bool finite(std::size_t run) const = 0;
    /// The kinetic and elastic energy of a run, in units of a particle's mass, is no larger, but for rounding: cheap,
    /// and far from sharp. Infinite where nothing of the kind is known.
    virtual double energy_bound(std::size_t run) const = 0;
    /// The state of a run at the present time, each number one that the precision holds. Changes nothing.
    virtual void synchronised(std::size_t run, State<double>& out) const = 0;
    /// The same of every run along a shape, in double and in the order of the numbers of a field: flat().
    virtual void along(const Field<double>& shape, const Field<double>& origin, std::span<Along> out) const = 0;
};

/// A method stepping runs that are compatible (lane_compatible.hpp), at least one: as many of the first ones as there
/// are lanes. Null if there are too few of them, or if each is faster alone.
using MakeEnsembleStepper = std::unique_ptr<EnsembleStepper> (*)(std::span<const StepperSetup> runs);

}  // namespace steplab
