// The calibration board as other renderers draw it, with every mistake that it is made for.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "tests/cli/command_fixture.h"
#include "tests/foreign/drawn_board.h"

namespace shadowlab::foreign {
namespace {

TEST_F(CalibrationTest, ARightPictureIsRightWithOneSampleAndWithMany) {
    for (const int samples : {1, 2, 4}) {
        const Calibration found = readOf({.samples = samples});
        EXPECT_TRUE(found.isRight()) << samples << "\n" << said(found);
        ASSERT_TRUE(found.shiftPx);
        // With one sample, a square's edge of 20 to 40 rows is known to a few hundredths.
        EXPECT_LT(glm::length(*found.shiftPx), 0.05) << samples;
        EXPECT_EQ(found.curve, ToneCurve::srgb);
        EXPECT_NEAR(found.exposure, 1, 0.02);
    }
}

TEST_F(CalibrationTest, IsRightFromEveryCameraAndInEverySize) {
    int cases = 0;
    for (const ivec2 size : {ivec2(64, 64), ivec2(120, 200), ivec2(256, 144), ivec2(300, 100)})
        for (const double fov : {20.0, 45.0, 100.0})
            for (const dvec3& target : {dvec3(0, 0.6, 0), dvec3(3, 9, 5.2), dvec3(3, 2.5, -60)}) {
                scene::Camera from = camera;
                from.fovYDegrees = fov;
                from.targetWorld = target;
                from.upWorld = {0.2, 1, 0.1};
                const Calibration found = readCalibration(drawn(calibrationBoard(from, size), size), from, size);
                EXPECT_TRUE(found.isRight()) << size.x << "x" << size.y << " " << fov << "\n" << said(found);
                ++cases;
            }
    EXPECT_EQ(cases, 36);
}

TEST_F(CalibrationTest, ShiftsAreMeasuredToATenthOfAPixel) {
    int cases = 0;
    for (const int samples : {1, 3})
        for (const dvec2& shift : {dvec2(0.5, 0.5), dvec2(-0.5, 0.5), dvec2(0.5, 0), dvec2(0, -0.5), dvec2(0.25, -0.3), dvec2(3, -2)}) {
            const Calibration found = readOf({.samples = samples, .centre = dvec2(0.5) - shift});
            ASSERT_TRUE(found.shiftPx);
            EXPECT_LT(glm::length(*found.shiftPx - shift), 0.1) << shift.x << " " << shift.y;
            expectOnly(found, CalibrationFault::shift, "shifted");
            ++cases;
        }
    EXPECT_EQ(cases, 12);
    expectOnly(readOf({.centre = {0, 0}}), CalibrationFault::shift, "0.5");
}

TEST_F(CalibrationTest, FlipsAndTurnsAreToldApart) {
    const image::Image right = drawn(board, kSize);
    const auto flipped = [&](bool x, bool y) { return putUpright(right, {.swapsAxes = false, .mirrorsX = x, .mirrorsY = y}); };
    expectOnly(read(flipped(true, false)), CalibrationFault::orientation, "mirrored left to right");
    expectOnly(read(flipped(false, true)), CalibrationFault::orientation, "upside down");
    expectOnly(read(flipped(true, true)), CalibrationFault::orientation, "turned by 180 degrees");
    const ivec2 square(128, 128);
    const image::Image squarePicture = drawn(calibrationBoard(camera, square), square);
    // Clockwise: what was at the left of the lower row is at the left of the upper one.
    image::Image turned(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            turned.set(127 - y, x, squarePicture.at(x, y));
    expectOnly(readCalibration(turned, camera, square), CalibrationFault::orientation, "turned by 90 degrees clockwise");
}

TEST_F(CalibrationTest, AnotherSizeIsSaid) {
    const Calibration found = read(drawn(calibrationBoard(camera, {180, 320}), {180, 320}));
    expectOnly(found, CalibrationFault::size, "180 x 320");
    expectOnly(read(image::Image(320, 179)), CalibrationFault::size, "320 x 179 pixels, not 320 x 180");
}

TEST_F(CalibrationTest, AnotherAngleOfViewOrAspectIsSaid) {
    const double aspect = 320.0 / 180;
    expectOnly(readOf({.angleScale = 1 / aspect}), CalibrationFault::view, "taken for the horizontal angle");
    const Calibration wide = readOf({.angleScale = std::tan(glm::radians(25.0)) / std::tan(glm::radians(22.5))});
    expectOnly(wide, CalibrationFault::view, "about 50.0");
    expectOnly(readOf({.aspectScale = 1 / aspect}), CalibrationFault::view, "stretched");
    expectOnly(readOf({.angleScale = 1.01}), CalibrationFault::view, "0.99");
    expectOnly(readOf({.stepsOneLess = true}), CalibrationFault::view, "one pixel");
    expectOnly(readOf({.rollDegrees = 1}), CalibrationFault::turn, "1.0");
}

TEST_F(CalibrationTest, EncodingsAreToldApartAtAnyExposure) {
    int cases = 0;
    for (const ToneCurve curve : kToneCurves)
        for (const double exposure : {1.0, 0.6}) {
            const Calibration found = readOf({.samples = 2, .curve = curve, .exposure = exposure});
            EXPECT_EQ(found.curve, curve) << toText(curve) << " " << exposure << "\n" << said(found);
            EXPECT_NEAR(found.exposure, exposure, 0.03);
            if (curve == ToneCurve::srgb)
                EXPECT_TRUE(found.isRight()) << said(found);
            else
                expectOnly(found, CalibrationFault::encoding, std::string(toText(curve)));
            ++cases;
        }
    EXPECT_EQ(cases, 10);
    // Reinhard's operator, as an example of a tone mapping.
    image::Image mapped = drawn(board, kSize);
    for (std::uint8_t& byte : mapped.rgba) {
        const double light = image::linearFromEncoded(byte / 255.0) * 2;
        byte = static_cast<std::uint8_t>(std::lround(255 * encodedWith(ToneCurve::srgb, light / (1 + light))));
    }
    expectOnly(read(mapped), CalibrationFault::encoding, "no curve");
}

/// The pictures of these tests are drawn with encodedWith(): here are numbers that it must give, computed by hand. sRGB is IEC 61966-2-1.
TEST(ToneCurveTest, EncodesAsItsFormulasSay) {
    struct Pair {
        ToneCurve curve;
        double linear, encoded;
    };
    int cases = 0;
    for (const Pair& pair : {Pair{ToneCurve::srgb, 0.5, 0.73536}, Pair{ToneCurve::srgb, 0.18, 0.46136}, Pair{ToneCurve::srgb, 0.002, 0.02584}, Pair{ToneCurve::linear, 0.3, 0.3},
                             Pair{ToneCurve::power22, 0.5, 0.72974}, Pair{ToneCurve::doubleSrgb, 0.5, 0.87317}, Pair{ToneCurve::decoded, 0.5, 0.21404}}) {
        // Five digits are given.
        EXPECT_NEAR(encodedWith(pair.curve, pair.linear), pair.encoded, 1e-5) << toText(pair.curve);
        EXPECT_NEAR(linearFrom(pair.curve, pair.encoded), pair.linear, 2e-5) << toText(pair.curve);
        ++cases;
    }
    EXPECT_EQ(cases, 7);
}

TEST_F(CalibrationTest, ExchangedChannelsAreSaid) {
    image::Image picture = drawn(board, kSize);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) std::swap(picture.rgba[i], picture.rgba[i + 2]);
    expectOnly(read(picture), CalibrationFault::channels, "red and blue exchanged");
}

TEST_F(CalibrationTest, FaultsThatComeTogetherAreAllSaid) {
    const image::Image picture = putUpright(drawn(board, kSize, {.centre = {0, 0}, .curve = ToneCurve::linear}),
                                            {.swapsAxes = false, .mirrorsX = false, .mirrorsY = true});
    const Calibration found = read(picture);
    ASSERT_EQ(found.faults.size(), 3u) << said(found);
    EXPECT_EQ(found.faults[0].fault, CalibrationFault::orientation);
    EXPECT_EQ(found.faults[1].fault, CalibrationFault::shift);
    EXPECT_EQ(found.faults[2].fault, CalibrationFault::encoding);
}

TEST_F(CalibrationTest, WhatIsNoBoardIsSaid) {
    expectOnly(read(image::Image(320, 180, {128, 128, 128, 255})), CalibrationFault::notTheBoard, "does not look like");
    image::Image ramp(320, 180);
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) {
            const auto grey = static_cast<std::uint8_t>((x * 7 + y * 13 + (x * y) % 31 * 8) % 256);
            ramp.set(x, y, {grey, grey, grey, 255});
        }
    expectOnly(read(ramp), CalibrationFault::notTheBoard, "does not look like");
}

TEST_F(CalibrationTest, AGreyBackgroundChangesNothing) {
    const Calibration found = readOf({.background = dvec3(0.05)});
    EXPECT_TRUE(found.isRight()) << said(found);
}

TEST_F(CalibrationTest, TooSmallAPictureIsRefused) {
    EXPECT_THROW(calibrationBoard(camera, {63, 200}), Error);
    EXPECT_NO_THROW(calibrationBoard(camera, {64, 64}));
}

class CapturedBoardTest : public testing::CommandTest {};

TEST_F(CapturedBoardTest, TheProgramsOwnCaptureIsRight) {
    const scene::Camera camera = tiltedCamera();
    const scene::Scene board = calibrationBoard(camera, kSize);
    folder.write("calibration.json", scene::sceneText(board, board.camera, folder.path()));
    for (const std::string samples : {"1", "4"}) {
        succeed({"capture", "calibration.json", "-o", "board.png", "--size", "320x180", "--labels", "false", "-t", "unshadowed",
                 "--supersample", samples});
        const Calibration found = readCalibration(testing::decoded(testing::fileContent(folder.path() / "board.png")).image, camera, kSize);
        EXPECT_TRUE(found.isRight()) << said(found);
        ASSERT_TRUE(found.shiftPx);
        EXPECT_LT(glm::length(*found.shiftPx), 0.05);
    }
}

} // namespace
} // namespace shadowlab::foreign
