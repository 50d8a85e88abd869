// How many volumes the eye is in: closed forms, and lines that go exactly through edges and corners.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/eye_line.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using shadow_volume::CasterVolume;

/// The casters of the first light, built as the techniques build them.
class EyeLine : public ::testing::Test {
protected:
    const std::vector<CasterVolume>& castersOf(const scene::Scene& scene) {
        snapshot_ = testing::snapshot(scene);
        while (!casters_.buildNext(snapshot_)) {
        }
        return casters_.of(0);
    }
    int count(const scene::Scene& scene, const dvec3& eyeWorld) {
        int sum = 0;
        for (const CasterVolume& caster : castersOf(scene))
            sum += shadow_volume::eyeCount(*snapshot_, caster, {.planeWorld = caster.endWorld, .distance = {}},
                                           snapshot_->lights[0], eyeWorld);
        return sum;
    }
    bool grazes(const scene::Scene& scene, const dvec3& eyeWorld) {
        return std::ranges::any_of(castersOf(scene), [&](const CasterVolume& caster) {
            return shadow_volume::eyeLineGrazes(*snapshot_, caster, snapshot_->lights[0], eyeWorld);
        });
    }

private:
    scene::Snapshot snapshot_;
    shadow_volume::Casters casters_;
};

/// Two boxes and a torus over a floor, the light above or straight overhead at infinity.
scene::Scene tower(bool directional) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({2, 0.5, 2}), testing::translation({0, 2, 0}));
    testing::addObject(scene, scene::makeBox({1, 0.5, 1}), testing::translation({0, 3, 0}));
    testing::addObject(scene, scene::makeTorus(0.8, 0.2, {24, 12}), testing::translation({0, 4, 0}));
    scene.lights = {directional ? testing::directionalLight({0, -1, 0}) : testing::pointLight({0, 8, 0})};
    return scene;
}

TEST_F(EyeLine, CountsFrontFacesOfPartsThatCannotBeInsideOut) {
    for (const bool directional : {false, true}) {
        const scene::Scene scene = tower(directional);
        EXPECT_EQ(count(scene, {0.1, 1, 0.05}), 2) << "two boxes, and through the hole of the torus";
        EXPECT_EQ(count(scene, {0.1, 2.5, 0.05}), 1) << "between the boxes";
        EXPECT_EQ(count(scene, {0.1, 3.5, 0.05}), 0) << "over both";
        EXPECT_EQ(count(scene, {4, 1, 0}), 0) << "beside everything";
        EXPECT_EQ(count(scene, {0.1, -60, 0.05}), 0) << "beyond the end of all volumes";
    }
    EXPECT_EQ(count(tower(true), {0.8, 1, 0.1}), 2) << "the large box and the tube of the torus";
}

// The diagonals of a box's faces, and the corners of a sphere's poles, lie exactly on these lines.
TEST_F(EyeLine, ALineThroughEdgesAndCornersCountsOnce) {
    for (const bool directional : {false, true}) {
        scene::Scene scene = tower(directional);
        testing::addObject(scene, scene::makeSphere(0.5, 16), testing::translation({0, 5.5, 0}));
        EXPECT_EQ(count(scene, {0, 1, 0}), 3) << "boxes, along the diagonals' crossing; the sphere through its pole";
        EXPECT_FALSE(grazes(scene, {0, 1, 0})) << "no silhouette is near";
    }
    for (const double x : {0.25, -0.25, 0.125})
        EXPECT_EQ(count(tower(true), {x, 1, x}), 2) << "along a diagonal: " << x;
}

TEST_F(EyeLine, ASilhouetteThatIsSeenEdgeOnIsNoticed) {
    const scene::Scene scene = tower(true);
    EXPECT_TRUE(grazes(scene, {1, 1, 0.3})) << "in the plane of the large box's side";
    EXPECT_TRUE(grazes(scene, {1 + 1e-8, 1, 0.3}));
    EXPECT_FALSE(grazes(scene, {0.9, 1, 0.3}));
    EXPECT_FALSE(grazes(scene, {1, 2.5, 3})) << "in that plane, but nothing stands on the line to the light";
}

TEST_F(EyeLine, BoxesThatItPassesByAreOutOfTheQuestion) {
    const scene::Bounds box{dvec3(-1, 2, -1), dvec3(1, 3, 1)};
    const dvec4 light(0, 8, 0, 1), overhead(0, 1, 0, 0);
    EXPECT_TRUE(shadow_volume::eyeLineMayTouch(box, {0, 0, 0}, light));
    EXPECT_TRUE(shadow_volume::eyeLineMayTouch(box, {0, 2.5, 0}, light)) << "the eye is in it";
    EXPECT_FALSE(shadow_volume::eyeLineMayTouch(box, {0, 4, 0}, light)) << "behind the eye";
    EXPECT_FALSE(shadow_volume::eyeLineMayTouch(box, {0, 12, 0}, light)) << "behind the light";
    EXPECT_FALSE(shadow_volume::eyeLineMayTouch(box, {3, 0, 0}, light));
    EXPECT_TRUE(shadow_volume::eyeLineMayTouch(box, {0.5, -100, 0.5}, overhead));
    EXPECT_FALSE(shadow_volume::eyeLineMayTouch(box, {1.5, -100, 0.5}, overhead));
    EXPECT_TRUE(shadow_volume::eyeLineMayTouch(box, {1, -100, 1}, overhead)) << "along its edge: not certain";
}

} // namespace
} // namespace shadowlab
