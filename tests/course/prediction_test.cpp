// Scores of painted shadows: counted by hand on made-up truths.
// SPDX-License-Identifier: MIT
#include "app/course/lessons/prediction.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace shadowlab::course {
namespace {

using trace::Visibility;

/// The left half is in shadow; of the right half the last ten columns are turned away, and the last row shows nothing.
judge::Truth halfShadow() {
    judge::Truth truth;
    truth.size = kPredictionSize;
    for (int y = 0; y < truth.size.y; ++y)
        for (int x = 0; x < truth.size.x; ++x) {
            truth.visibility.push_back(y == truth.size.y - 1    ? Visibility::noSurface
                                       : x < truth.size.x / 2   ? Visibility::shadowed
                                       : x >= truth.size.x - 10 ? Visibility::turnedAway
                                                                : Visibility::lit);
            truth.ties.push_back(0);
        }
    return truth;
}

TEST(Prediction, NothingPaintedFindsNothing) {
    const PredictionScore score = scorePrediction({}, halfShadow());
    EXPECT_EQ(score.right, 0);
    EXPECT_EQ(score.wrong, 0);
    EXPECT_EQ(score.missed, 80 * 89);
    EXPECT_EQ(score.paintedRight(), 0);
    EXPECT_EQ(score.shadowFound(), 0);
}

TEST(Prediction, EverythingPaintedFindsAllAndIsRightByTheShadowsShare) {
    Prediction all;
    all.paint({0.5, 0.5}, 2, true); // a disc beyond all corners
    const PredictionScore score = scorePrediction(all, halfShadow());
    EXPECT_EQ(score.right, 80 * 89);
    EXPECT_EQ(score.wrong, 70 * 89); // the turned away ten columns cost nothing
    EXPECT_EQ(score.shadowFound(), 1);
    EXPECT_DOUBLE_EQ(score.paintedRight(), 80.0 / 150);
    all.paint({0.5, 0.5}, 2, false);
    EXPECT_TRUE(all.isEmpty());
}

TEST(Prediction, ADiscCoversTheCellsWhoseMiddlesLieInIt) {
    Prediction disc;
    disc.paint({0.25, 0.5}, 0.2, true);
    int painted = 0;
    for (int y = 0; y < kPredictionSize.y; ++y)
        for (int x = 0; x < kPredictionSize.x; ++x)
            painted += disc.isPainted(x, y) ? 1 : 0;
    EXPECT_NEAR(painted, 3.14159 * 18 * 18, 30); // its area in cells, but for its rim of 113 cells
    EXPECT_EQ(scorePrediction(disc, halfShadow()).wrong, 0);
    EXPECT_EQ(scorePrediction(disc, halfShadow()).paintedRight(), 1);
}

TEST(Prediction, TiesAreNotJudged) {
    judge::Truth truth = halfShadow();
    std::ranges::fill(truth.ties, std::uint8_t{1});
    Prediction all;
    all.paint({0.5, 0.5}, 2, true);
    const PredictionScore score = scorePrediction(all, truth);
    EXPECT_EQ(score.right + score.wrong + score.missed, 0);
    truth.size = {10, 10};
    EXPECT_THROW(scorePrediction(all, truth), std::logic_error);
}

} // namespace
} // namespace shadowlab::course
