#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

namespace steplab {

/// For a program that has something to write before it ends, and whose main thread may be waiting: hands on SIGINT,
/// SIGTERM and SIGHUP on a thread of its own. A program that has not ended 0.9 s later, or is asked a second time, ends
/// at once (end_program(), 128 + n); after wait_longer() only the latter. To be made before other threads, which
/// inherit that these signals wait.
class EndWatch {
public:
    /// `asked` is called on that thread when the first signal has come.
    explicit EndWatch(std::function<void()> asked);
    ~EndWatch();
    EndWatch(const EndWatch&) = delete;
    EndWatch& operator=(const EndWatch&) = delete;

    /// The signal that has come, if one has.
    std::optional<int> signal() const {
        const int came = signal_;
        return came == 0 ? std::nullopt : std::optional(came);
    }

    /// The program says that it is completing what takes longer.
    void wait_longer() { longer_ = true; }

private:
    void watch();

    std::function<void()> asked_;
    std::atomic<int> signal_ = 0;
    std::atomic<bool> stopping_ = false;
    std::atomic<bool> longer_ = false;
    std::thread thread_;
};

}  // namespace steplab
