// The camera's matrices and its rays agree, and points at infinity keep a place.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/camera.h"

#include <gtest/gtest.h>

namespace shadowlab::scene {
namespace {

Camera tilted() {
    Camera camera;
    camera.positionWorld = {3, 2.5, 5};
    camera.targetWorld = {0, 0.6, 0};
    camera.fovYDegrees = 50;
    return camera;
}

TEST(Camera, ViewSpaceHasItsOriginAtTheEyeAndLooksDownMinusZ) {
    const Camera camera = tilted();
    const dmat4 view = viewFromWorld(camera);
    EXPECT_LT(glm::length(transformPoint(view, camera.positionWorld)), 1e-14);
    const dvec3 target = transformPoint(view, camera.targetWorld);
    EXPECT_NEAR(target.x, 0, 1e-14);
    EXPECT_NEAR(target.y, 0, 1e-14);
    EXPECT_NEAR(target.z, -glm::length(camera.targetWorld - camera.positionWorld), 1e-14);
    EXPECT_GT(transformDirection(view, {0, 1, 0}).y, 0.5); // up is up
}

// A point on the ray through a place of the picture projects to that place; row 0 is at the top.
TEST(Camera, RaysAndProjectionAgree) {
    const Camera camera = tilted();
    const ivec2 size{640, 480};
    const dmat4 clipFromWorld = clipFromView(camera, 640.0 / 480.0) * viewFromWorld(camera);
    for (const dvec2 pixel : {dvec2(0.5, 0.5), dvec2(320, 240), dvec2(639.5, 10.25), dvec2(77, 401)})
        for (const double distance : {0.2, 3.0, 5000.0}) {
            const dvec3 point = camera.positionWorld + distance * rayDirectionWorld(camera, pixel, size);
            const dvec4 clip = clipFromWorld * dvec4(point, 1);
            EXPECT_NEAR((clip.x / clip.w * 0.5 + 0.5) * size.x, pixel.x, 1e-8);
            EXPECT_NEAR((0.5 - clip.y / clip.w * 0.5) * size.y, pixel.y, 1e-8);
            EXPECT_LT(clip.z / clip.w, 1);
        }
}

TEST(Camera, DepthRunsFromTheNearPlaneToInfinity) {
    const Camera camera = tilted();
    const dmat4 clip = clipFromView(camera, 1.5);
    const dvec4 near = clip * dvec4(0, 0, -camera.near, 1), infinite = clip * dvec4(0.3, -0.2, -1, 0);
    EXPECT_NEAR(near.z / near.w, -1, 1e-15);
    EXPECT_EQ(infinite.z, infinite.w); // exactly on the far plane, wherever that is
}

} // namespace
} // namespace shadowlab::scene
