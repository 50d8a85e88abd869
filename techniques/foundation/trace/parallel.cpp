// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/parallel.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "techniques/foundation/base/error.h"

namespace shadowlab::trace {

namespace {

/// The threads that help one thread, kept from one parallelFor to the next. A new thread begins when the scheduler gives it a turn,
/// on a busy processor after three milliseconds; one that waits is awake after a thirtieth of one.
class Helpers {
public:
    /// Runs `work` here and on `count` helpers, or fewer where the system refuses more threads, and returns when all have ended.
    void run(std::size_t count, const std::function<void()>& work) {
        {
            const std::lock_guard lock(mutex_);
            hire(count);
            work_ = &work;
            wanted_ = std::min(count, threads_.size());
        }
        begins_.notify_all();
        work();
        std::unique_lock lock(mutex_);
        wanted_ = 0; // who is not yet awake has missed it
        ended_.wait(lock, [this] { return working_ == 0; });
        work_ = nullptr;
    }
    /// Within work: the helpers are taken.
    [[nodiscard]] bool isAtWork() const { return work_ != nullptr; }

private:
    void hire(std::size_t count) {
        try {
            while (threads_.size() < count)
                threads_.emplace_back([this](const std::stop_token& stop) { help(stop); });
        } catch (const std::system_error&) {
            // Those there are do all the work, at least the calling thread.
        }
    }
    void help(const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (begins_.wait(lock, stop, [this] { return wanted_ > 0; })) {
            --wanted_;
            ++working_;
            const std::function<void()>& work = *work_;
            lock.unlock();
            work();
            lock.lock();
            if (--working_ == 0) ended_.notify_one();
        }
    }

    std::mutex mutex_;
    std::condition_variable_any begins_;
    std::condition_variable ended_;
    const std::function<void()>* work_ = nullptr;
    std::size_t wanted_ = 0, working_ = 0;
    std::vector<std::jthread> threads_; // last: stopped and waited for before the rest goes
};
thread_local Helpers helpersOfThisThread;

} // namespace

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
    if (wanted <= 1)
        run();
    else if (helpersOfThisThread.isAtWork()) // a piece of work that is itself done in pieces
        Helpers().run(wanted - 1, run);
    else
        helpersOfThisThread.run(wanted - 1, run);
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
