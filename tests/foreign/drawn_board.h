// The calibration board as another renderer draws it, with the mistakes that it is made for.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/foreign/calibration_reading.h"
#include "tests/support/brute_force.h"

namespace shadowlab::foreign {

/// Another renderer, by its mistakes. Plain loops over triangles, none of the program's rays.
struct Renderer {
    int samples = 1;               ///< N x N a pixel, in its box
    dvec2 centre{0.5, 0.5};        ///< of a pixel, from its upper left corner
    double angleScale = 1;         ///< of the tangent of half the vertical angle of view
    double aspectScale = 1;        ///< of the aspect
    double rollDegrees = 0;        ///< of the camera
    double panDegrees = 0, tiltDegrees = 0; ///< to the right, up
    dvec3 moved{0.0};              ///< metres in the world
    double barrel = 0;             ///< of a lens: shares of the picture, seen from its middle, times 1 + barrel r^2
    bool stepsOneLess = false;     ///< x / (width - 1)
    ToneCurve curve = ToneCurve::srgb;
    double exposure = 1;
    dvec3 background{0.0};
};

inline image::Image drawn(const scene::Scene& board, ivec2 size, const Renderer& renderer = {}) {
    const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(board);
    image::Image picture(size.x, size.y);
    const scene::Camera& camera = board.camera;
    const dvec3 straight = glm::normalize(camera.targetWorld - camera.positionWorld);
    const dvec3 across = glm::normalize(glm::cross(straight, camera.upWorld)), upright = glm::cross(across, straight);
    const double pan = glm::radians(renderer.panDegrees), tilt = glm::radians(renderer.tiltDegrees);
    const dvec3 forward = std::cos(tilt) * (std::cos(pan) * straight + std::sin(pan) * across) + std::sin(tilt) * upright;
    const dvec3 level = std::cos(pan) * across - std::sin(pan) * straight, eye = camera.positionWorld + renderer.moved;
    const double roll = glm::radians(renderer.rollDegrees);
    const dvec3 right = std::cos(roll) * level + std::sin(roll) * glm::cross(level, forward), up = glm::cross(right, forward);
    const double halfHeight = std::tan(glm::radians(camera.fovYDegrees) / 2) * renderer.angleScale;
    const double halfWidth = halfHeight * size.x / size.y * renderer.aspectScale;
    const auto radianceAt = [&](dvec2 pixel) {
        const dvec2 share = renderer.stepsOneLess ? (pixel - 0.5) / dvec2(size - 1) : pixel / dvec2(size);
        const dvec2 around = (2.0 * share - 1.0) * (1 + renderer.barrel * glm::dot(2.0 * share - 1.0, 2.0 * share - 1.0));
        const dvec3 way = forward + around.x * halfWidth * right - around.y * halfHeight * up;
        for (const testing::WorldTriangle& triangle : triangles) {
            const auto hit = testing::meets(triangle, eye, way);
            if (hit && hit->along > 0 && hit->inside >= 0) return dvec3(board.materials[board.objects[triangle.object].partMaterials[0]].emission);
        }
        return renderer.background;
    };
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            dvec3 sum(0.0);
            for (int i = 0; i < renderer.samples * renderer.samples; ++i) {
                const dvec2 within = (dvec2(i % renderer.samples, i / renderer.samples) + 0.5) / static_cast<double>(renderer.samples) - 0.5;
                sum += radianceAt(dvec2(x, y) + renderer.centre + within);
            }
            const auto byte = [&](double light) {
                return static_cast<std::uint8_t>(std::lround(255 * encodedWith(renderer.curve, renderer.exposure * light)));
            };
            sum /= renderer.samples * renderer.samples;
            picture.set(x, y, {byte(sum.r), byte(sum.g), byte(sum.b), 255});
        }
    return picture;
}

inline scene::Camera tiltedCamera() {
    scene::Camera camera;
    camera.positionWorld = {3, 2.5, 5};
    camera.targetWorld = {0, 0.6, 0};
    camera.fovYDegrees = 45;
    return camera;
}

inline constexpr ivec2 kSize{320, 180};

inline std::string said(const Calibration& found) {
    std::string text;
    for (const FoundFault& fault : found.faults)
        text += std::string(toText(fault.fault)) + ": " + fault.what + "; " + fault.remedy + "\n";
    return text;
}

/// Exactly that fault, and nothing else.
inline void expectOnly(const Calibration& found, CalibrationFault fault, const std::string& words) {
    ASSERT_EQ(found.faults.size(), 1u) << said(found);
    EXPECT_EQ(found.faults[0].fault, fault) << said(found);
    EXPECT_NE(found.faults[0].what.find(words), std::string::npos) << said(found);
    EXPECT_FALSE(found.faults[0].remedy.empty());
}

class CalibrationTest : public ::testing::Test {
protected:
    scene::Camera camera = tiltedCamera();
    scene::Scene board = calibrationBoard(camera, kSize);
    Calibration read(const image::Image& picture) const { return readCalibration(picture, camera, kSize); }
    Calibration readOf(const Renderer& renderer) const { return read(drawn(board, kSize, renderer)); }
};

} // namespace shadowlab::foreign
