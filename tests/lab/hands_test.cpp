// What hands do to camera, lights and objects: closed forms, and what must stay as it was.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/lab/camera_control.h"
#include "app/lab/handles.h"

namespace shadowlab::lab {
namespace {

constexpr double kStepDegrees = 3;

scene::Camera someCamera() {
    scene::Camera camera;
    camera.positionWorld = {3, 2.5, 5};
    camera.targetWorld = {0.2, 0.6, -0.3};
    return camera;
}

TEST(CameraControl, OrbitingKeepsTargetAndDistanceAndComesBack) {
    const scene::Camera start = someCamera();
    scene::Camera camera = start;
    for (int i = 0; i < 36; ++i) {
        camera = orbited(camera, 10, 0);
        EXPECT_NEAR(targetDistance(camera), targetDistance(start), 1e-12);
        EXPECT_EQ(camera.targetWorld, start.targetWorld);
        EXPECT_NEAR(camera.positionWorld.y, start.positionWorld.y, 1e-12);
    }
    EXPECT_LT(glm::length(camera.positionWorld - start.positionWorld), 1e-12) << "a full turn";
    const scene::Camera quarter = orbited(start, 90, 0);
    const dvec3 before = start.positionWorld - start.targetWorld, after = quarter.positionWorld - quarter.targetWorld;
    EXPECT_NEAR(glm::dot(dvec3(before.x, 0, before.z), dvec3(after.x, 0, after.z)), 0, 1e-12);
}

TEST(CameraControl, NothingTurnsThePictureOver) {
    scene::Camera over = someCamera(), head = someCamera();
    for (int i = 0; i < 100; ++i) {
        over = orbited(over, 0, 7);
        head = turnedHead(head, 0, -7);
    }
    EXPECT_TRUE(scene::hasView(over));
    EXPECT_TRUE(scene::hasView(head));
    const dvec3 up = glm::normalize(over.positionWorld - over.targetWorld);
    EXPECT_NEAR(glm::degrees(std::asin(up.y)), 89, 1e-6);
}

TEST(CameraControl, PanningMovesWhatIsSeenByThatShareOfThePicture) {
    const ivec2 size(1280, 720);
    const scene::Camera start = someCamera(), moved = panned(start, 0.25, -0.1);
    const auto before = pixelOf(start, size, start.targetWorld), after = pixelOf(moved, size, start.targetWorld);
    ASSERT_TRUE(before && after);
    EXPECT_NEAR(after->x - before->x, 0.25 * 720, 1e-9);
    EXPECT_NEAR(after->y - before->y, 0.1 * 720, 1e-9) << "up is up: the picture counts down";
}

TEST(Handles, AMarkAtTheEdgeShowsWhichWayToTurn) {
    const ivec2 size(1280, 720);
    const double margin = 20;
    const scene::Camera start = someCamera();
    EXPECT_FALSE(edgeMarkOf(start, size, margin, start.targetWorld)) << "what is in view needs none";
    int marked = 0, behind = 0;
    for (int i = 0; i < 200; ++i) { // all around, no direction twice
        const double turn = 2.399963 * i, height = -0.7 + 1.4 * i / 199;
        const dvec3 place = start.positionWorld + 4.0 * dvec3(std::cos(turn), height, std::sin(turn));
        const auto mark = edgeMarkOf(start, size, margin, place);
        EXPECT_EQ(!mark, [&] {
            const auto pixel = pixelOf(start, size, place);
            return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= size.x && pixel->y <= size.y;
        }());
        if (!mark) continue;
        ++marked;
        behind += !pixelOf(start, size, place);
        EXPECT_NEAR(glm::length(mark->outward), 1, 1e-12);
        const dvec2 fromEdge = glm::min(mark->pixel, dvec2(size) - mark->pixel);
        EXPECT_NEAR(std::min(fromEdge.x, fromEdge.y), margin, 1e-9);
        scene::Camera camera = start;
        for (int steps = 0; steps < 1000; ++steps) {
            const auto now = edgeMarkOf(camera, size, margin, place);
            if (!now) break;
            camera = turnedHead(camera, kStepDegrees * now->outward.x, -kStepDegrees * now->outward.y);
        }
        EXPECT_FALSE(edgeMarkOf(camera, size, margin, place)) << "turned that way, and still not in view: " << i;
    }
    EXPECT_GT(marked, 100);
    EXPECT_GT(behind, 30);
}

TEST(CameraControl, ZoomingNeverReachesTheTarget) {
    scene::Camera camera = someCamera();
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 0.5);
    EXPECT_TRUE(scene::hasView(camera));
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 2);
    EXPECT_TRUE(scene::hasView(camera));
    EXPECT_TRUE(std::isfinite(targetDistance(camera)));
}

TEST(Handles, LightsAndObjectsGoWhereTheyArePulled) {
    auto scene = std::make_shared<scene::Scene>();
    scene::Light point, sun;
    point.name = "point";
    sun.name = "sun";
    sun.type = scene::LightType::directional;
    sun.directionWorld = glm::normalize(dvec3(0.3, -1, 0.2));
    scene->lights = {point, sun};
    const scene::Camera camera = someCamera();
    const scene::Snapshot start = scene;
    const std::vector<Handle> before = handles(*start, {}, camera);
    ASSERT_EQ(before.size(), 2u);
    const dvec3 by(0.4, 0.1, -0.3);
    const scene::Snapshot moved = withMoved(start, before[0].what, by, camera);
    EXPECT_LT(glm::length(moved->lights[0].positionWorld - by), 1e-15);
    EXPECT_EQ(moved->lights[1], start->lights[1]);
    EXPECT_NE(moved->revisions.lights, start->revisions.lights);
    EXPECT_EQ(moved->revisions.transforms, start->revisions.transforms);

    const scene::Snapshot turned = withMoved(start, before[1].what, by, camera);
    EXPECT_NEAR(glm::length(turned->lights[1].directionWorld), 1, 1e-15);
    const dvec3 wanted = glm::normalize(before[1].positionWorld + by - camera.targetWorld);
    EXPECT_LT(glm::length(turned->lights[1].directionWorld + wanted), 1e-12) << "it shines from where its handle is";
}

} // namespace
} // namespace shadowlab::lab
