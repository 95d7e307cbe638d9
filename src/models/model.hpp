#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/lattice.hpp"
#include "core/shape.hpp"
#include "core/start.hpp"
#include "models/forces/forces.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace steplab {

/// The motion of a scene in closed form, from its start.
class ExactSolution {
public:
    virtual ~ExactSolution() = default;
    /// Displacement from the reference position of one particle at time t.
    virtual Vec3 displacement(std::size_t particle, double t) const = 0;
    /// Velocity of one particle at time t.
    virtual Vec3 velocity(std::size_t particle, double t) const = 0;
    /// The same for all particles; `out` has one place for each.
    virtual void displacements(double t, std::span<Vec3> out) const {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = displacement(i, t);
    }
    /// Until this time it is the motion; not beyond.
    virtual double valid_until() const { return infinity; }
    /// Bound of what rounding adds to a displacement at time t beside half an ulp of its largest number.
    virtual double rounding(double t) const = 0;
};

/// A model with its parameters filled in, ready to be stepped: everything in double.
struct Scene {
    double mass = 1;  ///< of each particle, > 0
    double drag = 0;  ///< rate gamma = c / m of the drag -c v, >= 0
    Forces forces;
    Lattice reference;  ///< absolute position = reference + displacement
    Start start;
};

/// A model: how it describes itself and what it makes of its parameters. The functions take checked values.
struct Model {
    ModelInfo info;
    /// Number of particles, as a double because it may be too large to count or to hold.
    double (*particles)(const ParameterValues&);
    Scene (*scene)(const ParameterValues&);
    Shape (*shape)(const ParameterValues&);
    /// Largest angular frequency of the scene linearised at its start, 0 if nothing oscillates; none if not known.
    std::optional<double> (*omega_max)(const ParameterValues&);
    /// Null where no exact solution is known (or holds for these values).
    std::shared_ptr<const ExactSolution> (*exact)(const ParameterValues&);
    /// Displacements where the scene comes to rest under its drag. Null where it does not, or nobody knows where.
    Field<double> (*resting)(const ParameterValues&) = nullptr;
    /// Why these values, each allowed by itself, are no scene together; none if they are. Null: they always are.
    std::optional<std::string> (*refusal)(const ParameterValues&) = nullptr;
};

}  // namespace steplab
