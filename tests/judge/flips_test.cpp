// Flicker is what changes without the truth changing.
// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flips.h"

#include <gtest/gtest.h>

namespace shadowlab::judge {
namespace {

using Mask = std::vector<std::uint8_t>;

TEST(ExcessFlips, OfTheTruthItselfAreNone) {
    ExcessFlips flips;
    for (int frame = 0; frame < 5; ++frame) {
        Mask mask(10, 0);
        mask[static_cast<std::size_t>(frame)] = 1;
        flips.addFrame(mask, mask, 3.0);
    }
    EXPECT_EQ(flips.rate(), 0.0);
}

TEST(ExcessFlips, AreCountedPerPixelOfBoundary) {
    ExcessFlips flips;
    const Mask truth(10, 1);
    flips.addFrame({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 100.0); // the first frame has nothing to differ from
    flips.addFrame({0, 0, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 4.0);   // 2
    flips.addFrame({0, 0, 1, 1, 1, 1, 1, 1, 1, 0}, truth, 4.0);   // 1
    flips.addFrame({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 2.0);   // 3
    EXPECT_DOUBLE_EQ(*flips.rate(), 6.0 / 10.0);
}

TEST(ExcessFlips, WhereTheTruthFlipsTooNothingIsExcess) {
    ExcessFlips flips;
    flips.addFrame({0, 1}, {0, 1}, 1.0);
    flips.addFrame({1, 1}, {1, 0}, 1.0); // the second pixel stays, wrongly: an error, but no flicker
    EXPECT_EQ(flips.rate(), 0.0);
}

TEST(ExcessFlips, NeedTwoFramesAndABoundary) {
    ExcessFlips one;
    one.addFrame({1}, {1}, 5.0);
    EXPECT_FALSE(one.rate());
    one.addFrame({0}, {1}, 0.0);
    EXPECT_FALSE(one.rate());
}

} // namespace
} // namespace shadowlab::judge
