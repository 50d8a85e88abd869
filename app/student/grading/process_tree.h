// A process and all that it has started: what they hold, and their end.
// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace shadowlab::student {

struct TreeUse {
    std::uint64_t residentBytes = 0; ///< pages that two of them share count twice
    int processes = 0;
};

/// Direct children, also those of its other threads.
std::vector<pid_t> childrenOf(pid_t process);

/// The process itself is counted as well.
TreeUse useOf(pid_t process);

/// From now on a process whose parent has ended becomes a child of this one, so that what a child leaves behind can be found.
void adoptOrphans();

/// From now on other processes of the same user can neither read its memory nor attach to it.
void keepMemoryToItself();

/// Ends the children of this process that are not among `kept`, and waits for their end.
void endChildrenBut(const std::vector<pid_t>& kept);

} // namespace shadowlab::student
