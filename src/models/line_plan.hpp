#pragma once

#include "models/model.hpp"

namespace steplab {

/// What is known of such a scene with drag of this rate.
SceneFacts line_facts(const LineForces& forces, double drag);

/// A scene of `forces.count` particles at (i L, 0, 0), at rest except for the last one.
Plan line_plan(const LineForces& forces, double drag, Vec3 kick = {});

/// Its shape: springs between neighbours, the first particle fixed where the forces say so.
Shape line_shape(std::size_t count, double rest_length, bool first_fixed);

}  // namespace steplab
