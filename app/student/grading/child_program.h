// This very program once more, in a process of its own that may crash, hang, or take all the memory there is.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "app/student/grading/child_process.h"
#include "app/student/grading/sandbox.h"

namespace shadowlab::student {

struct ChildLimits {
    std::chrono::seconds time{30};          ///< on the wall
    std::uint64_t memoryBytes = 2ull << 30; ///< that are in memory (resident), of all its processes, as looked at fifty times a second
    int processes = 64;                     ///< at one time
};

struct ChildEnd {
    enum class How { finished, failed, crashed, overLimit };
    How how = How::finished;
    std::string message; ///< why it failed: the last line it said; or what else happened, as a sentence without its end
    std::string out;     ///< what it wrote to standard output, up to 1 MiB
};

/// Runs `shadowlab WORDS...` in the sandbox, if there is one, and waits for its end. All that it has started is ended with it. Throws
/// Error (overLimit) where no process can be started, and context::Interrupted.
ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits, const Sandbox& sandbox, const SandboxRoom& room);

// --- parts of it, for children that stay (search/scene_painter.h)

/// Which limit it is over, as such a message; empty: none. `since`: when it began with what it does.
std::string overWhat(const ChildProcess& child, const ChildLimits& limits, std::chrono::steady_clock::time_point since);

/// How a child with that wait status has ended. `inSandbox`: the status is bwrap's, which tells a signal as 128 and its number.
ChildEnd endOf(int waitStatus, ChildProcess& child, bool inSandbox);

} // namespace shadowlab::student
