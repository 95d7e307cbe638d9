#include "app/window/priority.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

namespace steplab {

namespace {

/// Behind the panels, but not so far that other work on the machine leaves the scene without a picture.
constexpr int nice_value = 5;

/// Linux: priorities are of single threads.
void give_way(int thread) { setpriority(PRIO_PROCESS, static_cast<id_t>(thread), nice_value); }

/// The numbers of all threads of the program, as the system lists them.
std::vector<int> threads() {
    std::vector<int> numbers;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
        numbers.push_back(std::stoi(entry.path().filename().string()));
    }
    return numbers;
}

}  // namespace

void give_way() { give_way(gettid()); }

NewThreadsGiveWay::NewThreadsGiveWay() : before_(threads()) {}

NewThreadsGiveWay::~NewThreadsGiveWay() {
    for (const int thread : threads()) {
        if (std::find(before_.begin(), before_.end(), thread) == before_.end()) give_way(thread);
    }
}

}  // namespace steplab
