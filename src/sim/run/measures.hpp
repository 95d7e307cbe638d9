#pragma once

#include "core/diagnostics.hpp"
#include "core/field.hpp"
#include "core/frame.hpp"
#include "core/precision.hpp"
#include "models/model.hpp"
#include "sim/steppers/pieces.hpp"
#include "sim/steppers/stepper.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace steplab {

// What is measured of all particles at one moment.

/// Momentum, angular momentum and the largest displacements and speed of a scene that comes in pieces.
class ParticleSums {
public:
    ParticleSums(const Plan& scene, const Shape& shape, std::size_t pieces)
        : scene_(scene), shape_(shape), pieces_(pieces) {}
    /// Different pieces may be added at the same time.
    void add(const Piece& piece);
    /// Of all pieces.
    Diagnostics result() const;

private:
    struct Sums {
        Vec3 velocity, turning;                                                    ///< momenta without the mass
        double displacement_squared = 0, farthest_squared = 0, speed_squared = 0;  ///< the largest
    };

    const Plan& scene_;
    const Shape& shape_;
    std::vector<Sums> pieces_;
};

/// Largest distance of a particle from the exact solution.
double largest_error(const Field<double>& displacement, const ExactSolution& exact, double time);

/// Largest displacement from the reference positions, in which no particle needs memory. `emit` emits all particles as
/// Stepper::emit() does.
double farthest_of(const std::function<void(const PortionSink&)>& emit);

/// Of the step's number and the bits of the state as the precision holds it: 16 hexadecimal digits. `emit` emits all
/// particles as Stepper::emit() does.
std::string hash_of(std::uint64_t step, Precision precision, const std::function<void(const PortionSink&)>& emit);

}  // namespace steplab
