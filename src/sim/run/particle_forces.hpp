#pragma once

#include "core/field.hpp"
#include "core/vec3.hpp"
#include "models/plan.hpp"

#include <functional>
#include <vector>

namespace steplab {

/// The forces of a scene on its particles, drag and damping included, computed in double and apart from the run.
class ParticleForces {
public:
    explicit ParticleForces(const Plan& scene);

    /// Forces in N on each particle, zero on fixed ones.
    void at(const State<double>& state, std::vector<Vec3>& out);

private:
    double mass_, drag_;
    std::vector<double> masses_;  ///< in the unit of mass; empty where all are 1
    std::function<void(const State<double>&, Field<double>&)> accelerate_;
    Field<double> accelerations_;
};

}  // namespace steplab
