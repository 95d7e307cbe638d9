#pragma once

#include "models/plan.hpp"
#include "sim/run/run_description.hpp"

namespace steplab {

/// Bytes of memory that new data may take: what the system says is available, less a reserve for everything else.
double available_memory();

/// Bytes a running simulation needs for each particle: integrator, saved state, frame and measured state.
double bytes_per_particle(const RunDescription& description);

/// Bytes that such a run takes in all, about.
double bytes_of_run(const RunDescription& description);

/// Bytes it takes besides for the interactions of the scene, as many as there are at the start.
double bytes_of_interactions(const RunDescription& description, const Plan& scene);

/// How many pairs act on each other in the scene as it starts; of composed scenes with a cut-off about.
double interacting_pairs(const Plan& scene);

}  // namespace steplab
