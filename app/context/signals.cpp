// The handlers do only what POSIX allows in one: set a flag and an alarm; when the alarm rings, or the second time, remove
// temporaries and _exit.
// SPDX-License-Identifier: MIT
#include "app/context/signals.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>

#include "techniques/foundation/image/output_file.h"

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

void onAlarm(int) { endNow(receivedSignal.load()); }

} // namespace

void installSignalHandlers() {
    struct sigaction interrupt {};
    interrupt.sa_handler = onInterrupt;
    interrupt.sa_flags = SA_RESTART; // drivers and libraries need not know about EINTR
    sigemptyset(&interrupt.sa_mask);
    for (const int signal : {SIGINT, SIGTERM})
        ::sigaction(signal, &interrupt, nullptr);
    // The terminal was closed. Whoever wants to work on all the same (nohup) has it ignored from the start.
    struct sigaction given {};
    if (::sigaction(SIGHUP, nullptr, &given) == 0 && given.sa_handler != SIG_IGN)
        ::sigaction(SIGHUP, &interrupt, nullptr);

    struct sigaction alarm {};
    alarm.sa_handler = onAlarm;
    sigemptyset(&alarm.sa_mask);
    ::sigaction(SIGALRM, &alarm, nullptr);

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
