// A thread that must not be in anybody's way.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::lab {

/// From here on the calling thread, and each thread that it starts, leaves the processor to whoever else wants it. Linux
/// only (the policy SCHED_IDLE); elsewhere, and where the system refuses, nothing changes.
void yieldToAllOthers();

} // namespace shadowlab::lab
