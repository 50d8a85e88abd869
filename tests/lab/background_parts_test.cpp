// The small things the background judge and the window's plot are made of.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "app/lab/errors/background_priority.h"
#include "app/lab/errors/history.h"
#include "app/lab/errors/mailbox.h"
#include "techniques/foundation/trace/parallel.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace shadowlab::lab {
namespace {

TEST(Mailbox, TheLaterLetterTakesThePlaceOfTheEarlier) {
    Mailbox<int> box;
    EXPECT_FALSE(box.take());
    box.put(std::make_unique<int>(1));
    box.put(std::make_unique<int>(2));
    EXPECT_EQ(*box.take(), 2);
    EXPECT_FALSE(box.take());
    box.put(std::make_unique<int>(3)); // and is freed with the box: the leak checker would tell
}

TEST(Mailbox, LettersOfAnotherThreadComeInOrderAndTheLastOneArrives) {
    constexpr int kLast = 20'000;
    Mailbox<int> box;
    const std::jthread writer([&] {
        for (int i = 1; i <= kLast; ++i)
            box.put(std::make_unique<int>(i));
    });
    int newest = 0;
    while (newest < kLast)
        if (const auto letter = box.take()) {
            ASSERT_GT(*letter, newest);
            newest = *letter;
        }
}

#ifdef __linux__
TEST(BackgroundPriority, IsInheritedByTheThreadsOfParallelForAndByNobodyElse) {
    const int before = getpriority(PRIO_PROCESS, 0);
    std::atomic<int> low = 0, other = 0;
    std::jthread([&] {
        yieldToDrawing();
        trace::parallelFor(
            64, [&](std::size_t) { ++(getpriority(PRIO_PROCESS, 0) == kBackgroundNice ? low : other); }, 4);
    }).join();
    EXPECT_EQ(low, 64);
    EXPECT_EQ(other, 0);
    EXPECT_EQ(getpriority(PRIO_PROCESS, 0), before);
}
#endif

TEST(History, KeepsTheLastSamplesOldestFirst) {
    History history(3);
    EXPECT_TRUE(history.samples().empty());
    for (int i = 0; i < 5; ++i)
        history.add({0.5 * i, {{.frameMs = 10.0 + i, .wrongPixels = i}}});
    ASSERT_EQ(history.samples().size(), 3U);
    EXPECT_EQ(history.samples().front().seconds, 1.0);
    EXPECT_EQ(history.samples().back().seconds, 2.0);
    EXPECT_EQ(history.samples().back().slots[0].frameMs, 14.0);
    EXPECT_EQ(history.samples().back().slots[0].wrongPixels, 4);
    EXPECT_FALSE(history.samples().back().slots[0].edgeErrorPx);
    history.clear();
    EXPECT_TRUE(history.samples().empty());
}

} // namespace
} // namespace shadowlab::lab
