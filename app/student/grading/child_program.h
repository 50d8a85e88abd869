// This very program once more, in a process of its own that may crash, hang, or take all the memory there is.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace shadowlab::student {

struct ChildLimits {
    std::chrono::seconds time{30};          ///< on the wall
    std::uint64_t memoryBytes = 2ull << 30; ///< that are in memory (resident), as looked at fifty times a second
};

struct ChildEnd {
    enum class How { finished, failed, crashed, outOfTime, outOfMemory };
    How how = How::finished;
    int status = 0;      ///< exit status, where it failed
    std::string message; ///< why it failed: the last line it said; or what else happened, as a sentence without its end
    std::string out;     ///< what it wrote to standard output, up to 1 MiB
};

/// Runs `shadowlab WORDS...`, and waits for its end. It leads a process group of its own, all of which is ended with it; it writes no
/// core file, and no file larger than 1 GiB. Throws Error (overLimit) where no process can be started, and context::Interrupted.
ChildEnd runChild(const std::vector<std::string>& words, const ChildLimits& limits);

} // namespace shadowlab::student
