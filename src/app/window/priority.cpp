#include "app/window/priority.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

namespace steplab {

namespace {

/// Below the panels, but high enough that the scene is drawn while the machine does other work.
constexpr int nice_value = 5;

/// On Linux each thread has its own priority.
void lower_priority(int thread) { setpriority(PRIO_PROCESS, static_cast<id_t>(thread), nice_value); }

/// The ids of all threads of the program.
std::vector<int> threads() {
    std::vector<int> numbers;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
        numbers.push_back(std::stoi(entry.path().filename().string()));
    }
    return numbers;
}

}  // namespace

void lower_priority() { lower_priority(gettid()); }

LowPriorityThreads::LowPriorityThreads() : before_(threads()) {}

LowPriorityThreads::~LowPriorityThreads() {
    for (const int thread : threads()) {
        if (std::find(before_.begin(), before_.end(), thread) == before_.end()) lower_priority(thread);
    }
}

}  // namespace steplab
