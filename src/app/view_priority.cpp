#include "app/view_priority.hpp"

#include <sys/resource.h>
#include <unistd.h>

namespace steplab {

void give_way() {
    constexpr int nice_value = 19;
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice_value);  // Linux: of this thread alone
}

}  // namespace steplab
