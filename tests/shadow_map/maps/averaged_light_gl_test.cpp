// Many maps, each from another point of a light with an area: their mean is the share of the light that can be seen.
//   half plane under a square light   JitteredMapsConvergeToTheVisibleShare; naive: RandomMapsConvergeMoreSlowly
//   points of a ball                  PointsOfABallFillItsDiscFromEverywhere
//   nothing to average                ALightWithoutAreaHasOneMap
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/query/light_points.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/half_plane.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using AveragedLightTest = testing::GlTest;

const testing::PlaneView& kView = testing::kHalfPlaneView;

/// Texels are 16 mm here: what that adds to the error of 64 answers is 0.0006. Root of the mean square of V - (1/2 + x) over the penumbra, over all pixels and some choices of points.
double rmse(const scene::Snapshot& scene, int count, const std::string& spread, int seeds) {
    double sum = 0;
    int compared = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const auto image = testing::renderVisibility(scene, "shadow-map",
                                                     {"filter=hard", "resolution=512", "light-points=" + spread,
                                                      "light-samples=" + std::to_string(count),
                                                      "light-seed=" + std::to_string(1000 * count + seed)},
                                                     kView.size, 0);
        for (int y = 0; y < kView.size.y; ++y)
            for (int x = 0; x < kView.size.x; ++x) {
                const double xWorld = (x + 0.5 - 0.5 * kView.size.x) / kView.pixelsPerMetre;
                if (std::abs(xWorld) > 0.5) continue;
                const double error = image.grey(x, y) / 255.0 - (0.5 + xWorld);
                sum += error * error;
                ++compared;
            }
    }
    EXPECT_EQ(compared, seeds * 64 * kView.size.y);
    return std::sqrt(sum / compared);
}

std::vector<double> errorsOf(const std::vector<int>& counts, const std::string& spread) {
    const scene::Snapshot scene = testing::snapshot(testing::halfPlaneUnderSquareLight());
    std::vector<double> errors;
    for (const int count : counts) {
        errors.push_back(rmse(scene, count, spread, 512 / count));
        std::cout << spread << ", " << count << " maps: RMSE " << errors.back() << '\n';
    }
    return errors;
}

const std::vector<int> kCounts = {4, 16, 64};

// Of n x n parts of the light only the n that the edge cuts are in doubt: the deviation of a mean of n^2 answers is
// sqrt(n) / n^2 = N^-3/4. Over 128 to 8 choices of points the slope itself has a deviation of some 0.03.
TEST_F(AveragedLightTest, JitteredMapsConvergeToTheVisibleShare) {
    const std::vector<double> errors = errorsOf(kCounts, "jittered");
    EXPECT_NEAR(testing::logSlope(kCounts, errors), -0.75, 0.07);
    EXPECT_LT(errors.back(), 0.02);
}

// All N are in doubt: N^-1/2.
TEST_F(AveragedLightTest, RandomMapsConvergeMoreSlowly) {
    const std::vector<double> errors = errorsOf(kCounts, "random");
    EXPECT_NEAR(testing::logSlope(kCounts, errors), -0.5, 0.07);
    EXPECT_GT(errors.back(), 0.04);
}

// Seen along any direction, the share of points within half the radius is a quarter. With 4096 jittered points a share is
// within 0.01 of that: even 4096 random ones have a deviation of 0.007, and parts of the ball that lie in the middle of
// one disc do not of another.
TEST_F(AveragedLightTest, PointsOfABallFillItsDiscFromEverywhere) {
    scene::Light ball;
    ball.type = scene::LightType::sphere;
    ball.positionWorld = {5, -3, 2};
    ball.radius = 0.7;
    const std::vector<dvec3> points = scene::pointsOfLight(ball, 0, {.count = 4096});
    ASSERT_EQ(points.size(), 4096u);
    for (const dvec3& along : {dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1), glm::normalize(dvec3(1, 1, 1)),
                               glm::normalize(dvec3(-1, 2, 0.5))})
        for (const double radius : {0.25, 0.5, 0.75}) {
            const auto inside = std::ranges::count_if(points, [&](const dvec3& point) {
                const dvec3 offset = (point - ball.positionWorld) / ball.radius;
                return glm::length(offset - glm::dot(offset, along) * along) < radius;
            });
            EXPECT_NEAR(static_cast<double>(inside) / 4096, radius * radius, 0.02) << radius;
        }
}

TEST_F(AveragedLightTest, ALightWithoutAreaHasOneMap) {
    const scene::Snapshot scene = testing::snapshot(testing::simpleScene());
    const auto picture = [&](const char* count) {
        return testing::renderVisibility(scene, "shadow-map", {std::string("light-samples=") + count}, {96, 64}, 0);
    };
    const auto one = picture("1"), many = picture("16");
    int shadowed = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) {
            ASSERT_EQ(one.grey(x, y), many.grey(x, y));
            shadowed += one.grey(x, y) < 128;
        }
    EXPECT_GT(shadowed, 100);
}

} // namespace
} // namespace shadowlab
