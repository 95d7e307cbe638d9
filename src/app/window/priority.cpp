#include "app/window/priority.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace steplab {

namespace {

/// High enough that scenes play while the machine does other work.
int nice_value(ThreadWork work) { return work == ThreadWork::pictures ? 5 : 10; }

}  // namespace

/// On Linux each thread has its own priority.
void lower_priority(ThreadWork work) { setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice_value(work)); }

}  // namespace steplab
