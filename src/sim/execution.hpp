#pragma once

#include "core/instructions.hpp"

#include <cstddef>

namespace steplab {

/// How a run is computed: no bit of it depends on this.
struct Execution {
    Instructions instructions = fastest_instructions();
    std::size_t threads = 0;                 ///< at most so many; 0: as many as the machine has processors
    std::size_t particles_a_thread = 50000;  ///< from which on a further thread is worth its meetings with the others
};

}  // namespace steplab
