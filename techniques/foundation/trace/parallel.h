// Splits work into fixed pieces over all cores. Any thread may do any piece, but the pieces do not depend on the number of
// threads, so the results are the same to the byte.
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
/// are done. Where the system refuses a thread, fewer do the work. The first exception is thrown on. Each calling thread has
/// helpers of its own, kept for its next call, so on Linux they have the place in the scheduler that it had at the first.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, int threads = 0);

/// Calls work(first) ... work(count - 1) in that order, but begins no piece after the deadline, except the first. Returns
/// the index of the first piece that was not done.
std::size_t parallelUntil(std::chrono::steady_clock::time_point deadline, std::size_t first, std::size_t count,
                          const std::function<void(std::size_t)>& work);

/// Thrown by work that was asked to stop; its result is not needed.
struct Stopped final : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "stopped on request"; }
};

/// The same, but checks before each piece whether a stop was requested, and throws Stopped then. A default token never
/// stops and costs nothing.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, const std::stop_token& stop);

} // namespace shadowlab::trace
