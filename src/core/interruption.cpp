#include "core/interruption.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace steplab {

namespace {

// A signal handler may use only such a variable; threads poll it.
std::atomic<int> caught_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);

thread_local const std::atomic<bool>* asked_on_this_thread = nullptr;

void remember(int signal) { caught_signal = signal; }

}  // namespace

void catch_interruptions() {
    struct sigaction action {};
    action.sa_handler = remember;
    sigemptyset(&action.sa_mask);
    // A second signal ends the program at once. Without SA_RESTART a write that waits returns, so that a blocked
    // program can end.
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN)
            sigaction(signal, &action, nullptr);  // a signal that nohup ignores stays ignored
    }
}

void check_interruption() {
    if (const int signal = caught_signal) throw Interrupted(signal);
    if (asked_on_this_thread && *asked_on_this_thread) throw Interrupted(SIGTERM);
}

InterruptibleBy::InterruptibleBy(const std::atomic<bool>& asked) { asked_on_this_thread = &asked; }
InterruptibleBy::~InterruptibleBy() { asked_on_this_thread = nullptr; }

}  // namespace steplab
