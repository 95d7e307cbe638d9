#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <sys/inotify.h>
#include <unistd.h>

namespace steplab {

/// Waits until files appear in a folder, without a clock.
class FolderWatch {
public:
    explicit FolderWatch(const std::string& folder, std::uint32_t for_what = IN_MOVED_TO)
        : events_(inotify_init1(IN_CLOEXEC)) {
        if (inotify_add_watch(events_, folder.c_str(), for_what) < 0) throw std::runtime_error("cannot watch");
    }
    ~FolderWatch() { close(events_); }
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    void wait_for_a_file() const {
        std::array<char, 4096> buffer;
        if (read(events_, buffer.data(), buffer.size()) <= 0) throw std::runtime_error("cannot wait");
    }

private:
    int events_;
};

}  // namespace steplab
