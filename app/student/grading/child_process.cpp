// SPDX-License-Identifier: MIT
#include "app/student/grading/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "techniques/foundation/base/error.h"

extern char** environ;

namespace shadowlab::student {

namespace {

constexpr std::size_t kMostText = 1 << 20;
constexpr rlim_t kLargestFile = 1 << 30;
constexpr int kLookMs = 20;

[[noreturn]] void fail(int error) {
    throw Error(ExitStatus::overLimit, std::string("no process can be started: ") + std::strerror(error) + "; end some others");
}

void take(int descriptor, std::string& text) {
    std::array<char, 4096> buffer{};
    for (ssize_t got = 0; (got = ::read(descriptor, buffer.data(), buffer.size())) > 0;) {
        text.append(buffer.data(), static_cast<std::size_t>(got));
        if (text.size() > kMostText) text.erase(0, text.size() - kMostText);
    }
}

} // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
    adoptOrphans();
    before_ = childrenOf(::getpid());
    std::vector<std::string> kept = words;
    std::vector<char*> arguments;
    for (std::string& word : kept)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);

    std::array<int, 2> in{}, out{}, err{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0 || ::pipe2(err.data(), O_CLOEXEC) != 0) fail(errno);
    for (const int mine : {out[0], err[0]})
        ::fcntl(mine, F_SETFL, O_NONBLOCK);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], 0);
    posix_spawn_file_actions_adddup2(&actions, out[1], 1);
    posix_spawn_file_actions_adddup2(&actions, err[1], 2);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    const int failed = ::posix_spawn(&process_, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    for (const int its : {in[0], out[1], err[1]})
        ::close(its);
    in_ = in[1];
    out_ = out[0];
    err_ = err[0];
    if (failed) {
        process_ = -1;
        fail(failed);
    }
    const rlimit noCore{0, 0}, file{kLargestFile, kLargestFile};
    ::prlimit(process_, RLIMIT_CORE, &noCore, nullptr);
    ::prlimit(process_, RLIMIT_FSIZE, &file, nullptr);
}

ChildProcess::~ChildProcess() {
    end();
    for (const int mine : {in_, out_, err_})
        if (mine >= 0) ::close(mine);
}

std::optional<int> ChildProcess::look() {
    std::array<pollfd, 2> wait{{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};
    ::poll(wait.data(), wait.size(), kLookMs);
    int status = 0;
    const bool ended = ::waitpid(process_, &status, WNOHANG) == process_;
    take(out_, said);
    take(err_, complaints);
    // A child that has closed both makes poll() return at once: then this is the pause.
    if (!ended && (wait[0].revents | wait[1].revents) & POLLHUP) ::poll(nullptr, 0, kLookMs);
    if (!ended) return std::nullopt;
    ::kill(-process_, SIGKILL);
    process_ = -1;
    endChildrenBut(before_);
    return status;
}

bool ChildProcess::tell(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t put = ::write(in_, text.data() + at, text.size() - at); // SIGPIPE is ignored (context/signals.h)
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        at += static_cast<std::size_t>(put);
    }
    return true;
}

void ChildProcess::closeInput() {
    if (in_ >= 0) ::close(in_);
    in_ = -1;
}

void ChildProcess::end() {
    if (process_ <= 0) return;
    ::kill(-process_, SIGKILL);
    ::kill(process_, SIGKILL); // also before it leads its group
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    endChildrenBut(before_);
}

} // namespace shadowlab::student
