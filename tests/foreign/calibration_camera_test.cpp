// The calibration board of a camera elsewhere, of another camera, and cut off by the picture's edge: what is told is right.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "app/foreign/camera_code.h"
#include "tests/foreign/drawn_board.h"

namespace shadowlab::foreign {
namespace {

using CalibrationCameraTest = CalibrationTest;

/// From 1.3 on the large squares are cut one after the other, at 1.6 all of them; the small ones are whole up to twice the size.
TEST_F(CalibrationCameraTest, ACutBoardIsMeasuredByTheSquaresThatAreWhole) {
    int cases = 0, small = 0;
    for (const int samples : {1, 2})
        for (double scale = 1.1; scale < 1.95; scale += 0.0473) {
            const Calibration found = readOf({.samples = samples, .angleScale = 1 / scale});
            ASSERT_TRUE(found.shiftPx) << scale << "\n" << said(found);
            // What moves the corner by less than the third of a pixel that a fault is told from.
            EXPECT_NEAR(found.scale.x, scale, scale * kLeastCornerPx / 160) << scale;
            EXPECT_NEAR(found.scale.y, scale, scale * kLeastCornerPx / 90) << scale;
            expectOnly(found, CalibrationFault::view, "");
            small += found.wholeSquares < 8;
            ++cases;
        }
    EXPECT_EQ(cases, 36);
    EXPECT_GT(small, 15);
    expectOnly(readOf({.angleScale = 1 / 1.777}), CalibrationFault::view, "1.777");
}

/// Whatever is wrong, a number that is told is right: the pictures are too large, moved, or both, until nothing is left to be measured.
TEST_F(CalibrationCameraTest, OfACutBoardNoWrongNumberIsTold) {
    int measured = 0, cut = 0;
    for (const ivec2 size : {ivec2(256, 144), ivec2(64, 64)})
        for (const double scale : {1.0, 1.4, 1.9})
            for (const dvec2& shift : {dvec2(0), dvec2(0.1, 0.03), dvec2(-0.12, 0.14), dvec2(0.03, -0.21)}) { // of the picture
                const dvec2 shiftPx = shift * dvec2(size);
                const Calibration found = readCalibration(drawn(calibrationBoard(camera, size), size, {.centre = dvec2(0.5) - shiftPx, .angleScale = 1 / scale}), camera, size);
                if (found.shiftPx) {
                    EXPECT_LT(glm::length(*found.shiftPx - shiftPx), 0.3) << size.x << " " << scale << " " << shift.x << "\n" << said(found);
                    // A third of a pixel in the corner of the picture.
                    EXPECT_NEAR(found.scale.x, scale, scale * 2 * kLeastCornerPx / size.x) << size.x << " " << shift.x << " " << shift.y;
                    EXPECT_NEAR(found.scale.y, scale, scale * 2 * kLeastCornerPx / size.y) << size.x << " " << shift.x << " " << shift.y;
                    ++measured;
                } else if (!found.faults.empty() && found.faults[0].fault != CalibrationFault::notTheBoard) {
                    EXPECT_EQ(found.faults[0].fault, CalibrationFault::cut) << said(found);
                    ++cut;
                }
                EXPECT_EQ(found.isRight(), scale == 1 && shift == dvec2(0));
            }
    EXPECT_GT(measured, 8);
    EXPECT_GT(cut, 8);
}

TEST_F(CalibrationCameraTest, ACameraElsewhereIsToldWithItsPlaceWayAndAngle) {
    struct Wrong {
        dvec3 moved;
        double pan, tilt, angleScale;
    };
    const double distance = glm::length(camera.targetWorld - camera.positionWorld);
    int cases = 0;
    for (const Wrong& wrong : {Wrong{{0.4, 0, 0}, 0, 0, 1}, Wrong{{0, -0.3, 0}, 0, 0, 1}, Wrong{{0.4, 0.3, 0.7}, 0, 0, 1}, Wrong{{-0.5, -0.3, -0.8}, 0, 0, 1}, Wrong{{0, 0, 0}, 3, 0, 1},
                               Wrong{{0, 0, 0}, 0, -3, 1}, Wrong{{0.2, 0, 0.1}, 2, 1, 1}, Wrong{{0.5, 0.3, 0.8}, 0, 0, 0.88}, Wrong{{0.1, 0.1, 0}, -2, 2, 1.1}}) {
        const Calibration found = readOf({.samples = 2, .angleScale = wrong.angleScale, .panDegrees = wrong.pan, .tiltDegrees = wrong.tilt, .moved = wrong.moved});
        ASSERT_EQ(found.faults.size(), 1u) << said(found);
        EXPECT_EQ(found.faults[0].fault, CalibrationFault::camera) << cases << said(found);
        EXPECT_EQ(found.faults[0].what.find("stands") != std::string::npos, wrong.moved != dvec3(0)) << said(found);
        EXPECT_EQ(found.faults[0].what.find("looks") != std::string::npos, wrong.pan != 0 || wrong.tilt != 0) << said(found);
        EXPECT_EQ(found.faults[0].what.find("angle of view") != std::string::npos, wrong.angleScale != 1) << said(found);
        ASSERT_TRUE(found.camera);
        EXPECT_LT(glm::length(found.camera->movedWorld - wrong.moved), 0.004 * distance) << said(found);
        // A tilt after a pan is seen under a smaller angle by less than this.
        EXPECT_NEAR(found.camera->awayDegrees, std::hypot(wrong.pan, wrong.tilt), 0.1) << said(found);
        EXPECT_NEAR(found.camera->fovYDegrees, 2 * glm::degrees(std::atan(std::tan(glm::radians(22.5)) * wrong.angleScale)), 0.2) << said(found);
        ++cases;
    }
    EXPECT_EQ(cases, 9);
    expectOnly(readOf({.samples = 2, .barrel = 0.05}), CalibrationFault::camera, "pinhole");
}

/// The same picture to a pixel for a board whose squares stand at one distance: a camera twice as far away with half of the angle.
TEST_F(CalibrationCameraTest, ACameraThatIsFartherAwayWithASmallerAngleIsSeen) {
    const dvec3 back = 0.25 * (camera.positionWorld - camera.targetWorld);
    const Calibration found = readOf({.samples = 2, .angleScale = 0.8, .moved = back});
    expectOnly(found, CalibrationFault::camera, "stands");
    ASSERT_TRUE(found.camera);
    EXPECT_LT(glm::length(found.camera->movedWorld - back), 0.01 * glm::length(back)) << said(found);
}

/// The board moves with its camera, so all else in the picture is the same.
TEST_F(CalibrationCameraTest, ABoardOfAnotherCameraIsSaid) {
    int cases = 0;
    scene::Camera moved = camera, turned = camera, rolled = camera, angle = camera;
    moved.positionWorld.x += 0.01, moved.targetWorld.x += 0.01;
    turned.targetWorld.y += 0.01;
    rolled.upWorld = {0.01, 1, 0};
    angle.fovYDegrees = 45.1;
    for (const scene::Camera& other : {moved, turned, rolled, angle})
        for (const Renderer& renderer : {Renderer{}, Renderer{.samples = 3}, Renderer{.curve = ToneCurve::srgb, .background = dvec3(0.05)}}) {
            const Calibration found = read(drawn(calibrationBoard(other, kSize), kSize, renderer));
            expectOnly(found, CalibrationFault::otherBoard, "another camera");
            EXPECT_EQ(found.code, cameraCode(other, kSize));
            ++cases;
        }
    EXPECT_EQ(cases, 12);
    // Neither the size nor the target's distance is seen by a camera.
    scene::Camera nearer = camera;
    nearer.targetWorld = camera.positionWorld + 0.9 * (camera.targetWorld - camera.positionWorld);
    EXPECT_EQ(cameraCode(nearer, kSize), cameraCode(camera, kSize));
    EXPECT_EQ(cameraCode(camera, {640, 360}), cameraCode(camera, kSize));
    EXPECT_NE(cameraCode(camera, {640, 480}), cameraCode(camera, kSize));
    EXPECT_TRUE(read(drawn(calibrationBoard(camera, {640, 360}), kSize)).isRight());
}

TEST_F(CalibrationCameraTest, ACameraOfSinglePrecisionKeepsItsCode) {
    int cases = 0;
    for (double x = -2; x < 2; x += 0.173) {
        scene::Camera own = camera, single = camera;
        own.positionWorld = {x, 2.3, 4.7}, single.positionWorld = dvec3(vec3(own.positionWorld));
        own.targetWorld = {0.1, 0.6, x}, single.targetWorld = dvec3(vec3(own.targetWorld));
        EXPECT_EQ(cameraCode(own, kSize), cameraCode(single, kSize)) << x;
        ++cases;
    }
    EXPECT_EQ(cases, 24);
}

TEST_F(CalibrationCameraTest, ABoardWithoutCellsIsSaid) {
    scene::Scene bare = board;
    bare.objects.resize(boardLayout(kSize).all().size()); // the cells come last
    expectOnly(read(drawn(bare, kSize)), CalibrationFault::otherBoard, "no code");
}

} // namespace
} // namespace shadowlab::foreign
