#pragma once

#include "models/scene/parameter.hpp"
#include "models/scene/scene.hpp"

namespace steplab {

/// The Morse potential between all particles, of the parameters D, k and r0.
inline PairTerm morse_term(const ParameterValues& values) {
    return {.potential = "morse",
            .values = {{"D", parameter(values, "D")}, {"k", parameter(values, "k")}, {"r0", parameter(values, "r0")}}};
}

}  // namespace steplab
