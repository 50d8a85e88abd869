// The shading in GLSL equals its C++ twin, for every light type, on diffuse and glossy surfaces.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/shading.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

class ShadingTest : public testing::GlTest, public ::testing::WithParamInterface<scene::LightType> {};

TEST_P(ShadingTest, EqualsItsTwin) {
    scene::Scene scene = testing::floorScene();
    scene.materials[0].specular = vec3(0.5f, 0.4f, 0.3f);
    scene.materials[0].emission = vec3(0.05f);
    testing::addObject(scene, scene::makeSphere(0.8, 48), testing::translation({0.5, 1, 1}));
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({-1.5, 0.5, 0}));
    testing::addObject(scene, scene::makeSphere(0.7, 6), testing::translation({-0.93, 1.62, 2.03})); // so coarse that normals at its rim lean away
    scene::Light light = testing::pointLight({2, 4, 3});
    light.type = GetParam();
    light.directionWorld = glm::normalize(dvec3(-0.4, -1, -0.6));
    light.edgeUWorld = {2, 0, 0};
    light.edgeVWorld = {0, 0, 1}; // shines to -y: cross(x, z) = -y
    light.edgeDegrees = 10;
    light.color = {1.0f, 0.8f, 0.6f};
    light.intensity = GetParam() == scene::LightType::directional ? 2 : 8;
    scene.lights = {light};

    const auto snapshot = testing::snapshot(scene);
    const ivec2 size{160, 120};
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot("unshadowed");
    View view;
    view.camera = scene.camera;
    view.size = size;
    session.render(slot, view);
    const std::vector<vec4> texels = gl::readTexels(slot.target.color);

    const trace::ExactVisibility judge(snapshot);
    int compared = 0, lit = 0, leaning = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, size);
            // Pixels whose neighbours show another triangle may have been drawn as that one.
            const auto next = judge.eyeHit(scene.camera, dvec2(x, y) + dvec2(0.51, 0.51), size);
            if (!hit || !next || next->object != hit->object || next->triangle != hit->triangle) continue;
            const scene::Object& object = scene.objects[hit->object];
            const scene::Mesh& mesh = *object.mesh;
            const uvec3 t = mesh.triangles[hit->triangle];
            const dvec3 weights = hit->barycentric;
            dvec3 normal =
                glm::normalize(weights.x * dvec3(mesh.normalsMesh[t.x]) + weights.y * dvec3(mesh.normalsMesh[t.y]) +
                               weights.z * dvec3(mesh.normalsMesh[t.z]));
            const dvec3 toEye = glm::normalize(scene.camera.positionWorld - hit->positionWorld);
            const auto corner = [&](std::uint32_t vertex) { return dvec3(mesh.positionsMesh[vertex]); };
            const dvec3 front = glm::cross(corner(t.y) - corner(t.x), corner(t.z) - corner(t.x)); // no object is turned
            if (glm::dot(front, toEye) < 0) normal = -normal;
            const scene::Material& material = scene.materials[0];
            dvec3 expected = dvec3(material.emission) + dvec3(scene.ambient) * dvec3(material.diffuse);
            // Unshadowed: the gates count, what stands in between does not.
            if (judge.visibility(*hit, scene.camera, 0) != trace::Visibility::turnedAway) {
                expected +=
                    scene::irradiance(light, hit->positionWorld, normal) *
                    scene::reflectance(material, normal, scene::towardLightWorld(light, hit->positionWorld), toEye);
                ++lit;
                leaning += glm::dot(normal, toEye) < 0 ? 1 : 0;
            }
            ++compared;
            const vec4 drawn = texels[static_cast<std::size_t>(y * size.x + x)];
            // A half float has 11 bits: 1/2048 of the value per addition, of which there are two, and float arithmetic.
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(drawn[c], expected[c], 1e-3 + 2e-3 * expected[c]) << x << "," << y;
        }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(lit, 500);
    EXPECT_GE(leaning, 3) << "turned to the eye, these were lit from behind";
}

// Halfway between a ray to the eye and one to the light straight behind the surface there is no direction: nought divided by nought.
// What is turned away from the light gets nothing of it all the same.
TEST_P(ShadingTest, ALightStraightBehindTheSurfaceMakesNoPixelNoNumber) {
    scene::Scene scene;
    scene.materials.emplace_back().specular = vec3(0.5f);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), dmat4(1));
    scene.camera.positionWorld = {0, 0, 4};
    scene.camera.targetWorld = {0, 0, 0};
    scene::Light light = testing::pointLight({0, 0, -4});
    light.type = GetParam();
    light.directionWorld = {0, 0, 1};
    light.edgeUWorld = {1, 0, 0};
    light.edgeVWorld = {0, 1, 0};
    scene.lights = {light};
    View view;
    view.camera = scene.camera;
    view.size = {33, 33}; // an odd number: the middle of a pixel is on the axis
    picture::Session session(testing::snapshot(scene));
    picture::Slot slot = picture::Session::makeSlot("unshadowed");
    session.render(slot, view);
    for (const vec4& texel : gl::readTexels(slot.target.color))
        ASSERT_TRUE(std::isfinite(texel.r));
}

INSTANTIATE_TEST_SUITE_P(All, ShadingTest,
                         ::testing::Values(scene::LightType::point, scene::LightType::directional,
                                           scene::LightType::spot, scene::LightType::rect, scene::LightType::sphere),
                         [](const auto& info) { return std::string(scene::toText(info.param)); });

} // namespace
} // namespace shadowlab
