// Work split into fixed pieces over all cores. Which thread does a piece is left open, what a piece is never depends on
// the number of threads: same bytes for any of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace shadowlab::trace {

/// How many threads to use: SHADOWLAB_THREADS where it is set (1 to 1024, or Error: usage), else one per core.
int threadCount();

/// Calls work(0) ... work(count - 1), each once, on up to `threads` threads (0: threadCount()), and returns when all
/// are done. Where the system refuses a thread, fewer do the work. The first exception is thrown on.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, int threads = 0);

} // namespace shadowlab::trace
