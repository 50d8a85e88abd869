// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::trace {
namespace {

TEST(ParallelTest, EveryPieceIsDoneOnce) {
    for (const int threads : {1, 2, 7, 64})
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{10'000}}) {
            std::vector<std::atomic<int>> done(count);
            parallelFor(
                count, [&](std::size_t i) { ++done[i]; }, threads);
            for (const auto& times : done)
                ASSERT_EQ(times, 1);
        }
}

// Helpers are kept, by each thread its own: calls from several threads at once, calls within a piece of work, and more calls after
// that find what they need, whatever number they ask for.
TEST(ParallelTest, HelpersServeOneCallAfterTheOther) {
    std::atomic<long> sum = 0;
    const auto calls = [&] {
        for (int round = 0; round < 200; ++round)
            parallelFor(
                8,
                [&](std::size_t i) {
                    if (round % 10 != 0) return void(sum += static_cast<long>(i));
                    parallelFor(
                        3, [&](std::size_t) { sum += static_cast<long>(i); }, 2);
                },
                1 + round % 4);
    };
    {
        std::vector<std::jthread> callers;
        for (int i = 0; i < 3; ++i)
            callers.emplace_back(calls);
    }
    constexpr long kPerCall = 28; // 0 + 1 + ... + 7
    EXPECT_EQ(sum, 3 * (180 * kPerCall + 20 * 3 * kPerCall));
}

// What is thrown by one call does not stay for the next.
TEST(ParallelTest, AfterAnExceptionAllIsDoneAgain) {
    for (int round = 0; round < 50; ++round) {
        EXPECT_THROW(parallelFor(
                         20, [](std::size_t) { throw std::runtime_error("each"); }, 3),
                     std::runtime_error);
        std::atomic<int> done = 0;
        parallelFor(
            20, [&](std::size_t) { ++done; }, 3);
        ASSERT_EQ(done, 20);
    }
}

TEST(ParallelTest, AnExceptionReachesTheCaller) {
    for (const int threads : {1, 4})
        EXPECT_THROW(parallelFor(
                         100,
                         [](std::size_t i) {
                             if (i == 37) throw std::runtime_error("thirty-seven");
                         },
                         threads),
                     std::runtime_error);
}

TEST(ParallelTest, StopsBeforeTheNextPiece) {
    constexpr std::size_t kMany = 10'000;
    std::stop_source source;
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t i) {
        ++begun;
        if (i == 37) source.request_stop();
    };
    EXPECT_THROW(parallelFor(kMany, work, source.get_token()), Stopped);
    EXPECT_GT(begun, 37);
    EXPECT_LT(begun, static_cast<int>(kMany)) << "with two threads a few more than 38, but never all";

    begun = 0;
    parallelFor(kMany, work, std::stop_source().get_token()); // of a source that never requests a stop
    EXPECT_EQ(begun, static_cast<int>(kMany));
}

TEST(ParallelTest, GoesOnWhereADeadlineHasCutItOff) {
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t kMany = 1000;
    std::vector<std::atomic<int>> done(kMany);
    std::size_t next = 0;
    int slices = 0;
    while (next < kMany) {
        const std::size_t before = next;
        next = parallelUntil(Clock::now(), before, kMany, [&](std::size_t i) { ++done[i]; });
        ASSERT_GT(next, before); // always a bit
        for (std::size_t i = 0; i < kMany; ++i) // all before it, nothing beyond
            ASSERT_EQ(done[i], i < next ? 1 : 0);
        ++slices;
    }
    EXPECT_GT(slices, 2);
    EXPECT_EQ(parallelUntil(Clock::time_point::max(), 3, 3, [](std::size_t) { FAIL(); }), 3u);
    EXPECT_EQ(parallelUntil(Clock::time_point::max(), 0, 7, [](std::size_t) {}), 7u);
}

TEST(ParallelTest, TheNumberOfThreadsCanBeSet) {
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    ::setenv("SHADOWLAB_THREADS", "3", 1);
    EXPECT_EQ(threadCount(), 3);
    for (const char* wrong : {"0", "-1", "three", "3x", "99999999999"}) {
        ::setenv("SHADOWLAB_THREADS", wrong, 1);
        EXPECT_THROW((void)threadCount(), Error) << wrong;
    }
    ::unsetenv("SHADOWLAB_THREADS");
    EXPECT_GE(threadCount(), 1);
    if (before) ::setenv("SHADOWLAB_THREADS", kept.c_str(), 1);
}

} // namespace
} // namespace shadowlab::trace
