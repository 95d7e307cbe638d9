#include "io/interruption.hpp"

#include <csignal>
#include <initializer_list>

namespace steplab {

namespace {

// A signal handler can reach nothing but such a variable.
volatile std::sig_atomic_t caught_signal = 0;

void remember(int signal) { caught_signal = signal; }

}  // namespace

void catch_interruptions() {
    struct sigaction action {};
    action.sa_handler = remember;
    sigemptyset(&action.sa_mask);
    action.sa_flags = 0;  // without SA_RESTART a write that waits returns, so that a blocked program can end
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);  // nohup stays nohup
    }
}

void check_interruption() {
    if (caught_signal != 0) throw Interrupted(caught_signal);
}

}  // namespace steplab
