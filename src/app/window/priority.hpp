#pragma once

#include <vector>

namespace steplab {

/// Lowers the priority of this thread, and of threads it starts, below that of the thread that answers the user.
void lower_priority();

/// Lowers the priority of all threads that the program starts during the lifetime of this object, when it ends. For the
/// drawing threads of a software OpenGL driver.
class LowPriorityThreads {
public:
    LowPriorityThreads();
    ~LowPriorityThreads();
    LowPriorityThreads(const LowPriorityThreads&) = delete;
    LowPriorityThreads& operator=(const LowPriorityThreads&) = delete;

private:
    std::vector<int> before_;
};

}  // namespace steplab
