// Sentences with numbers in lines: no number, sum or measure is broken.
// SPDX-License-Identifier: MIT
#include "app/window/line_breaks.h"

#include <gtest/gtest.h>

namespace shadowlab::window {
namespace {

/// Every letter as wide as every other.
std::vector<std::string> broken(const std::string& text, float letters) {
    return brokenText(text, letters, [](const std::string& line) { return static_cast<float>(line.size()); });
}

using Lines = std::vector<std::string>;

TEST(LineBreaksTest, ANumberStaysWhole) {
    EXPECT_EQ(broken("the point is 1.00 m away", 15), (Lines{"the point", "is 1.00 m away"}));
    EXPECT_EQ(broken("the point is 1.00 m away", 14), (Lines{"the point", "is 1.00 m away"}));
    EXPECT_EQ(broken("IN SHADOW: d 2.286 m < z - bias 2.291 m", 22), (Lines{"IN SHADOW: d 2.286 m", "< z - bias 2.291 m"}));
    EXPECT_EQ(broken("texel (84, 90): d 0.5", 12), (Lines{"texel", "(84, 90):", "d 0.5"}));
    EXPECT_EQ(broken("sees 98 % of lamp", 8), (Lines{"sees", "98 % of", "lamp"}));
}

TEST(LineBreaksTest, ASumBreaksOnlyBeforeItsResult) {
    EXPECT_EQ(broken("z-pass: n_f - n_b = 1 - 0 = 1", 18), (Lines{"z-pass: n_f - n_b", "= 1 - 0 = 1"}));
    EXPECT_EQ(broken("z-pass: n_f - n_b = 1 - 0 = 1", 10), (Lines{"z-pass:", "n_f - n_b", "= 1 - 0", "= 1"}));
}

TEST(LineBreaksTest, WhatIsWiderThanALineBreaksAtItsBlanks) {
    EXPECT_EQ(broken("entered 1, left 0", 7), (Lines{"entered", "1,", "left 0"}));
    EXPECT_EQ(broken("indivisible", 4), (Lines{"indivisible"})) << "a word is never broken";
    EXPECT_EQ(broken("", 4), Lines());
}

} // namespace
} // namespace shadowlab::window
