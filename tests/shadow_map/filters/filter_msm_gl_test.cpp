// Four moments know two depths and their shares, and less of more.
//   M15 one depth   OneDepthIsExactlyLit
//       two depths  TwoDepthsAreExactOnTheSecond (naive: msm-bias=0), TwoDepthsAreExactBehindBoth (naive: two moments)
//       digits      NoPixelIsDarkerForADepthFarAway
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/shadow_map/filters/layer_light.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using testing::asNumber;
using testing::bare;
using testing::Deviation;
using testing::deviation;
using testing::LightShares;
using testing::ShadowMapSlot;
using testing::StackedLayers;
using MomentShadowTest = testing::GlTest;

constexpr ivec2 kSize = StackedLayers::kSize;

// Where one of the three depths that the bound consists of is far beyond the map, its place has few digits. The other two must not
// share that.
TEST_F(MomentShadowTest, NoPixelIsDarkerForADepthFarAway) {
    double lack = -1;
    int lit = 0;
    for (const double ratio : {1.0, 4.0})
        for (const int radius : {7, 31}) {
            const StackedLayers stack({.a = 2, .b = 2 / ratio, .bEndsAtEdge = true}, testing::kLayerResolution, radius);
            ShadowMapSlot slot(testing::snapshot(stack.scene()));
            for (const char* msmBias : {"1e-6", "3e-6", "1e-5", "1.2e-5", "3e-5"}) {
                const LightShares shares = slot.shares(
                    bare("msm", {"blur-radius=" + std::to_string(radius), "msm-bias=" + std::string(msmBias)}), kSize);
                for (int y = 0; y < kSize.y; ++y)
                    for (int x = 0; x < kSize.x; ++x) {
                        const double light = (1 - stack.share(x)) * (1 - stack.share(y));
                        lit += light > 0.01;
                        lack = std::max(lack, light - asNumber(shares.at(x, y)));
                    }
            }
        }
    std::cout << "at most " << lack << " too dark\n";
    EXPECT_GT(lit, 100000);
    EXPECT_LE(lack, 1e-3);
}

// A layer alone: every kernel holds one depth, and what lies at it, or before it, has all the light, to the last bit.
TEST_F(MomentShadowTest, OneDepthIsExactlyLit) {
    for (const double b : {0.1, 1.0, 3.0, 8.0}) { // C, far below, only makes the map deeper
        const StackedLayers stack = testing::layers({.a = 1, .b = b, .seesB = true});
        scene::Scene scene = stack.scene();
        scene.objects[0].worldFromObject[3].x -= 3; // A out of the way
        ShadowMapSlot slot(testing::snapshot(scene));
        const auto notLit = [&](const std::vector<std::string>& settings) {
            const LightShares shares = slot.shares(bare("msm", settings), kSize);
            return std::ranges::count_if(shares.values, [](float share) { return share != 1; });
        };
        for (const char* radius : {"blur-radius=0", "blur-radius=1", "blur-radius=7", "blur-radius=31"})
            for (const char* before : {"constant-bias=0", "constant-bias=1", "constant-bias=20"}) // texels
                EXPECT_EQ(notLit({radius, before}), 0) << b << " " << radius << " " << before;
    }
}

// Four moments know two depths and their shares (three numbers). M15's criterion for that.
constexpr double kTwoDepthTolerance = 0.01;

// On B itself the light is B's share of the kernel: what an average of as many comparisons would say. Two moments know that
// as well; it is what variance shadow maps were made for.
TEST_F(MomentShadowTest, TwoDepthsAreExactOnTheSecond) {
    ShadowMapSlot slot(nullptr);
    const auto shareOfB = [](double p) { return 1 - p; };
    double worst = 0, worstWithoutBias = 0;
    for (const double b :
         {0.02, 0.5, 2.0, 8.0})               // and 2 m from A: B is near the far side of the map, or near its middle
        for (const int radius : {1, 7, 31}) { // the more is added up, the more is lost by rounding
            const StackedLayers stack({.a = 2, .b = b, .seesB = true}, testing::kLayerResolution, radius);
            slot.setScene(testing::snapshot(stack.scene()));
            const auto found = [&](const std::string& filter, const std::string& msmBias = "msm-bias=1e-6") {
                return deviation(slot.shares(bare(filter, {"blur-radius=" + std::to_string(radius), msmBias}), kSize),
                                 stack, shareOfB);
            };
            EXPECT_GT(found("msm").mixed, 7000);
            EXPECT_LE(found("msm").largest, kTwoDepthTolerance) << "a:b = " << 2 / b << ", " << radius;
            EXPECT_LE(found("vsm").largest, kTwoDepthTolerance) << "a:b = " << 2 / b << ", " << radius;
            worst = std::max(worst, found("msm").largest);
            worstWithoutBias = std::max(worstWithoutBias, found("msm", "msm-bias=0").largest);
        }
    std::cout << "msm differs by " << worst << ", without its bias by " << worstWithoutBias << "\n";
    EXPECT_GT(worstWithoutBias, 0.5) << "rounding alone makes moments that no depths have";
}

TEST_F(MomentShadowTest, TwoDepthsAreExactBehindBoth) {
    ShadowMapSlot slot(nullptr);
    for (const double ratio : {1.0, 2.0, 4.0, 10.0, 100.0}) {
        const StackedLayers stack = testing::layers({.a = 2, .b = 2 / ratio});
        slot.setScene(testing::snapshot(stack.scene()));
        const auto dark = [](double) { return 0.0; };
        const Deviation msm = deviation(slot.shares(bare("msm"), kSize), stack, dark);
        const Deviation vsm = deviation(slot.shares(bare("vsm"), kSize), stack, dark);
        std::cout << "behind, a:b = " << ratio << ": msm " << msm.largest << ", vsm " << vsm.largest << "\n";
        EXPECT_GT(msm.mixed, 7000);
        EXPECT_LE(msm.largest, kTwoDepthTolerance) << ratio;
        EXPECT_GT(vsm.largest, 0.1) << "two moments do not know it";
    }
}

} // namespace
} // namespace shadowlab
