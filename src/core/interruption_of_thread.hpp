#pragma once

#include <atomic>

namespace steplab {

/// What InterruptibleBy asks on this thread, for threads that work for it; null if there is none.
const std::atomic<bool>* interruption_of_this_thread();

}  // namespace steplab
