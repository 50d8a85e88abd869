// A light with an area, as many points of light: the share that each pixel sees.
//   half plane under a square light   JitteredPointsConvergeToTheVisibleShare
//                                     naive: RandomPointsConvergeMoreSlowly, AFewPointsAreAsManyCopies
//   partly below the horizon          PointsBehindThePlaneAreNotSeen
//   little by little                  WithoutTimeThePictureIsRefined
//   kept                              CountsAreKeptUntilSomethingMoves
// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/half_plane.h"
#include "tests/support/light_shares.h"

namespace shadowlab {
namespace {

using SoftPlanarTest = testing::GlTest;

const testing::PlaneView& kView = testing::kHalfPlaneView;

std::vector<std::string> settings(int count, const std::string& spread, int seed) {
    return {"light-samples=" + std::to_string(count), "light-points=" + spread, "light-seed=" + std::to_string(seed)};
}

/// Root of the mean square of V - (1/2 + x) over the penumbra, over all pixels and some choices of points.
double rmse(testing::TechniqueSlot& slot, int count, const std::string& spread, int seeds) {
    double sum = 0;
    int compared = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const testing::LightShares shares = slot.shares(settings(count, spread, 1000 * count + seed), kView.size);
        for (int y = 0; y < kView.size.y; ++y)
            for (int x = 0; x < kView.size.x; ++x) {
                const double xWorld = (x + 0.5 - 0.5 * kView.size.x) / kView.pixelsPerMetre;
                if (std::abs(xWorld) > 0.5) continue;
                const double error = testing::asNumber(shares.at(x, y)) - (0.5 + xWorld);
                sum += error * error;
                ++compared;
            }
    }
    EXPECT_EQ(compared, seeds * 64 * kView.size.y);
    return std::sqrt(sum / compared);
}

const std::vector<int> kCounts = {4, 16, 64, 256};

std::vector<double> errorsOf(const std::string& spread) {
    testing::TechniqueSlot slot("planar", testing::snapshot(testing::halfPlaneUnderSquareLight()));
    std::vector<double> errors;
    for (const int count : kCounts) {
        errors.push_back(rmse(slot, count, spread, std::max(8, 512 / count)));
        std::cout << spread << ", " << count << " points: RMSE " << errors.back() << '\n';
    }
    return errors;
}

// Of n x n parts of the light only the n that the edge cuts are in doubt: the deviation of a mean of n^2 answers is
// sqrt(n) / n^2 = N^-3/4. Over 128 to 8 choices of points the slope itself has a deviation of some 0.02.
TEST_F(SoftPlanarTest, JitteredPointsConvergeToTheVisibleShare) {
    const std::vector<double> errors = errorsOf("jittered");
    EXPECT_NEAR(testing::logSlope(kCounts, errors), -0.75, 0.07);
    EXPECT_LE(errors[2], 0.02) << "64 points";
}

// All N are in doubt: N^-1/2.
TEST_F(SoftPlanarTest, RandomPointsConvergeMoreSlowly) {
    const std::vector<double> errors = errorsOf("random");
    EXPECT_NEAR(testing::logSlope(kCounts, errors), -0.5, 0.07);
    EXPECT_GT(errors[2], 0.04);
}

TEST_F(SoftPlanarTest, AFewPointsAreAsManyCopies) {
    testing::TechniqueSlot slot("planar", testing::snapshot(testing::halfPlaneUnderSquareLight()));
    const auto levels = [&](int count) {
        std::set<float> found;
        const testing::LightShares shares = slot.shares(settings(count, "jittered", 7), kView.size);
        for (const float share : shares.values)
            found.insert(share);
        return found.size();
    };
    EXPECT_EQ(levels(1), 2u);
    EXPECT_EQ(levels(4), 5u) << "four hard shadows, one over the other";
    EXPECT_GT(levels(256), 50u);
    EXPECT_GT(rmse(slot, 1, "jittered", 1), 0.25);
    EXPECT_GT(rmse(slot, 4, "jittered", 32), 0.1);
}

// A wall in the middle of whose plane extended the light lies: whatever point it is asked from, half of the light is behind it.
TEST_F(SoftPlanarTest, PointsBehindThePlaneAreNotSeen) {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    const dmat4 upright(dvec4(1, 0, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, -1, 0, 0), dvec4(0, 1, 0, 1)); // faces +z
    testing::addObject(scene, scene::makeQuad({4, 2}), upright);
    scene.lights.push_back(testing::squareLight({0, 4, 0.125}));
    scene.camera.positionWorld = {0, 1, 6};
    scene.camera.targetWorld = {0, 1, 0};
    testing::TechniqueSlot slot("planar", testing::snapshot(scene));
    constexpr ivec2 kSize{96, 64};
    // 16 x 16 parts of equal depth: of 256 points those in the ten foremost rows are before the wall, z > 0.
    const testing::LightShares shares = slot.shares(settings(256, "jittered", 0), kSize);
    int compared = 0;
    for (const float share : shares.values) {
        if (share == testing::kNoShare) continue;
        EXPECT_FLOAT_EQ(share, 0.625f);
        ++compared;
    }
    EXPECT_GT(compared, 500);
}

// A window: the light lies in a wall, which then blocks none of it, wherever the wall stands and however it is turned. In the
// floats of the graphics card the wall flattened is nothing but rounding.
TEST_F(SoftPlanarTest, AWallDoesNotBlockTheLightInIt) {
    constexpr ivec2 kSize{160, 120};
    for (const double turn : {0.0, 0.6}) {
        scene::Scene scene = testing::floorScene();
        const dvec3 along(std::cos(turn), 0, std::sin(turn)), out(-std::sin(turn), 0, std::cos(turn));
        const dmat4 upright(dvec4(along, 0), dvec4(out, 0), dvec4(0, -1, 0, 0), dvec4(-3.0 * out + dvec3(0, 2, 0), 1));
        testing::addObject(scene, scene::makeQuad({6, 4}), upright);
        testing::addObject(scene, scene::makeBox({0.7, 1, 0.7}), testing::translation({0, 0.5, 0}));
        scene::Light window;
        window.type = scene::LightType::rect;
        window.positionWorld = -3.0 * out + dvec3(0, 1.7, 0);
        window.edgeUWorld = along;
        window.edgeVWorld = {0, 1, 0};
        scene.lights = {window};
        testing::TechniqueSlot slot("planar", testing::snapshot(scene));
        const testing::LightShares with = slot.shares(settings(64, "jittered", 1), kSize);
        scene.objects[1].castsShadow = false;
        slot.setScene(testing::snapshot(scene));
        const testing::LightShares without = slot.shares(settings(64, "jittered", 1), kSize);
        int compared = 0, partly = 0, differing = 0;
        for (std::size_t i = 0; i < with.values.size(); ++i) {
            if (with.values[i] == testing::kNoShare) continue;
            ++compared;
            partly += with.values[i] > 0 && with.values[i] < 1;
            differing += with.values[i] != without.values[i];
        }
        EXPECT_GT(compared, 10000);
        EXPECT_GT(partly, 300);
        EXPECT_EQ(differing, 0) << "turned by " << turn;
    }
}

class Progressive {
public:
    explicit Progressive(const scene::Scene& scene) : session_(testing::snapshot(scene)) {
        slots_.push_back(picture::Session::makeSlot("planar"));
        lab::applySettings(slots_, {"planar.light-samples=256"});
        view_.camera = scene.camera;
        view_.size = {640, 480};
    }
    /// A frame for which there is no time at all.
    bool drawInNoTime() {
        FrameRequest request;
        request.deadline = std::chrono::steady_clock::now();
        // What needs no GL is ready after some calls; then comes the first picture.
        picture::RenderedFrame frame;
        do
            frame = session_.render(slots_[0], view_, request);
        while (frame.prepared < 1);
        return frame.converged;
    }
    std::vector<vec4> drawToTheEnd() {
        EXPECT_TRUE(session_.render(slots_[0], view_, {}).converged);
        return shown();
    }
    std::vector<vec4> shown() { return gl::readTexels(slots_[0].target.color); }
    void set(const scene::Scene& scene) {
        session_.setScene(testing::snapshot(scene));
        view_.camera = scene.camera;
    }

private:
    picture::Session session_;
    std::vector<picture::Slot> slots_;
    View view_;
};

double meanDifference(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a[i].g - b[i].g);
    return sum / static_cast<double>(a.size());
}

scene::Scene softScene() {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::squareLight({1, 4, 1})};
    scene.lights[0].intensity = 20;
    return scene;
}

TEST_F(SoftPlanarTest, WithoutTimeThePictureIsRefined) {
    const scene::Scene scene = softScene();
    const std::vector<vec4> whole = Progressive(scene).drawToTheEnd();
    Progressive progressive(scene);
    EXPECT_FALSE(progressive.drawInNoTime());
    const double first = meanDifference(progressive.shown(), whole);
    int frames = 1;
    while (!progressive.drawInNoTime())
        ++frames;
    EXPECT_EQ(frames, 63) << "four points in each, the last of which it was done in";
    EXPECT_GT(first, 1e-4);
    EXPECT_EQ(progressive.shown(), whole);
}

TEST_F(SoftPlanarTest, CountsAreKeptUntilSomethingMoves) {
    scene::Scene scene = softScene();
    Progressive progressive(scene);
    progressive.drawToTheEnd();
    EXPECT_TRUE(progressive.drawInNoTime()) << "nothing was to be counted again";
    scene.objects[1].worldFromObject[3].x += 0.25;
    scene.revisions.transforms = scene::newRevision();
    progressive.set(scene);
    EXPECT_FALSE(progressive.drawInNoTime());
    EXPECT_EQ(progressive.drawToTheEnd(), Progressive(scene).drawToTheEnd());
    scene.camera.positionWorld.x += 0.5;
    progressive.set(scene);
    EXPECT_FALSE(progressive.drawInNoTime());
    EXPECT_EQ(progressive.drawToTheEnd(), Progressive(scene).drawToTheEnd());
}

TEST_F(SoftPlanarTest, ALightWithoutAreaIsOnePoint) {
    testing::TechniqueSlot slot("planar", testing::snapshot(testing::simpleScene()));
    constexpr ivec2 kSize{96, 64};
    EXPECT_EQ(slot.radiance({"light-samples=64"}, kSize), slot.radiance({}, kSize));
}

} // namespace
} // namespace shadowlab
