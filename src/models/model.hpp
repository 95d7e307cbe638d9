#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/shape.hpp"
#include "models/plan.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab {

/// The motion of a scene in closed form, from its initial state.
class ExactSolution {
public:
    virtual ~ExactSolution() = default;
    /// Displacement from the reference position of one particle at time t.
    virtual Vec3 displacement(std::size_t particle, double t) const = 0;
    /// Velocity of one particle at time t.
    virtual Vec3 velocity(std::size_t particle, double t) const = 0;
    /// The same for all particles; `out` has one element for each.
    virtual void displacements(double t, std::span<Vec3> out) const {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = displacement(i, t);
    }
    /// The solution is valid up to this time.
    virtual double valid_until() const { return infinity; }
    /// Upper bound of the rounding error of a displacement at time t, in addition to half an ulp of its largest
    /// component.
    virtual double rounding(double t) const = 0;
};

/// How the window opens a model: a method and a dt that show its motion well at its default parameters
/// (sim/run/opening.hpp).
struct Opening {
    std::string_view method = "rk4";
    double dt = 0.1;
};

/// A model: its description, and what follows from its parameters. The functions take checked values.
struct Model {
    ModelInfo info;
    Opening opening = {};
    /// Number of particles, as a double because it may be too large for an integer.
    double (*particles)(const ParameterValues&);
    Plan (*plan)(const ParameterValues&);
    Shape (*shape)(const ParameterValues&);
    /// Largest angular frequency of the scene linearised at its start, 0 if nothing oscillates; nullopt if not known.
    std::optional<double> (*omega_max)(const ParameterValues&);
    /// Null if no exact solution is known, or none is valid for these values.
    std::shared_ptr<const ExactSolution> (*exact)(const ParameterValues&);
    /// Displacements of the equilibrium that the scene reaches by drag. Null if there is none, or it is not known.
    Field<double> (*resting)(const ParameterValues&) = nullptr;
    /// Why these values are not possible together although each of them is allowed; nullopt if they are. Null: they
    /// always are.
    std::optional<std::string> (*refusal)(const ParameterValues&) = nullptr;
};

}  // namespace steplab
