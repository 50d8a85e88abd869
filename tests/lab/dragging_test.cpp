// Dragging: every light and every object of every built-in scene follows the mouse, whichever way it goes.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/context/assets.h"
#include "app/lab/dragging.h"
#include "app/lab/object_picking.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::lab {
namespace {

constexpr ivec2 kSize(1280, 720);
constexpr double kMargin = 36; ///< of the marks at the picture's edge, as in a window of that size
constexpr double kPixels = 40; ///< how far the mouse goes: a small movement of the hand

dvec2 direction(int eighth) {
    const double angle = eighth * std::numbers::pi / 4;
    return {std::cos(angle), std::sin(angle)};
}

scene::Snapshot loaded(const std::string& name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

/// Where the handle of that thing lies.
dvec3 placeOf(const scene::Scene& scene, const Selection& what) {
    const auto all = handles(scene, scene::objectBounds(scene), scene.camera);
    const auto found = std::ranges::find(all, what, &Handle::what);
    EXPECT_NE(found, all.end());
    return found->positionWorld;
}

/// How far the thing goes in the plane that faces the eye: x to the right and y down, in metres.
dvec2 seenMovement(const scene::Camera& camera, const dvec3& byWorld) {
    const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.upWorld));
    return {glm::dot(byWorld, right), -glm::dot(byWorld, glm::cross(right, forward))};
}

/// As the mouse takes hold of a thing in the scene's own view: at its place, or at its mark.
Hold takenHold(const scene::Scene& scene, const Handle& handle) {
    const auto mark = edgeMarkOf(scene.camera, kSize, kMargin, handle.positionWorld);
    return holdOf(scene.camera, kSize, scene, handle, handle.positionWorld,
                  mark ? std::optional(mark->pixel) : std::nullopt);
}

double cosineBetween(const dvec2& a, const dvec2& b) { return glm::dot(a, b) / (glm::length(a) * glm::length(b)); }

TEST(Dragging, EveryLightAndObjectOfEverySceneFollowsInEightDirections) {
    int inPicture = 0, outside = 0, turned = 0;
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        const scene::Snapshot before = loaded(name);
        const scene::Camera& camera = before->camera;
        for (const Handle& handle : handles(*before, scene::objectBounds(*before), camera)) {
            const auto mark = edgeMarkOf(camera, kSize, kMargin, handle.positionWorld);
            const Hold hold = takenHold(*before, handle);
            for (int eighth = 0; eighth < 8; ++eighth) {
                const dvec2 mouse = kPixels * direction(eighth);
                const std::string what = name + ", " + handle.label + ", direction " + std::to_string(eighth);
                const dvec3 byWorld = draggedBy(hold, camera, kSize, handle.positionWorld, mouse);
                const scene::Snapshot after = withMoved(before, handle.what, byWorld, camera);
                const dvec3 movedWorld = placeOf(*after, handle.what) - handle.positionWorld;
                ASSERT_GT(glm::length(movedWorld), 0) << what;
                if (hold.way == DragWay::turn) {
                    // Over the edge of the ball it goes around it: then the picture shows less of the way. The way may bend, near the
                    // view's upright axis most, which shortens the straight line to its end.
                    ++turned;
                    const double reach = glm::length(camera.targetWorld - camera.positionWorld);
                    const double way = reach * kPixels * 2 * std::tan(glm::radians(camera.fovYDegrees) / 2) / kSize.y;
                    EXPECT_LT(glm::length(movedWorld), 1.001 * way) << what;
                    EXPECT_GT(glm::length(movedWorld), 0.7 * way) << what;
                    continue;
                }
                const auto from = pixelOf(camera, kSize, handle.positionWorld),
                           to = pixelOf(camera, kSize, handle.positionWorld + movedWorld);
                if (mark || !from || !to) {
                    ++outside;
                    // 0.99: the directions differ by rounding alone, for the plane faces the eye.
                    EXPECT_GT(cosineBetween(seenMovement(camera, movedWorld), mouse), 0.99) << what;
                } else {
                    ++inPicture;
                    // Within 25 degrees, and at least a third of the way where the horizon is near and the step has a limit.
                    EXPECT_GT(cosineBetween(*to - *from, mouse), 0.9) << what;
                    EXPECT_GT(glm::length(*to - *from), kPixels / 3) << what;
                    EXPECT_LT(glm::length(*to - *from), kPixels * 1.5) << what;
                }
            }
        }
    }
    EXPECT_GE(inPicture, 300);
    EXPECT_GE(outside, 80);
    EXPECT_GE(turned, 8) << "suns";
}

// The way there and the way back end where they began, and many small movements lead as far as one: no jump, and no place where it sticks.
TEST(Dragging, IsContinuous) {
    int compared = 0;
    for (const char* name : {"still-life", "three-lights", "colonnade", "cornell-room"}) {
        const scene::Snapshot scene = loaded(name);
        const scene::Camera& camera = scene->camera;
        for (const Handle& handle : handles(*scene, scene::objectBounds(*scene), camera)) {
            const Hold hold = takenHold(*scene, handle);
            for (int eighth = 0; eighth < 8; ++eighth) {
                const dvec2 one = direction(eighth);
                dvec3 placeWorld = handle.positionWorld;
                double shortest = 1e300, longest = 0;
                for (int i = 0; i < 40; ++i) {
                    const dvec3 byWorld = draggedBy(hold, camera, kSize, placeWorld, one);
                    shortest = std::min(shortest, glm::length(byWorld));
                    longest = std::max(longest, glm::length(byWorld));
                    placeWorld += byWorld;
                }
                EXPECT_GT(shortest, longest / 12) << name << ", " << handle.label << ": sticks, or jumps";
                const dvec3 atOnce = draggedBy(hold, camera, kSize, handle.positionWorld, 40.0 * one);
                const double way = glm::length(placeWorld - handle.positionWorld);
                EXPECT_LT(glm::length(handle.positionWorld + atOnce - placeWorld), 0.2 * way) << name << ", " << handle.label;
                ++compared;
            }
        }
    }
    EXPECT_GE(compared, 150);
}

// Of a lamp above the eye the plane level with the ground is never met by the mouse's ray. That way nothing moved.
TEST(Dragging, ALampAboveTheEyeMoves) {
    scene::Scene scene;
    scene.lights.emplace_back();
    scene.lights[0].positionWorld = {0.5, 3, 0};
    scene.camera.positionWorld = {0, 1, 5};
    scene.camera.targetWorld = {0, 1, 0};
    const Handle lamp = handles(scene, {}, scene.camera)[0];
    const Hold hold = holdOf(scene.camera, kSize, scene, lamp, lamp.positionWorld, {});
    const dvec3 up = draggedBy(hold, scene.camera, kSize, lamp.positionWorld, {0, -40});
    const auto from = pixelOf(scene.camera, kSize, lamp.positionWorld),
               to = pixelOf(scene.camera, kSize, lamp.positionWorld + up);
    ASSERT_TRUE(from && to);
    EXPECT_LT(to->y, from->y - 10);
    EXPECT_NEAR(to->x, from->x, 4);
}

// A lamp beside the eye has next to no depth: measured there, hundreds of pixels of the mouse would move it by millimetres.
TEST(Dragging, ALampBesideTheEyeMovesAsWhatIsLookedAtDoes) {
    scene::Scene scene;
    scene.lights.emplace_back();
    scene.camera.positionWorld = {0, 1, 5};
    scene.camera.targetWorld = {0, 1, 0};
    const double metresPerPixel = 5 * 2 * std::tan(glm::radians(scene.camera.fovYDegrees) / 2) / kSize.y;
    for (const double z : {4.9, 5.0, 6.0, 2.5}) { // before the eye, beside it, behind it; and half way to the target
        scene.lights[0].positionWorld = {9, 1.5, z};
        const Handle lamp = handles(scene, {}, scene.camera)[0];
        const auto mark = edgeMarkOf(scene.camera, kSize, kMargin, lamp.positionWorld);
        ASSERT_TRUE(mark);
        const Hold hold = holdOf(scene.camera, kSize, scene, lamp, lamp.positionWorld, mark->pixel);
        const dvec3 moved = draggedBy(hold, scene.camera, kSize, lamp.positionWorld, {-100, 0});
        EXPECT_NEAR(moved.x, -100 * metresPerPixel, 1e-9) << z;
        EXPECT_NEAR(moved.y, 0, 1e-9);
    }
}

// A sun nearly overhead, as that of hung-ring: a wheel's axis through it would let it go round in a small circle. It goes on in the
// direction of the mouse up to the edge of the ball, wherever on it it begins, and comes back the way it went.
TEST(Dragging, ASunNeverTurnsBackBeforeTheEdgeOfTheBall) {
    scene::Scene scene;
    scene.lights.emplace_back();
    scene.lights[0].type = scene::LightType::directional;
    scene.camera.positionWorld = {0, 3, 8};
    scene.camera.targetWorld = {0, 0, 0};
    const double reach = glm::length(scene.camera.positionWorld);
    const dvec3 forward = -scene.camera.positionWorld / reach;
    int drags = 0, steps = 0;
    for (int azimuth = 0; azimuth < 360; azimuth += 15)
        for (int elevation = 5; elevation <= 89; elevation += 7) {
            const double a = glm::radians<double>(azimuth), e = glm::radians<double>(elevation);
            const dvec3 start = reach * dvec3(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
            const Hold hold{.way = DragWay::turn, .side = glm::dot(start, forward) <= 0 ? 1.0 : -1.0};
            for (int eighth = 0; eighth < 8; ++eighth, ++drags) {
                const dvec2 mouse = 4.0 * direction(eighth);
                dvec3 place = start;
                int i = 0;
                for (; i < 60; ++i) {
                    const dvec3 moved = draggedBy(hold, scene.camera, kSize, place, mouse);
                    if (hold.side * glm::dot(place + moved, forward) > 0) break; // over the edge
                    EXPECT_GT(glm::dot(seenMovement(scene.camera, moved), mouse), 0) << azimuth << ' ' << elevation << ' ' << eighth;
                    place += moved;
                    ++steps;
                }
                for (; i > 0; --i) place += draggedBy(hold, scene.camera, kSize, place, -mouse);
                // A step follows the tangent of a circle: there and back differ by what the circle bends within four pixels.
                EXPECT_LT(glm::length(place - start), 0.02 * reach) << azimuth << ' ' << elevation << ' ' << eighth;
            }
        }
    EXPECT_GE(drags, 2000);
    EXPECT_GE(steps, 50000);
}

TEST(ObjectPicking, TheObjectUnderEachHandleIsFoundAndNothingElseIsBehindTheEye) {
    int found = 0, surfaces = 0;
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        const scene::Snapshot scene = loaded(name);
        const std::vector<scene::Bounds> bounds = scene::objectBounds(*scene);
        for (int y = 20; y < kSize.y; y += 60)
            for (int x = 20; x < kSize.x; x += 60) {
                const auto hit = objectAt(*scene, bounds, scene->camera, kSize, {x + 0.5, y + 0.5});
                if (!hit) continue;
                ++surfaces;
                const auto pixel = pixelOf(scene->camera, kSize, hit->positionWorld);
                if (!pixel) continue; // nearer than the near plane
                EXPECT_LT(glm::length(*pixel - dvec2(x + 0.5, y + 0.5)), 1e-6) << name;
                const scene::Bounds& box = bounds[hit->object];
                for (int axis = 0; axis < 3; ++axis) {
                    // The box is that of rounded vertices: a thousandth of its size is far more than rounding.
                    const double slack = 1e-6 + 1e-3 * (box.upperWorld[axis] - box.lowerWorld[axis]);
                    EXPECT_GE(hit->positionWorld[axis], box.lowerWorld[axis] - slack) << name;
                    EXPECT_LE(hit->positionWorld[axis], box.upperWorld[axis] + slack) << name;
                }
                found += !isBackdrop(bounds, hit->object);
            }
    }
    EXPECT_GE(surfaces, 1500);
    EXPECT_GE(found, 200) << "things that stand in the scenes, and not what they stand on";
}

} // namespace
} // namespace shadowlab::lab
