#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/precision.hpp"
#include "core/shape.hpp"
#include "models/plan.hpp"
#include "models/scene/scene.hpp"

#include <functional>
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

/// What is known of a scene without making it.
struct SceneFacts {
    double mass = 1;       ///< of each particle; 0: they differ
    double drag = 0;       ///< rate gamma = c / m of the drag -c v; else a bound of all rates of damping
    bool damping = false;  ///< dashpots, or drag that differs between particles
    bool dashpots = false;
    double bond = 0;               ///< distance of bound neighbours that positions have to resolve; 0: nothing is bound
    double bond_width = infinity;  ///< change of that distance by which the force of a bond changes by a factor e
    double pair_frequency = 0;     ///< angular, of the bound pair that swings fastest alone; 0: none is known
    bool lists_pairs = false;      ///< pairs near each other are kept in lists
};

/// How the window opens a model: a method and a dt that show its motion well at its default parameters
/// (sim/run/opening.hpp).
struct Opening {
    std::string_view method = "rk4";
    double dt = 0.1;
    Precision precision = Precision::double_;
    std::optional<double> until = {};  ///< where a run ends that is given no end; none: after a number of steps
};

/// A model, a kind of scene: its description, and what follows from its parameters. The functions take checked values.
struct Model {
    using Values = ParameterValues;

    ModelInfo info;
    Opening opening = {};
    std::string_view topic = {};  ///< one of topic_ids, under which it is offered; empty: none
    /// Number of particles, as a double because it may be too large for an integer.
    std::function<double(const Values&)> particles;
    std::function<SceneFacts(const Values&)> facts;
    /// The scene as a value, its numbers written with the parameters that apply while it runs.
    std::function<Scene(const Values&)> scene;
    /// What planned(scene(values)) is, made without it.
    std::function<Plan(const Values&)> plan;
    std::function<Shape(const Values&)> shape;
    /// Largest angular frequency of the scene linearised at its start, 0 if nothing oscillates; nullopt if not known.
    std::function<std::optional<double>(const Values&)> omega_max;
    /// Null if no exact solution is known, or none is valid for these values.
    std::function<std::shared_ptr<const ExactSolution>(const Values&)> exact;
    /// Displacements of the equilibrium that the scene reaches by drag. Empty if there is none, or it is not known.
    std::function<Field<double>(const Values&)> resting = {};
    /// Why these values are not possible together although each of them is allowed; nullopt if they are. Empty: they
    /// always are.
    std::function<std::optional<std::string>(const Values&)> refusal = {};
    /// Which of the numbers of its own are none in float; nullopt: all are. Empty: it has none.
    std::function<std::optional<std::string>(const Values&)> lost_in_float = {};
};

}  // namespace steplab
