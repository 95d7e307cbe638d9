#include "core/error.hpp"
#include "core/text.hpp"
#include "lab/hard_cases/digits.hpp"
#include "lab/hard_cases/hits.hpp"
#include "lab/hard_cases/ropes.hpp"
#include "lab/hard_cases/steps.hpp"

#include <string_view>
#include <vector>

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
    std::vector<std::string_view> known;
    for (const HardCase& each : hard_cases()) known.push_back(each.id);
    throw UsageError(unknown_word("hard case", id, known));
}

}  // namespace steplab
