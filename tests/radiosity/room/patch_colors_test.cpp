// The mean reflectance of patches on a surface with an image: half of it red, half green.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/patch_colors.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/radiosity/room/room.h"
#include "tests/support/colored.h"
#include "tests/support/scenes.h"

namespace shadowlab::radiosity {
namespace {

const vec3 kRed(1, 0, 0), kGreen(0, 1, 0);

/// A floor of 2 x 2 m about (5, 0, 0), red to the left of its middle and green to the right, and a grey box on its red half.
scene::Scene twoColors() {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    scene::Material& floor = scene.materials.emplace_back();
    floor.name = "two colours";
    floor.diffuse = vec3(0.5f);
    floor.diffuseMap = "in memory";
    floor.colorImage = testing::imageOf({kRed, kGreen});
    floor.colorPlacement.clamped = true;
    testing::addObject(scene, scene::makeQuad({2, 2}), testing::translation({5, 0, 0})).partMaterials = {1};
    testing::addObject(scene, scene::makeBox({0.2, 0.2, 0.2}), testing::translation({4.5, 0.1, 0}));
    return scene;
}

/// From x = left to x = right, in the floor's plane.
Patch strip(double left, double right) {
    Patch patch;
    patch.polygon = {{left, 0, 0.5}, {right, 0, 0.5}, {right, 0, -0.5}, {left, 0, -0.5}};
    patch.normal = {0, 1, 0};
    return patch;
}

// Texels meet at x = 5, and their light is interpolated between their centres, 0.5 m to either side: at x = 5 + d the share of green is
// 0.5 + d.
TEST(PatchColors, AreTheMeanOfTheImageThatIsThere) {
    const PatchColors colors(twoColors());
    EXPECT_TRUE(colors.has(0));
    EXPECT_FALSE(colors.has(1));
    const auto mean = [&](double left, double right) { return colors.mean(strip(left, right), dvec3(0), 0, 1e-3, dvec3(-1)); };
    // Of the material's 0.5. The places on a patch lie evenly, so the mean of what varies evenly is exact, but for floats.
    constexpr double kFloats = 1e-6;
    const auto expectNear = [&](const dvec3& found, const dvec3& expected, const char* where) {
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c], expected[c], kFloats) << where;
    };
    expectNear(mean(4.0, 4.4), {0.5, 0, 0}, "left of the first centre");
    expectNear(mean(5.6, 6.0), {0, 0.5, 0}, "right of the last centre");
    expectNear(mean(4.8, 5.2), {0.25, 0.25, 0}, "about the middle");
    expectNear(mean(5.0, 5.5), {0.5 * 0.25, 0.5 * 0.75, 0}, "between the centres");
    expectNear(mean(4.3, 4.5), {0.5, 0, 0}, "half under the box, which stands on it");
    expectNear(mean(8.0, 8.4), {-1, -1, -1}, "beside the floor");
}

TEST(PatchColors, ReachTheRoomsPatches) {
    const scene::Scene scene = twoColors();
    Room room(scene, {.patches = 200, .lightWithin = std::vector<bool>(scene.objects.size())});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    ASSERT_EQ(room.reflectances().size(), room.allPatches().size());
    int red = 0, green = 0, grey = 0;
    for (std::size_t i = 0; i < room.allPatches().size(); ++i) {
        const Patch& patch = room.allPatches()[i];
        const dvec3& rho = room.reflectances()[i];
        if (room.faceOf(patch).object == 1) {
            EXPECT_EQ(rho, dvec3(vec3(0.8f)));
            ++grey;
        } else {
            EXPECT_NEAR(rho.r + rho.g, 0.5, 1e-6) << "red and green share what the material reflects";
            red += rho.r > 0.4;
            green += rho.g > 0.4;
        }
    }
    EXPECT_GT(red, 5);
    EXPECT_GT(green, 5);
    EXPECT_GT(grey, 3);
}

} // namespace
} // namespace shadowlab::radiosity
