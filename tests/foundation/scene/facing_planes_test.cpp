// Planes side by side give the signs that facing.h gives triangle by triangle, also where rounding decides.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/facing_planes.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

/// How often which sign was compared, and how often planes alone, without a second look at what is in doubt, say another.
struct Compared {
    std::array<std::size_t, 3> signs{};
    std::size_t naiveWrong = 0;
};

void compare(const scene::Object& object, const scene::Light& light, Compared& compared) {
    const std::vector<std::int8_t> expected = scene::facingSigns(object, light);
    const scene::FacingPlanes planes(object.mesh);
    const dvec4 lightMesh = scene::lightMesh(object, light);
    std::vector<std::int8_t> signs(planes.size(), std::int8_t{7});
    planes.findSigns(lightMesh, signs);
    ASSERT_EQ(signs, expected);
    for (std::size_t t = 0; t < signs.size(); ++t) {
        const dvec4 plane(planes.coordinates(0)[t], planes.coordinates(1)[t], planes.coordinates(2)[t],
                          planes.coordinates(3)[t]);
        const double side = glm::dot(plane, lightMesh);
        compared.naiveWrong += (side > 0) - (side < 0) != signs[t];
        ++compared.signs[static_cast<std::size_t>(signs[t] + 1)];
    }
}

TEST(FacingPlanes, GiveTheSameSignsInEveryHardScene) {
    Compared compared;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 50; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, i, directional);
                for (const scene::Object& object : scene.objects)
                    compare(object, scene.lights[0], compared);
            }
    EXPECT_GT(compared.signs[0], 5000u);
    EXPECT_GT(compared.signs[1], 20u);
    EXPECT_GT(compared.signs[2], 5000u);
}

// Lights in the plane of a triangle, and farther from it by powers of ten: all that can be rounded, is.
TEST(FacingPlanes, GiveTheSameSignsForLightsNearlyInThePlaneOfATriangle) {
    Compared compared;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(-2, 3);
    scene::Scene scene;
    const dmat4 turned = scene::worldFromObjectOf({1, 0.3, -2}, {20, 40, 60}, {1e5, -3, 7});
    for (const dmat4& worldFromObject : {dmat4(1.0), turned}) {
        testing::addObject(scene, scene::makeTorus(1, 0.4, {48, 24}), worldFromObject);
        testing::addObject(scene, scene::makeSphere(1e-4, 24), worldFromObject);
        testing::addObject(scene, scene::makeBox({1e3, 1e-3, 1}), worldFromObject);
    }
    for (const scene::Object& object : scene.objects)
        for (int i = 0; i < 300; ++i) {
            const scene::Mesh& mesh = *object.mesh;
            const uvec3 corner = mesh.triangles[random() % mesh.triangles.size()];
            const dvec3 a(mesh.positionsMesh[corner.x]), b(mesh.positionsMesh[corner.y]),
                c(mesh.positionsMesh[corner.z]);
            const dvec3 off = glm::cross(b - a, c - a) * std::pow(10.0, -4 - i % 16);
            const dvec3 pointMesh = a + share(random) * (b - a) + share(random) * (c - a) + (i % 3 - 1.0) * off;
            compare(object, testing::pointLight(transformPoint(scene::worldFromMesh(object), pointMesh)), compared);
            compare(object, testing::directionalLight(glm::normalize(b - a + share(random) * (c - a))), compared);
        }
    EXPECT_GT(compared.signs[0], 100000u);
    EXPECT_GT(compared.signs[1], 1000u);
    EXPECT_GT(compared.signs[2], 100000u);
    EXPECT_GT(compared.naiveWrong, 300u) << "the second look is needed";
}

TEST(FacingPlanes, TrianglesWithoutAreaHaveNoSide) {
    scene::Scene scene;
    const scene::Object& object = testing::addObject(
        scene,
        testing::triangleSoup(
            {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 3, 3}, {3, 3, 3}, {3, 3, 3}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}}));
    Compared compared;
    compare(object, testing::pointLight({0.3, 5, 0.2}), compared);
    EXPECT_EQ(compared.signs, (std::array<std::size_t, 3>{0, 2, 1}));
}

} // namespace
} // namespace shadowlab
