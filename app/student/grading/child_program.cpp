// SPDX-License-Identifier: MIT
#include "app/student/grading/child_program.h"

#include <sys/wait.h>

#include <csignal>
#include <optional>
#include <string_view>
#include <utility>

#include "app/context/signals.h"
#include "app/student/plugin_trial.h"
#include "app/student/plugins.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::student {

namespace {

using Clock = std::chrono::steady_clock;
using How = ChildEnd::How;

/// The last line, without "shadowlab: " before it.
std::string lastLine(std::string text) {
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    text.erase(0, text.rfind('\n') + 1);
    for (const std::string_view prefix : {"shadowlab: ", "internal error: "})
        if (text.starts_with(prefix)) text.erase(0, prefix.size());
    // What the program says of itself is about the plug-in here.
    constexpr std::string_view kOurs = "; this is a fault of the program";
    if (text.starts_with(kEndedByPlugin)) return "it has ended the program itself; leave out exit()";
    return text.substr(0, text.find(kOurs));
}

// Exit statuses above this are signals, as shells count.
constexpr int kSignals = 128;

// How bwrap begins what it says of itself.
constexpr std::string_view kBwrap = "bwrap: ";

} // namespace

std::string overWhat(const ChildProcess& child, const ChildLimits& limits, Clock::time_point since) {
    if (Clock::now() > since + limits.time) return "it did not come to an end within " + std::to_string(limits.time.count()) + " s";
    const TreeUse use = child.use();
    if (use.processes > limits.processes) return "it started more than " + std::to_string(limits.processes) + " processes";
    if (use.residentBytes > limits.memoryBytes) return "it used more than " + std::to_string(limits.memoryBytes >> 20) + " MiB of memory";
    return {};
}

ChildEnd endOf(int waitStatus, ChildProcess& child, bool inSandbox) {
    ChildEnd end;
    end.out = std::move(child.said);
    const int status = WIFEXITED(waitStatus) ? WEXITSTATUS(waitStatus) : 0;
    const int signal = WIFSIGNALED(waitStatus) ? WTERMSIG(waitStatus) : inSandbox && status > kSignals ? status - kSignals : 0;
    if (signal != 0) {
        end.how = How::crashed;
        end.message = "it crashed (" + signalText(signal) + ")";
    } else if (status != 0) {
        end.how = How::failed;
        end.message = lastLine(std::move(child.complaints));
        if (inSandbox && end.message.starts_with(kBwrap))
            throw Error(ExitStatus::overLimit, "the sandbox could not be made: " + end.message.substr(kBwrap.size()) +
                                                   "; try again, or write --sandbox off");
        if (end.message.empty()) end.message = "it ended the program with status " + std::to_string(status);
    }
    return end;
}

ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits, const Sandbox& sandbox, const SandboxRoom& room) {
    ChildProcess child(sandbox.around(words, room));
    child.closeInput();
    const Clock::time_point since = Clock::now();
    for (;;) {
        if (const std::optional<int> status = child.look()) return endOf(*status, child, sandbox.isOn());
        context::throwIfInterrupted();
        if (std::string message = overWhat(child, limits, since); !message.empty()) {
            child.end();
            return {How::overLimit, std::move(message), ""};
        }
    }
}

} // namespace shadowlab::student
