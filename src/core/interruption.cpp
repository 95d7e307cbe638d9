#include "core/interruption.hpp"

#include "core/interruption_of_thread.hpp"
#include "core/program_end.hpp"
#include "core/watching.hpp"

#include <atomic>
#include <csignal>
#include <ctime>
#include <initializer_list>
#include <utility>

namespace steplab {

namespace {

// A signal handler may use only such variables; threads poll the first.
std::atomic<int> caught_signal = 0, code_at_deadline = 0;
static_assert(std::atomic<int>::is_always_lock_free);
timer_t deadline{};

thread_local const std::atomic<bool>* asked_on_this_thread = nullptr;
thread_local const std::function<void()>* watch_of_this_thread = nullptr;

void end_now(int signal) { end_program(128 + signal); }

void end_late(int) { end_program(code_at_deadline); }

/// A program that was interrupted ends within a second: by itself until then.
void begin_to_end(int exit_code) {
    constexpr itimerspec patience{{0, 0}, {0, 400'000'000}};
    code_at_deadline = exit_code;
    timer_settime(deadline, 0, &patience, nullptr);
}

/// Later signals ask for the same.
void remember(int signal) {
    int none = 0;
    if (caught_signal.compare_exchange_strong(none, signal)) begin_to_end(128 + signal);
}

void on(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    sigemptyset(&action.sa_mask);
    action.sa_flags = 0;  // without SA_RESTART a write that waits returns, so that a blocked program can end
    sigaction(signal, &action, nullptr);
}

void on_interruptions(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) on(signal, handler);  // a signal that nohup ignores stays ignored
    }
}

bool make_deadline() {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    on(SIGALRM, end_late);
    return timer_create(CLOCK_MONOTONIC, &event, &deadline) == 0;
}

}  // namespace

// Without a timer nothing would end a program that does not answer.
void catch_interruptions() { on_interruptions(make_deadline() ? remember : end_now); }

void end_program_soon(int exit_code) {
    if (make_deadline()) begin_to_end(exit_code);
}

void check_interruption() {
    if (const int signal = caught_signal) throw Interrupted(signal);
    if (asked_on_this_thread && *asked_on_this_thread) throw Interrupted(SIGTERM);
    const auto* const watch = watch_of_this_thread;
    if (!watch) return;
    watch_of_this_thread = nullptr;  // what it calls may come back here
    try {
        (*watch)();
    } catch (...) {
        watch_of_this_thread = watch;
        throw;
    }
    watch_of_this_thread = watch;
}

const std::atomic<bool>* interruption_of_this_thread() { return asked_on_this_thread; }

Watching::Watching(std::function<void()> watch) : watch_(std::move(watch)), outer_(watch_of_this_thread) {
    watch_of_this_thread = &watch_;
}
Watching::~Watching() { watch_of_this_thread = outer_; }

InterruptibleBy::InterruptibleBy(const std::atomic<bool>& asked) { asked_on_this_thread = &asked; }
InterruptibleBy::~InterruptibleBy() { asked_on_this_thread = nullptr; }

}  // namespace steplab
