// Mesa's rasteriser on the processor, where threads are refused.
// SPDX-License-Identifier: MIT
#pragma once

namespace shadowlab::context {

/// llvmpipe counts on every thread that it asks for: where one is refused (ulimit -u, a container's limit of processes) it waits for
/// it for ever. So as many are asked for here, all at one time, and where that fails it is told to do without (LP_NUM_THREADS=0).
/// The pictures are the same. Called before the first context is made; later calls do nothing.
void doWithoutRefusedThreads();

} // namespace shadowlab::context
