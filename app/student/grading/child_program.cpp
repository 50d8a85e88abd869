// SPDX-License-Identifier: MIT
#include "app/student/grading/child_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <optional>

#include "app/context/signals.h"
#include "app/student/plugin_trial.h"
#include "techniques/foundation/base/error.h"

extern char** environ;

namespace shadowlab::student {

namespace {

using Clock = std::chrono::steady_clock;
using How = ChildEnd::How;

constexpr std::size_t kMostText = 1 << 20;
constexpr rlim_t kLargestFile = 1 << 30;
constexpr int kLookMs = 20;

/// A child in a process group of its own, which ends with this object.
class Child {
public:
    explicit Child(const std::vector<std::string>& words) {
        std::vector<std::string> kept{"shadowlab"};
        kept.insert(kept.end(), words.begin(), words.end());
        std::vector<char*> arguments;
        for (std::string& word : kept)
            arguments.push_back(word.data());
        arguments.push_back(nullptr);

        std::array<int, 2> out{}, err{};
        if (::pipe2(out.data(), O_CLOEXEC | O_NONBLOCK) != 0 || ::pipe2(err.data(), O_CLOEXEC | O_NONBLOCK) != 0)
            fail(errno);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions, out[1], 1);
        posix_spawn_file_actions_adddup2(&actions, err[1], 2);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
        posix_spawnattr_setpgroup(&attributes, 0);
        const int failed = ::posix_spawn(&process_, "/proc/self/exe", &actions, &attributes, arguments.data(), environ);
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
        ::close(out[1]);
        ::close(err[1]);
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
    ~Child() {
        end();
        ::close(out_);
        ::close(err_);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Waits a little, and takes what it has said. Its wait status once it has ended.
    std::optional<int> look() {
        std::array<pollfd, 2> wait{{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};
        ::poll(wait.data(), wait.size(), kLookMs);
        int status = 0;
        const bool ended = ::waitpid(process_, &status, WNOHANG) == process_;
        take(out_, said);
        take(err_, complaints);
        // Whoever has closed both is looked at every time, without a pause: then this is one.
        if (!ended && (wait[0].revents | wait[1].revents) & POLLHUP) ::poll(nullptr, 0, kLookMs);
        if (!ended) return std::nullopt;
        ::kill(-process_, SIGKILL); // whom it has left behind
        process_ = -1;
        return status;
    }
    [[nodiscard]] std::uint64_t residentBytes() const {
        std::ifstream statm("/proc/" + std::to_string(process_) + "/statm");
        std::uint64_t all = 0, resident = 0;
        statm >> all >> resident;
        return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    }
    void end() {
        if (process_ <= 0) return;
        ::kill(-process_, SIGKILL);
        ::kill(process_, SIGKILL); // also before it leads its group
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
    }

    std::string said, complaints;

private:
    [[noreturn]] static void fail(int error) {
        throw Error(ExitStatus::overLimit,
                    std::string("no process can be started: ") + std::strerror(error) + "; end some others");
    }
    static void take(int descriptor, std::string& text) {
        std::array<char, 4096> buffer{};
        for (ssize_t got = 0; (got = ::read(descriptor, buffer.data(), buffer.size())) > 0;) {
            text.append(buffer.data(), static_cast<std::size_t>(got));
            if (text.size() > kMostText) text.erase(0, text.size() - kMostText);
        }
    }

    pid_t process_ = -1;
    int out_ = -1, err_ = -1;
};

/// The last line, without "shadowlab: " before it.
std::string lastLine(std::string text) {
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    text.erase(0, text.rfind('\n') + 1);
    for (const std::string_view prefix : {"shadowlab: ", "internal error: "})
        if (text.starts_with(prefix)) text.erase(0, prefix.size());
    // What the program says of itself is about the plug-in here.
    constexpr std::string_view kOurs = "; this is a fault of the program";
    return text.substr(0, text.find(kOurs));
}

} // namespace

ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits) {
    Child child(words);
    const Clock::time_point latest = Clock::now() + limits.time;
    std::optional<int> status;
    ChildEnd end;
    while (!(status = child.look())) {
        context::throwIfInterrupted();
        if (Clock::now() > latest) {
            end.how = How::outOfTime;
            end.message = "it did not come to an end within " + std::to_string(limits.time.count()) + " s";
        } else if (child.residentBytes() > limits.memoryBytes) {
            end.how = How::outOfMemory;
            end.message = "it used more than " + std::to_string(limits.memoryBytes >> 20) + " MiB of memory";
        } else {
            continue;
        }
        child.end();
        return end;
    }
    end.out = std::move(child.said);
    if (WIFSIGNALED(*status)) {
        end.how = How::crashed;
        end.message = "it crashed (" + signalText(WTERMSIG(*status)) + ")";
    } else if (WEXITSTATUS(*status) != 0) {
        end.how = How::failed;
        end.status = WEXITSTATUS(*status);
        end.message = lastLine(std::move(child.complaints));
        if (end.message.empty()) end.message = "it ended the program with status " + std::to_string(end.status);
    }
    return end;
}

} // namespace shadowlab::student
