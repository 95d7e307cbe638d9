#pragma once

#include "core/diagnostics.hpp"
#include "core/field.hpp"
#include "core/instructions.hpp"
#include "models/plan.hpp"
#include "sim/steppers/energy_sums.hpp"
#include "sim/steppers/pieces.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace steplab {

/// Kinetic and potential energy of one state, in the parts the check of divergence needs.
struct Energy {
    double kinetic = 0;
    PotentialEnergy potential;

    double total() const { return kinetic + potential.value; }
};

/// Computes sums over a scene's particles in double. They are taken in pieces (Pieces), so that neither memory for all
/// particles of a chain or grid is needed nor does it matter how they are shown.
class EnergyMeter {
public:
    using Emit = std::function<void(const PortionSink&)>;

    EnergyMeter(const Plan& scene, Instructions instructions);

    /// Of all particles, which `emit` emits as Stepper::emit() does.
    Energy energy(const Emit& emit) { return energy(1, emit, nullptr); }
    /// The same of parts that may be emitted in parallel. Each piece is passed on to `also`, unless that is empty.
    Energy energy(std::size_t parts, const Emit& emit, const PieceSink& also);
    std::size_t pieces() const { return sums_.size(); }
    /// An energy no run of this scene may be judged by the changes of: rounding, the depth of potential wells, typed
    /// potentials around where the particles start, and what outer forces give within one step from rest, in which
    /// positions of some methods do not follow yet.
    double floor(double dt) const;

private:
    struct Sums {
        double squares;  ///< of velocities
        PotentialEnergy potential;
    };

    double floor_of_expressions(const Plan& scene) const;
    /// The squares of the velocities times the masses.
    double weighted(const Piece& piece) const;
    Sums sums_of(const Piece& piece);
    Energy total() const;

    const EnergySums* energy_sums_;
    double mass_;
    std::vector<double> masses_;  ///< in this unit; empty where all are 1
    Forces forces_;
    double floor_;
    double outer_power_;  ///< what outer forces give within a short time from rest, divided by its square
    std::size_t count_;   ///< particles of the scene
    std::size_t unit_;    ///< particles that pieces have in common: one of a chain, a row of a grid
    Pieces pieces_;
    std::vector<Sums> sums_;  ///< of each piece
    Field<double> whole_;     ///< all displacements, where forces are not only those of neighbours
};

}  // namespace steplab
