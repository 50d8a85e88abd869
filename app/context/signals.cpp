// The handlers do only what POSIX allows in one: set a flag and an alarm; when the alarm rings, or the second time, remove
// temporaries and _exit. Signals that are not meant to end work in order (Ctrl-\ and others) remove temporaries, too.
// SPDX-License-Identifier: MIT
#include "app/context/signals.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>

#include "techniques/foundation/image/temporaries.h"

namespace shadowlab::context {
namespace {

std::atomic<int> receivedSignal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

// Between two looks at the flag there may be minutes: a frame of many rays, form factors of many patches. Who stops a program
// does not wait for them. Whatever ends in order has ended by then.
constexpr unsigned kGraceSeconds = 2;

int exitStatusOf(int signal) { return 128 + signal; }

void endNow(int signal) {
    image::removeTemporariesNow();
    ::_exit(exitStatusOf(signal));
}

void onInterrupt(int signal) {
    const int savedErrno = errno; // the interrupted code may be about to look at it
    int none = 0;
    if (!receivedSignal.compare_exchange_strong(none, signal)) endNow(signal);
    ::alarm(kGraceSeconds);
    errno = savedErrno;
}

/// What ends a program by default still ends it so, with a core file where that is wanted, but leaves nothing half-written.
void onEnd(int signal) {
    image::removeTemporariesNow();
    std::signal(signal, SIG_DFL);
    std::raise(signal); // delivered when this handler returns
}

void onAlarm(int signal) {
    if (const int received = receivedSignal.load()) endNow(received);
    onEnd(signal); // an alarm that was not set here
}

/// Unless it was ignored from the start (nohup, a command in the background of a script).
void handleUnlessIgnored(int signal, void (*handler)(int)) {
    struct sigaction given {
    }, taken{};
    if (::sigaction(signal, nullptr, &given) != 0 || given.sa_handler == SIG_IGN) return;
    taken.sa_handler = handler;
    taken.sa_flags = SA_RESTART;
    sigemptyset(&taken.sa_mask);
    ::sigaction(signal, &taken, nullptr);
}

} // namespace

void installSignalHandlers() {
    struct sigaction interrupt {};
    interrupt.sa_handler = onInterrupt;
    interrupt.sa_flags = SA_RESTART; // drivers and libraries need not know about EINTR
    sigemptyset(&interrupt.sa_mask);
    for (const int signal : {SIGINT, SIGTERM})
        ::sigaction(signal, &interrupt, nullptr);
    handleUnlessIgnored(SIGHUP, onInterrupt);  // the terminal was closed
    handleUnlessIgnored(SIGXCPU, onInterrupt); // ulimit -S -t: a second later it comes again, and ends the program at once
    for (const int signal : {SIGQUIT, SIGUSR1, SIGUSR2, SIGVTALRM, SIGPROF, SIGIO, SIGPWR})
        handleUnlessIgnored(signal, onEnd);

    struct sigaction alarm {};
    alarm.sa_handler = onAlarm;
    sigemptyset(&alarm.sa_mask);
    ::sigaction(SIGALRM, &alarm, nullptr);
    // A process inherits blocked signals from the one that started it.
    sigset_t handled;
    sigemptyset(&handled);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGALRM})
        sigaddset(&handled, signal);
    ::pthread_sigmask(SIG_UNBLOCK, &handled, nullptr);

    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    sigemptyset(&ignore.sa_mask);
    for (const int signal : {SIGPIPE, SIGXFSZ})
        ::sigaction(signal, &ignore, nullptr);
}

bool interrupted() { return receivedSignal.load(std::memory_order_relaxed) != 0; }

void throwIfInterrupted() {
    if (const int signal = receivedSignal.load(std::memory_order_relaxed)) throw Interrupted{exitStatusOf(signal)};
}

} // namespace shadowlab::context
