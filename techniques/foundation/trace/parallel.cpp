// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/parallel.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "techniques/foundation/base/error.h"

namespace shadowlab::trace {

int threadCount() {
    constexpr int kMost = 1024;
    if (const char* given = std::getenv("SHADOWLAB_THREADS"); given && *given) {
        const std::string_view text(given);
        int count = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
        if (failure != std::errc() || end != text.data() + text.size() || count < 1 || count > kMost)
            throw Error(ExitStatus::usage, "SHADOWLAB_THREADS is '" + std::string(text) +
                                               "'; give a whole number from 1 to " + std::to_string(kMost));
        return count;
    }
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, int threads) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(failureMutex);
                if (!failure) failure = std::current_exception();
                next = count; // no thread begins another piece
            }
        }
    };
    const auto wanted = std::min(count, static_cast<std::size_t>(threads > 0 ? threads : threadCount()));
    {
        std::vector<std::jthread> helpers; // they are waited for at the end of the block
        helpers.reserve(wanted);
        try {
            while (helpers.size() + 1 < wanted)
                helpers.emplace_back(run);
        } catch (const std::system_error&) {
            // The system refuses more threads: the existing ones, at least this one, do all the work.
        }
        run();
    }
    if (failure) std::rethrow_exception(failure);
}

std::size_t parallelUntil(std::chrono::steady_clock::time_point deadline, std::size_t first, std::size_t count,
                          const std::function<void(std::size_t)>& work) {
    if (first >= count) return count;
    std::atomic<std::size_t> next = first;
    // One piece for each thread, which takes what there is to do.
    parallelFor(std::min(count - first, static_cast<std::size_t>(threadCount())), [&](std::size_t) {
        // The clock is read before a piece is taken, because a piece that was taken has to be finished.
        for (bool isFirst = next == first; isFirst || std::chrono::steady_clock::now() < deadline; isFirst = false) {
            const std::size_t i = next++;
            if (i >= count) return;
            work(i);
        }
    });
    return std::min(count, next.load());
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& work, const std::stop_token& stop) {
    parallelFor(count, [&](std::size_t i) {
        if (stop.stop_requested()) throw Stopped();
        work(i);
    });
}

} // namespace shadowlab::trace
