#include "app/window/priority.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace steplab {

namespace {

/// Below the panels, but high enough that the scene is drawn while the machine does other work.
constexpr int nice_value = 5;

}  // namespace

/// On Linux each thread has its own priority.
void lower_priority() { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice_value); }

}  // namespace steplab
