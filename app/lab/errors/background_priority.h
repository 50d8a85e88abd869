// Idle priority for threads that must not delay the drawing.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::lab {

/// Gives the calling thread, and each thread that it starts, idle priority (the policy SCHED_IDLE of Linux): it runs only while no
/// other thread wants the processor. On other systems, and where the call fails, nothing changes.
void yieldToAllOthers();

} // namespace shadowlab::lab
