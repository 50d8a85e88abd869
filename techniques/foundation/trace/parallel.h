// Work split into fixed pieces over all cores. Which thread does a piece is left open, what a piece is never depends on
// the number of threads: same bytes for any of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <stop_token>

namespace shadowlab::trace {

/// How many threads to use: SHADOWLAB_THREADS where it is set (1 to 1024, or Error: usage), else one per core.
int threadCount();

/// Calls work(0) ... work(count - 1), each once, on up to `threads` threads (0: threadCount()), and returns when all
/// are done. Where the system refuses a thread, fewer do the work. The first exception is thrown on. The threads are new
/// ones each time, so on Linux they inherit the caller's place in the scheduler.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, int threads = 0);

/// Calls work(first) ... work(count - 1) in that order, but begins none once the time has come; the first of them always. Returns
/// the first that was not done: all before it are.
std::size_t parallelUntil(std::chrono::steady_clock::time_point deadline, std::size_t first, std::size_t count,
                          const std::function<void(std::size_t)>& work);

/// Thrown by work that was asked to stop: nobody waits for what it would have found.
struct Stopped final : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "stopped on request"; }
};

/// The same, but asks before each piece whether somebody wants it to stop, and throws Stopped then. A token that nobody
/// can stop costs nothing and changes nothing.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, const std::stop_token& stop);

} // namespace shadowlab::trace
