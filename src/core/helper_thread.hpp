// A thread that a program can do without, where the system grants no more.
#pragma once

#include <system_error>
#include <thread>
#include <utility>

namespace steplab {

/// What is shown in place of a result for which there is no thread.
inline constexpr const char* no_thread_text = "the system grants no further thread to compute this";

/// Starts the thread unless it runs. False if the system does not grant it; the next call tries again.
template <class Work>
bool has_thread(std::thread& thread, Work work) {
    if (thread.joinable()) return true;
    try {
        thread = std::thread(std::move(work));
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

}  // namespace steplab
