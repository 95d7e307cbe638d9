#pragma once

#include "core/diagnostics.hpp"
#include "core/field.hpp"
#include "core/instructions.hpp"
#include "core/sum.hpp"
#include "models/model.hpp"
#include "sim/energy_sums.hpp"
#include "sim/stepper.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace steplab {

/// Kinetic and potential energy of one state, in the parts the check of divergence needs.
struct Energy {
    double kinetic = 0;
    PotentialEnergy potential;

    double total() const { return kinetic + potential.value; }
};

/// The sum of the squares of vectors, whichever portions they come in.
class SquareSum {
public:
    /// So many vectors, at most, are held at a time.
    SquareSum(const EnergySums& sums, std::size_t most) : sums_(&sums), held_(std::max<std::size_t>(1, most)) {}

    void add(const Field<double>& from, std::size_t first, std::size_t count);
    /// Of all since the last call.
    double take();

private:
    void finish_piece();

    const EnergySums* sums_;
    Field<double> held_;
    std::size_t count_ = 0;
    CompensatedSum sum_;
};

/// Computes sums over a scene's particles in double. Chains and grids are taken piece by piece, each of as many
/// particles whoever asks, so that neither memory for all of them is needed nor does it matter in which portions they
/// come.
class EnergyMeter {
public:
    EnergyMeter(const Scene& scene, Instructions instructions);

    /// Of all particles, which `look` shows to what it is given, as Stepper::look() does.
    Energy energy(const std::function<void(const PortionSink&)>& look);
    /// An energy no run of this scene may be judged by the changes of: rounding, and the depth of potential wells.
    double floor() const { return floor_; }

private:
    void begin();
    void add(const Portion& portion);
    void finish_piece();

    const EnergySums* sums_;
    double mass_;
    Forces forces_;
    double floor_;
    std::size_t count_;   ///< particles of the scene
    std::size_t unit_;    ///< particles that pieces have in common: one of a chain, a row of a grid
    std::size_t length_;  ///< particles of a piece, without those it has in common with the next

    SquareSum squares_;      ///< of velocities
    Field<double> piece_;    ///< displacements
    std::size_t held_ = 0;   ///< particles in it
    std::size_t taken_ = 0;  ///< particles of the scene that were shown
    CompensatedSum value_, magnitude_, external_;
};

}  // namespace steplab
