#pragma once

#include "core/instructions.hpp"

#include <cstddef>
#include <optional>

namespace steplab {

struct Method;
struct Plan;

/// How a run is computed: no bit of it depends on this.
struct Execution {
    std::optional<Instructions> instructions = std::nullopt;  ///< none: those that are fastest
    std::size_t threads = 0;                                  ///< maximum number; 0: all processors of the machine
    std::size_t particles_a_thread = 50000;  ///< from which on a further thread is worth its meetings with the others
};

/// Of many runs in lanes: the fastest here, if none are named.
Instructions instructions_of(const Execution& execution);

/// Of one run: the fastest here, if none are said. On processors of Intel these are narrower ones for methods of fixed
/// steps without equations on a few springs: there a division waits for the one before, and those of 64 bytes take
/// longer than those of 32.
Instructions instructions_for(const Method& method, const Plan& scene, const Execution& execution);

}  // namespace steplab
