#pragma once

#include "core/team.hpp"

#include <cstdlib>

namespace steplab {

/// To be called before OpenGL is loaded. Mesa's software renderer waits for ever for threads that the system does not
/// grant it: where there are too few, it is told to draw on the calling thread alone.
inline void limit_driver_threads() {
    const std::size_t wanted = processors() + 1;
    if (Team(wanted).members() < wanted) setenv("LP_NUM_THREADS", "0", 0);
}

}  // namespace steplab
