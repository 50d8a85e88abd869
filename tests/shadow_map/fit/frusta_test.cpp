// The frusta that are shown are those of the maps: closed forms, and every caster inside.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/frusta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/look.h"
#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

constexpr int kResolution = 512;

/// Is the point on the inner side of all six faces? The middle of the corners says which side that is.
bool isInside(const std::array<dvec3, 8>& c, const dvec3& p) {
    static constexpr int faces[6][3] = {{0, 1, 2}, {4, 5, 6}, {0, 1, 5}, {1, 2, 6}, {2, 3, 7}, {3, 0, 4}};
    dvec3 middle(0.0);
    for (const dvec3& corner : c)
        middle += corner / 8.0;
    for (const auto& f : faces) {
        const dvec3 &a = c[static_cast<std::size_t>(f[0])], &b = c[static_cast<std::size_t>(f[1])],
                    &d = c[static_cast<std::size_t>(f[2])];
        const dvec3 normal = glm::normalize(glm::cross(b - a, d - a));
        if (glm::dot(normal, middle - a) * glm::dot(normal, p - a) < 0) return false;
    }
    return true;
}

/// Vertices of the useful casters within some layer's frustum, and their number.
std::pair<int, int> castersInside(const scene::Scene& scene, const scene::Light& light, int expectedLayers) {
    const std::vector<std::size_t> casters = scene::usefulCasters(scene, light);
    const LightMaps maps = testing::sceneMaps(scene, light, kResolution, 1);
    EXPECT_EQ(maps.layers(), expectedLayers);
    int inside = 0, all = 0;
    for (const std::size_t caster : casters) {
        const dmat4 worldFromMesh = scene::worldFromMesh(scene.objects[caster]);
        for (const vec3& positionMesh : scene.objects[caster].mesh->positionsMesh) {
            const dvec3 world = transformPoint(worldFromMesh, dvec3(positionMesh));
            bool found = false;
            for (int layer = 0; layer < maps.layers(); ++layer)
                found = found || isInside(frustumCornersWorld(maps, layer), world);
            inside += found;
            ++all;
        }
    }
    return {inside, all};
}

TEST(Frusta, HoldEveryCaster) {
    scene::Light light = testing::pointLight({2, 5, 3});
    light.directionWorld = glm::normalize(dvec3(-2, -4.5, -3));
    light.edgeUWorld = {0.5, 0, 0};
    light.edgeVWorld = {0, 0, 0.5};
    using enum scene::LightType;
    for (const dvec3 offset : {dvec3(0), dvec3(1e6, 0, -1e6)})
        for (const scene::LightType type : {point, directional, spot, rect, sphere}) {
            light.type = type;
            light.coneDegrees = 80;
            scene::Scene scene = testing::simpleScene();
            scene.lights = {light};
            scene = testing::moved(scene, offset);
            const auto [inside, all] = castersInside(scene, scene.lights[0], 1);
            EXPECT_GE(all, 900);
            EXPECT_EQ(inside, all) << scene::toText(type) << " at " << offset.x;
        }
    scene::Scene around = testing::simpleScene(); // the light stands among the casters: six maps
    around.lights = {testing::pointLight({0, 1.2, 0.1})};
    const auto [inside, all] = castersInside(around, around.lights[0], 6);
    EXPECT_GE(all, 900);
    EXPECT_EQ(inside, all);
}

TEST(Frusta, AConeIsAsWideAsItsAngle) {
    scene::Scene scene = testing::simpleScene();
    scene::Light light = testing::pointLight({0, 4, 0});
    light.type = scene::LightType::spot;
    light.directionWorld = {0, -1, 0};
    light.coneDegrees = 20; // all casters reach beyond it
    const LightMaps maps = testing::sceneMaps(scene, light, kResolution, 0);
    const auto corners = frustumCornersWorld(maps, 0);
    const double wide = std::tan(glm::radians(10.0)) * (1 + 1.0 / (kResolution - 1)); // half a texel on each side
    for (std::size_t i = 0; i < 8; ++i) {
        const double depth = i < 4 ? maps.nearest : maps.farthest;
        EXPECT_NEAR(corners[i].y, 4 - depth, 1e-9);
        EXPECT_NEAR(std::abs(corners[i].x), wide * depth, 1e-9);
        EXPECT_NEAR(std::abs(corners[i].z), wide * depth, 1e-9);
    }
}

TEST(Frusta, AreDrawnFromTheLight) {
    scene::Scene scene = testing::simpleScene();
    for (const bool among : {false, true}) {
        const scene::Light light = testing::pointLight(among ? dvec3(0, 1.2, 0.1) : dvec3(2, 5, 3));
        const LightMaps maps = testing::sceneMaps(scene, light, kResolution, 0);
        const std::vector<SceneShape> shapes = frustumShapes(maps);
        ASSERT_EQ(shapes.size(), 2u);
        const auto layers = static_cast<std::size_t>(maps.layers());
        EXPECT_EQ(layers, among ? 6u : 1u);
        for (const SceneShape& shape : shapes) {
            EXPECT_EQ(shape.colorLinear, look::kLightFrustum);
            const bool lines = shape.kind == SceneShape::Kind::lines;
            EXPECT_EQ(shape.label.starts_with("near plane"), !lines) << shape.label;
            EXPECT_EQ(shape.pointsWorld.size(), layers * (lines ? 12 * 2 : 2 * 3));
            const auto fromLight = std::ranges::count(shape.pointsWorld, light.positionWorld);
            EXPECT_EQ(static_cast<std::size_t>(fromLight), lines ? 4 * layers : 0);
        }
    }
}

} // namespace
} // namespace shadowlab::shadow_map
