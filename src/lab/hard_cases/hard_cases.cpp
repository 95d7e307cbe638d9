#include "core/error.hpp"
#include "lab/hard_cases/digits.hpp"
#include "lab/hard_cases/hits.hpp"
#include "lab/hard_cases/ropes.hpp"
#include "lab/hard_cases/steps.hpp"

#include <fmt/format.h>

namespace steplab {

std::vector<HardCase> hard_cases() {
    return {marginal_steps(),
            changed_steps(),
            step_resonances(),
            backward_steps_with_drag(),
            passing_neighbours(),
            folding_mesh(),
            grazing_hits(),
            colliding_cube(),
            coincident_particles(),
            escape_threshold(),
            deep_repulsion(),
            stiff_rope(),
            long_time(),
            stagnation(),
            decay_to_zero(),
            chaos()};
}

HardCase hard_case(std::string_view id) {
    for (const HardCase& each : hard_cases()) {
        if (each.id == id) return each;
    }
    throw UsageError(fmt::format("there is no hard case '{}'", id));
}

}  // namespace steplab
