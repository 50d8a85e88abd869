// What is left out of a picture lies outside it, and what may touch it is never left out.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/picture_part.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

namespace shadowlab {
namespace {

constexpr ivec2 kSize{64, 48};

struct Looking {
    scene::Camera camera;
    dmat4 clipFromWorld = scene::clipFromView(camera, 64.0 / 48.0) * scene::viewFromWorld(camera); // from (0, 1, 5)
    /// Pixel, counted from the upper left; nothing for what lies before the near plane.
    [[nodiscard]] std::optional<dvec2> pixelOf(const dvec3& positionWorld) const {
        const dvec4 clip = clipFromWorld * dvec4(positionWorld, 1.0);
        if (clip.z < -clip.w) return std::nullopt;
        return (dvec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5) * dvec2(kSize);
    }
};

TEST(PicturePart, BoxesThatAreLeftOutHoldNoPointOfThePart) {
    const Looking looking;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-8, 8), edge(0.1, 2), within(0, 1);
    const ivec2 corner(20, 8), size(24, 16);
    const scene::PicturePart whole = scene::picturePart({}, {}, kSize), part = scene::picturePart(corner, size, kSize);
    int seenInPart = 0, leftOut = 0;
    for (int i = 0; i < 2000; ++i) {
        scene::Bounds box;
        box.lowerWorld = {place(random), place(random), place(random)};
        box.upperWorld = box.lowerWorld + dvec3(edge(random), edge(random), edge(random));
        const bool kept = scene::mayTouch(box, looking.clipFromWorld, part);
        leftOut += !kept;
        EXPECT_TRUE(!kept || scene::mayTouch(box, looking.clipFromWorld, whole)) << "a part is part of the whole";
        for (int p = 0; p < 30; ++p) {
            const dvec3 share(within(random), within(random), within(random));
            const auto pixel = looking.pixelOf(glm::mix(box.lowerWorld, box.upperWorld, share));
            if (!pixel || glm::any(glm::lessThan(*pixel, dvec2(corner))) ||
                glm::any(glm::greaterThan(*pixel, dvec2(corner + size))))
                continue;
            ++seenInPart;
            ASSERT_TRUE(kept);
        }
    }
    EXPECT_GT(seenInPart, 500);
    EXPECT_GT(leftOut, 500) << "what is never left out saves nothing";
}

TEST(PicturePart, WhatIsBeyondTheNearPlaneIsNeitherCutByItNorAroundTheEye) {
    scene::Camera camera;
    camera.positionWorld = {0, 1, 5};
    camera.targetWorld = {0, 1, 0}; // along -z
    const double nearPlane = 5 - camera.near;
    const dmat4 clipFromWorld = scene::clipFromView(camera, 1.0) * scene::viewFromWorld(camera);
    const auto beyond = [&](double lower, double upper) {
        return scene::isBeyondNearPlane({dvec3(-1, 0, lower), dvec3(1, 2, upper)}, clipFromWorld);
    };
    EXPECT_TRUE(beyond(-3, nearPlane - 0.01));
    EXPECT_FALSE(beyond(-3, nearPlane + 0.01)) << "cut by the plane";
    EXPECT_FALSE(beyond(nearPlane + 0.01, 4.99)) << "before it";
    EXPECT_FALSE(beyond(3, 7)) << "around the eye";
    EXPECT_FALSE(beyond(6, 7)) << "behind the eye";
}

} // namespace
} // namespace shadowlab
