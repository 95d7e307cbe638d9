#pragma once

#include "core/instructions.hpp"

namespace steplab {

/// How a run is computed: no bit of it depends on this.
struct Execution {
    Instructions instructions = fastest_instructions();
};

}  // namespace steplab
