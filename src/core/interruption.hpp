#pragma once

#include <atomic>
#include <exception>

namespace steplab {

/// The user or the system asked the program to end (SIGINT, SIGTERM, SIGHUP).
class Interrupted : public std::exception {
public:
    explicit Interrupted(int signal) : signal_(signal) {}
    int signal() const { return signal_; }
    /// As a shell reports signal n: 128 + n.
    int exit_code() const { return 128 + signal_; }
    const char* what() const noexcept override { return "interrupted"; }

private:
    int signal_;
};

/// From now on these signals are recorded instead of ending the program at once; system calls that wait return.
void catch_interruptions();
/// Throws Interrupted once such a signal has arrived. Long computations call this every few milliseconds, methods
/// before each step of their own.
void check_interruption();

/// While it lives, check_interruption() on this thread throws also once `asked` is true.
class InterruptibleBy {
public:
    explicit InterruptibleBy(const std::atomic<bool>& asked);
    ~InterruptibleBy();
    InterruptibleBy(const InterruptibleBy&) = delete;
    InterruptibleBy& operator=(const InterruptibleBy&) = delete;
};

}  // namespace steplab
