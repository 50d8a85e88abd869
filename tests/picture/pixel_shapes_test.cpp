// The rays and vectors of a picked pixel as lines: nothing is missing, arrows point where the vectors do, and names stand at what
// they name.
// SPDX-License-Identifier: MIT
#include "app/picture/outside/pixel_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {
namespace {

scene::Camera outsideCamera() {
    scene::Camera camera;
    camera.positionWorld = {5, 4, 6};
    camera.targetWorld = {0, 0, 0};
    return camera;
}

Probe probeOfAMirror() {
    Probe probe;
    probe.geometry = {{"eye ray", {0, 1, 3}, {0, 0, 0}, Probe::Role::eye},
                      {"reflection ray R1", {0, 0, 0}, {0, 1, -3}, Probe::Role::reflection},
                      {"shadow ray", {0, 0, 0}, {2, 2, 0}, Probe::Role::arriving}};
    Probe::Node eye{-1, "eye ray", {}}, mirrored{0, "reflection ray R1", {}};
    eye.segment = 0;
    mirrored.role = Probe::Role::reflection;
    mirrored.sign = "R1";
    mirrored.segment = 1;
    probe.tree = {eye, mirrored};
    probe.vectors = {{"N", {0, 1, 0}}, {"R", glm::normalize(dvec3(0, 1, -3))}};
    return probe;
}

bool hasLine(const SceneShape& shape, const dvec3& from, const dvec3& to) {
    for (std::size_t i = 0; i + 1 < shape.pointsWorld.size(); i += 2)
        if (glm::length(shape.pointsWorld[i] - from) + glm::length(shape.pointsWorld[i + 1] - to) < 1e-12) return true;
    return false;
}

const SceneShape& ofColor(const std::vector<SceneShape>& shapes, const vec3& color) {
    const auto found = std::ranges::find(shapes, color, &SceneShape::colorLinear);
    EXPECT_NE(found, shapes.end());
    return *found;
}

TEST(PixelShapesTest, EveryRayHasItsLineInTheColourOfItsKind) {
    const Probe probe = probeOfAMirror();
    const std::vector<SceneShape> shapes = pixelShapes(probe, outsideCamera());
    const std::array<vec3, 3> colors = {look::kEyeRay, look::kReflectionRay, look::kEqualDepth};
    for (std::size_t i = 0; i < colors.size(); ++i)
        EXPECT_TRUE(hasLine(ofColor(shapes, colors[i]), probe.geometry[i].fromWorld, probe.geometry[i].toWorld)) << i;
    EXPECT_TRUE(ofColor(shapes, look::kRefractionRay).pointsWorld.empty());
    EXPECT_TRUE(pixelShapes({}, outsideCamera()).empty()) << "the background has no rays";
}

TEST(PixelShapesTest, VectorsAreArrowsFromWhereTheEyeRayEnds) {
    const Probe probe = probeOfAMirror();
    const std::vector<SceneShape> shapes = pixelShapes(probe, outsideCamera());
    for (const auto& [vector, color] :
         {std::pair(probe.vectors[0], look::kEyeRay), std::pair(probe.vectors[1], look::kReflectionRay)}) {
        const std::vector<dvec3>& points = ofColor(shapes, color).pointsWorld;
        int arrows = 0;
        for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
            const dvec3 way = points[i + 1] - points[i];
            const bool alongIt = glm::dot(glm::normalize(way), vector.directionWorld) > 1 - 1e-12;
            arrows += points[i] == dvec3(0.0) && alongIt && glm::length(way) < 2;
        }
        EXPECT_EQ(arrows, 1) << vector.label;
    }
}

// The same arrows for a camera twice as far away are twice as long: they are made for who looks on.
TEST(PixelShapesTest, ArrowsAreAsLargeAsTheOnlookerHasToSeeThem) {
    Probe probe = probeOfAMirror();
    probe.vectors = {{"N", {0, 1, 0}}};
    probe.tree.clear();
    scene::Camera near = outsideCamera(), far = near;
    far.positionWorld *= 2.0;
    const auto longest = [&](const scene::Camera& camera) {
        double length = 0;
        const std::vector<SceneShape> shapes = pixelShapes(probe, camera);
        const std::vector<dvec3>& points = ofColor(shapes, look::kEyeRay).pointsWorld;
        for (std::size_t i = 2; i + 1 < points.size(); i += 2) // the first is the ray itself
            length = std::max(length, glm::length(points[i + 1] - points[i]));
        return length;
    };
    EXPECT_GT(longest(near), 0.5);
    EXPECT_NEAR(longest(far), 2 * longest(near), 1e-9);
}

TEST(PixelNamesTest, NamesStandAtTheEndsOfArrowsAndInTheMiddleOfRays) {
    const std::vector<NamedPoint> names = pixelNames(probeOfAMirror(), outsideCamera());
    const std::vector<SceneShape> shapes = pixelShapes(probeOfAMirror(), outsideCamera());
    ASSERT_EQ(names.size(), 3u);
    int found = 0;
    for (const NamedPoint& name : names) {
        if (name.text == "R1") {
            EXPECT_EQ(name.placeWorld, dvec3(0, 0.5, -1.5));
            EXPECT_EQ(name.colorLinear, look::kReflectionRay);
            ++found;
            continue;
        }
        const vec3 color = name.text == "N" ? look::kEyeRay : look::kReflectionRay;
        EXPECT_EQ(name.colorLinear, color) << name.text;
        const std::vector<dvec3>& points = ofColor(shapes, color).pointsWorld;
        EXPECT_NE(std::ranges::find(points, name.placeWorld), points.end()) << name.text << " is the tip of an arrow";
        ++found;
    }
    EXPECT_EQ(found, 3);
    EXPECT_TRUE(pixelNames({}, outsideCamera()).empty());
}

} // namespace
} // namespace shadowlab::picture
