#include "core/end_watch.hpp"

#include "core/program_end.hpp"

#include <csignal>
#include <ctime>
#include <initializer_list>
#include <pthread.h>
#include <utility>

namespace steplab {

namespace {

/// Wakes the thread that waits for the others.
constexpr int own_signal = SIGUSR2;

/// Those that end the program; not those that nohup ignores.
sigset_t ending_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        sigaction(signal, nullptr, &now);
        if (now.sa_handler != SIG_IGN) sigaddset(&signals, signal);
    }
    sigaddset(&signals, own_signal);
    return signals;
}

}  // namespace

EndWatch::EndWatch(std::function<void()> asked) : asked_(std::move(asked)) {
    const sigset_t signals = ending_signals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    thread_ = std::thread([this] { watch(); });
}

EndWatch::~EndWatch() {
    stopping_ = true;
    pthread_kill(thread_.native_handle(), own_signal);
    thread_.join();
    const sigset_t signals = ending_signals();
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void EndWatch::watch() {
    constexpr timespec patience{0, 900'000'000};
    const sigset_t signals = ending_signals();
    int signal = 0;
    sigwait(&signals, &signal);
    if (stopping_) return;
    signal_ = signal;
    asked_();
    while (sigtimedwait(&signals, nullptr, &patience) < 0 && longer_) {
    }
    if (!stopping_) end_program(128 + signal);
}

}  // namespace steplab
