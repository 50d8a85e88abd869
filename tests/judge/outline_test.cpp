// The outline of a shadow, against outlines that are known in closed form: an ellipse, and squares.
// SPDX-License-Identifier: MIT
#include "app/judge/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

#include "app/judge/slot_errors.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

constexpr ivec2 kSize{320, 180};

std::vector<OutlineSegment> outlineOf(scene::Scene scene, ivec2 size = kSize) {
    const auto snapshot = testing::snapshot(std::move(scene));
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    const Truth centres = truthAtCentres(tracer, snapshot->camera, size, 0);
    return shadowOutline(tracer, snapshot->camera, centres, 0);
}

/// Mean and largest distance of the segments' ends from an ellipse, in pixels, the segments shifted by so much.
struct Distances {
    double mean = 0, largest = 0;
};
Distances distancesFrom(const testing::EllipseInPicture& ellipse, const std::vector<OutlineSegment>& outline,
                        dvec2 shift) {
    Distances distances;
    for (const OutlineSegment& segment : outline)
        for (const dvec2& end : {segment.from, segment.to}) {
            const double distance = std::abs(ellipse.distancePx(end + shift));
            distances.mean += distance / (2 * static_cast<double>(outline.size()));
            distances.largest = std::max(distances.largest, distance);
        }
    return distances;
}

/// In how many pieces the segments hang together.
int pieces(const std::vector<OutlineSegment>& outline) {
    std::map<std::pair<double, double>, std::pair<double, double>> parents;
    const std::function<std::pair<double, double>(std::pair<double, double>)> root = [&](std::pair<double, double> p) {
        const auto above = parents.try_emplace(p, p).first->second;
        return above == p ? p : parents[p] = root(above);
    };
    for (const OutlineSegment& segment : outline)
        parents[root({segment.from.x, segment.from.y})] = root({segment.to.x, segment.to.y});
    int roots = 0;
    for (const auto& [point, above] : parents)
        roots += point == above;
    return roots;
}

// The mesh lies inside the sphere by at most 1.9e-5 of its radius, which is 0.003 px of the shadow here.
TEST(Outline, OfASphereIsAnEllipseToAHundredthOfAPixel) {
    const testing::SphereShadow shadow = testing::sphereShadow(kSize, 512);
    const std::vector<OutlineSegment> outline = outlineOf(shadow.scene);
    ASSERT_GT(outline.size(), 300u);
    const Distances found = distancesFrom(shadow.ellipse, outline, dvec2(0));
    std::cout << outline.size() << " segments, ends " << found.mean << " px off on average, " << found.largest
              << " px at most\n";
    EXPECT_LT(found.mean, 0.5 * kOutlineErrorPx + 0.001); // the middle of what is left: half of it on average
    EXPECT_LT(found.largest, kOutlineErrorPx + 0.003);
    EXPECT_NEAR(lengthPx(outline), shadow.ellipse.lengthPx(), 2e-3 * shadow.ellipse.lengthPx());
    EXPECT_EQ(pieces(outline), 1);
}

// And what it would be seen by if it lay elsewhere.
TEST(Outline, ShiftedByAPixelIsNoneOfThatEllipse) {
    const testing::SphereShadow shadow = testing::sphereShadow(kSize, 512);
    const std::vector<OutlineSegment> outline = outlineOf(shadow.scene);
    for (const dvec2& shift : {dvec2(1, 0), dvec2(0, -1)}) {
        const Distances found = distancesFrom(shadow.ellipse, outline, shift);
        EXPECT_GT(found.mean, 0.5);
        EXPECT_GT(found.largest, 0.9);
    }
    const Distances found = distancesFrom(shadow.ellipse, outline, {0.03, 0}); // a thirty-second of a pixel, too
    EXPECT_GT(found.largest, 1.5 * kOutlineErrorPx + 0.003);
}

/// Two squares of one metre that face each other with a corner, seen and lit from straight above.
scene::Scene twoSquares(double overlap) {
    scene::Scene scene = testing::planeUnderLight({0, 1000, 0});
    scene.camera = testing::PlaneView{dvec2(0), 40, kSize}.camera();
    for (const double side : {-1.0, 1.0})
        testing::addObject(scene, scene::makeQuad({1, 1}),
                           testing::translation({side * (0.5 - overlap), 1, side * (0.5 - overlap)}));
    return scene;
}

// The corners meet in the middle of the picture, where four pixels meet: two of them lit, two in shadow, crosswise.
TEST(Outline, JoinsTwoShadowsOnlyWhereTheyTouch) {
    const double tenthOfAPixel = 0.1 / 40;
    const std::vector<OutlineSegment> touching = outlineOf(twoSquares(tenthOfAPixel)),
                                      apart = outlineOf(twoSquares(-tenthOfAPixel));
    EXPECT_GT(touching.size(), 300u);
    EXPECT_EQ(touching.size(), apart.size());
    EXPECT_EQ(pieces(touching), 1);
    EXPECT_EQ(pieces(apart), 2);
}

/// One object of two parallel sheets, the lower one in the upper one's shadow but for a strip at its right; the eye sees
/// the upper one's left end before the lower one, all of which is in shadow there.
TEST(Outline, IsNotWhereOneSheetHidesAnother) {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    scene.lights = {testing::directionalLight({1, -1, 0})};
    scene.camera.positionWorld = {0, 10, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, -1};
    const auto sheet = [](double left, double right, double y) {
        return std::vector<dvec3>{{left, y, -1}, {left, y, 1},  {right, y, 1},
                                  {left, y, -1}, {right, y, 1}, {right, y, -1}};
    };
    std::vector<dvec3> corners = sheet(-1, 1, 1);
    for (const dvec3& corner : sheet(-3, 3, 0))
        corners.push_back(corner);
    testing::addObject(scene, testing::triangleSoup(corners));
    const auto snapshot = testing::snapshot(scene);
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    const Truth centres = truthAtCentres(tracer, scene.camera, kSize, 0);
    const std::vector<OutlineSegment> outline = shadowOutline(tracer, scene.camera, centres, 0);
    // The shadow goes from x = 0 to x = 2 on the lower sheet. Of it the eye sees what is right of the upper sheet, whose
    // right end is lit: a silhouette between lit and shadowed pixels of one object, and no end of a shadow.
    const double pixelsPerMetre = 0.5 * kSize.y / std::tan(glm::radians(scene.camera.fovYDegrees) / 2) / 10;
    const double end = 0.5 * kSize.x + 2 * pixelsPerMetre;
    ASSERT_GT(outline.size(), 15u);
    for (const OutlineSegment& segment : outline) {
        EXPECT_NEAR(segment.from.x, end, 0.02);
        EXPECT_NEAR(segment.to.x, end, 0.02);
    }
    EXPECT_GT(trueBoundary(centres).size(), 2 * outline.size() - 5) << "the test is about pixels that do differ there";
}

} // namespace
} // namespace shadowlab::judge
