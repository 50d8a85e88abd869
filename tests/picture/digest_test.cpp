// Digests of scenes: whatever a picture depends on changes them, and nothing else does.
// SPDX-License-Identifier: MIT
#include "app/picture/digest.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::picture {
namespace {

std::shared_ptr<const scene::AlphaMask> maskOf(std::uint8_t alpha) {
    return std::make_shared<const scene::AlphaMask>(image::PictureFile{image::Image(2, 1, {0, 0, 0, alpha}), true});
}

scene::Scene small() {
    scene::Scene small;
    small.name = "small";
    small.lights.resize(1);
    small.materials.resize(1);
    small.materials[0].alphaMask = maskOf(255);
    scene::Mesh mesh;
    mesh.positionsMesh = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normalsMesh = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
    mesh.triangles = {{0, 1, 2}};
    mesh.parts = {{"white", 0, 1, true}};
    small.objects.resize(1);
    small.objects[0].mesh = std::make_shared<const scene::Mesh>(mesh);
    small.objects[0].partMaterials = {0};
    return small;
}

using Change = std::function<void(scene::Scene&)>;

Change inMesh(std::function<void(scene::Mesh&)> change) {
    return [change = std::move(change)](scene::Scene& scene) {
        scene::Mesh mesh = *scene.objects[0].mesh;
        change(mesh);
        scene.objects[0].mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
    };
}

const std::vector<Change>& changes() {
    using scene::Scene;
    static const std::vector<Change> all{
        [](Scene& s) { s.camera.positionWorld.x += 1e-12; },
        [](Scene& s) { s.camera.targetWorld.y += 1e-12; },
        [](Scene& s) { s.camera.upWorld.x += 1e-12; },
        [](Scene& s) { s.camera.fovYDegrees += 1; },
        [](Scene& s) { s.camera.near *= 2; },
        [](Scene& s) { s.camera.far = 10; },
        [](Scene& s) { s.ambient.r = 0.5f; },
        [](Scene& s) { s.background.g = 0.5f; },
        [](Scene& s) { s.exposure = 2; },
        [](Scene& s) { s.lights[0].name = "key"; },
        [](Scene& s) { s.lights[0].type = scene::LightType::spot; },
        [](Scene& s) { s.lights[0].positionWorld.z = 1; },
        [](Scene& s) {
            s.lights[0].directionWorld = {1, 0, 0};
        },
        [](Scene& s) { s.lights[0].edgeUWorld.x = 2; },
        [](Scene& s) { s.lights[0].edgeVWorld.z = 2; },
        [](Scene& s) { s.lights[0].radius = 2; },
        [](Scene& s) { s.lights[0].coneDegrees = 10; },
        [](Scene& s) { s.lights[0].edgeDegrees = 10; },
        [](Scene& s) { s.lights[0].color.b = 0; },
        [](Scene& s) { s.lights[0].intensity = 2; },
        [](Scene& s) { s.lights.emplace_back(); },
        [](Scene& s) { s.materials[0].name = "red"; },
        [](Scene& s) { s.materials[0].diffuse.r = 0; },
        [](Scene& s) { s.materials[0].specular.r = 1; },
        [](Scene& s) { s.materials[0].shininess = 1; },
        [](Scene& s) { s.materials[0].emission.r = 1; },
        [](Scene& s) { s.materials[0].reflectivity = 1; },
        [](Scene& s) { s.materials[0].transparency = 1; },
        [](Scene& s) { s.materials[0].ior = 1; },
        [](Scene& s) { s.materials[0].priority = 1; },
        [](Scene& s) { s.materials[0].emits = scene::EmittingSides::both; },
        [](Scene& s) { s.materials[0].glossDegrees = 1; },
        [](Scene& s) { s.materials[0].translucencyDegrees = 1; },
        [](Scene& s) { s.materials[0].alphaMask = nullptr; },
        [](Scene& s) { s.materials[0].alphaMask = maskOf(0); },
        [](Scene& s) { s.materials.emplace_back(); },
        [](Scene& s) { s.objects[0].name = "box"; },
        [](Scene& s) { s.objects[0].worldFromObject[3][0] = 1; },
        [](Scene& s) { s.objects[0].partMaterials = {1}; },
        [](Scene& s) { s.objects[0].castsShadow = false; },
        [](Scene& s) { s.objects[0].receivesShadow = false; },
        [](Scene& s) { s.objects[0].velocityWorld.x = 1; },
        [](Scene& s) { s.objects[0].emitterOfLight = 0; },
        [](Scene& s) { s.objects.push_back(s.objects[0]); },
        inMesh([](scene::Mesh& m) { m.originObject.y = 1; }),
        inMesh([](scene::Mesh& m) { m.positionsMesh[1].x = 2; }),
        inMesh([](scene::Mesh& m) { m.normalsMesh[1].x = 1; }),
        inMesh([](scene::Mesh& m) { m.texcoords[1].x = 2; }),
        inMesh([](scene::Mesh& m) {
            m.triangles[0] = {0, 2, 1};
        }),
        inMesh([](scene::Mesh& m) { m.parts[0].triangleCount = 0; }),
        inMesh([](scene::Mesh& m) { m.parts[0].hasTexcoords = false; }),
    };
    return all;
}

TEST(Digest, EverythingThatAPictureDependsOnChangesIt) {
    std::set<std::string> digests{digestOf(small())};
    for (std::size_t i = 0; i < changes().size(); ++i) {
        scene::Scene changed = small();
        changes()[i](changed);
        EXPECT_TRUE(digests.insert(digestOf(changed)).second) << "change " << i << " is not seen";
    }
    EXPECT_EQ(digests.size(), changes().size() + 1);
}

TEST(Digest, WhereTheFilesLieDoesNot) {
    scene::Scene elsewhere = small();
    elsewhere.objects[0].source.mesh = "/elsewhere/box.obj";
    elsewhere.materials[0].alphaMap = "/elsewhere/holes.png";
    elsewhere.notes = {"a note"};
    elsewhere.revisions = {};
    EXPECT_EQ(digestOf(elsewhere), digestOf(small()));
}

} // namespace
} // namespace shadowlab::picture
