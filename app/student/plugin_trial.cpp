// SPDX-License-Identifier: MIT
#include "app/student/plugin_trial.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>

#include "techniques/foundation/base/error.h"

namespace shadowlab::student {

namespace {

constexpr std::chrono::seconds kLongest{10}; // lists of words: they take milliseconds

// Exit statuses of a child that has written what was wrong, and of one that is done: 0 is what a plug-in may end it with.
constexpr int kSaid = 3, kDone = 117;

void write(int descriptor, const char* text) {
    // What does not fit into the pipe's 64 KiB is too long a message anyway.
    if (::write(descriptor, text, std::strlen(text)) < 0) ::_exit(1);
}

[[noreturn]] void runAsChild(const std::function<void()>& work, int answer) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM})
        std::signal(signal, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::dup2(nowhere, descriptor);
    try {
        work();
    } catch (const std::exception& thrown) {
        write(answer, thrown.what());
        ::_exit(kSaid);
    } catch (...) {
        write(answer, "it throws something that is no std::exception");
        ::_exit(kSaid);
    }
    ::_exit(kDone);
}

/// What comes from the child until it closes its end. False when the time is over first.
bool readAll(int descriptor, std::string& text) {
    const auto end = std::chrono::steady_clock::now() + kLongest;
    std::array<char, 4096> buffer{};
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
        pollfd wait{descriptor, POLLIN, 0};
        const int ready = left <= 0 ? 0 : ::poll(&wait, 1, static_cast<int>(left));
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
        if (got <= 0) return true;
        text.append(buffer.data(), static_cast<std::size_t>(got));
    }
}

} // namespace

std::string signalText(int signal) {
    switch (signal) {
    case SIGSEGV: return "segmentation fault";
    case SIGABRT: return "aborted";
    case SIGBUS: return "bus error";
    case SIGFPE: return "arithmetic exception";
    case SIGILL: return "illegal instruction";
    default: return "signal " + std::to_string(signal);
    }
}

std::optional<std::string> tryInChild(const std::function<void()>& work) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw Error(ExitStatus::overLimit,
                    std::string("no process can be started: ") + std::strerror(errno) + "; end some others");
    const pid_t child = ::fork();
    if (child == 0) runAsChild(work, pipe[1]);
    ::close(pipe[1]);
    std::string said;
    const bool ended = child > 0 && readAll(pipe[0], said);
    ::close(pipe[0]);
    if (child < 0)
        throw Error(ExitStatus::overLimit,
                    std::string("no process can be started: ") + std::strerror(errno) + "; end some others");
    if (!ended) ::kill(child, SIGKILL);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!ended) return "it does not come to an end within " + std::to_string(kLongest.count()) + " s";
    if (WIFSIGNALED(status)) return "it crashes (" + signalText(WTERMSIG(status)) + ")";
    if (WEXITSTATUS(status) == kSaid) return said;
    if (WEXITSTATUS(status) != kDone)
        return "it ends the program (exit status " + std::to_string(WEXITSTATUS(status)) + ")";
    return std::nullopt;
}

} // namespace shadowlab::student
