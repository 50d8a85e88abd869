// Which patch does a place on a surface belong to?
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/surface_cells.h"

#include <gtest/gtest.h>

#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

std::unique_ptr<Room> roomOf(const scene::Scene& scene, std::size_t patches) {
    RoomSettings settings{patches, true, std::vector<bool>(scene.objects.size(), false)};
    auto room = std::make_unique<Room>(scene, settings);
    EXPECT_TRUE(room->advance(std::chrono::steady_clock::time_point::max()));
    return room;
}

/// How far a point lies outside of a patch, metres; below 0: inside.
double outside(const Patch& patch, const dvec3& p) {
    double farthest = std::abs(patch.plane().height(p));
    for (std::size_t i = 0; i < patch.polygon.count(); ++i) {
        const dvec3 &a = patch.polygon[i], &b = patch.polygon[(i + 1) % patch.polygon.count()];
        farthest = std::max(farthest, -glm::dot(glm::normalize(glm::cross(patch.normal, b - a)), p - a));
    }
    return farthest;
}

TEST(SurfaceCells, EveryPlaceOnAFlatFaceIsInItsPatch) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeBox({1, 2, 0.5}), translation({0.3, 1, -0.4}));
    addObject(scene, scene::makeQuad({3, 2}), glm::rotate(translation({1, 1.4, 1}), 0.7, dvec3(0.3, 0.2, 1)));
    const auto room = roomOf(scene, 300);
    ASSERT_GT(room->patches().size(), 150u);
    const SurfaceCells cells = surfaceCells(scene, *room);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::uint32_t first = 0;
    int found = 0;
    for (const scene::Object& object : scene.objects) {
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t)
            for (int i = 0; i < 300; ++i) {
                double u = unit(random), v = unit(random);
                if (u + v > 1) {
                    u = 1 - u;
                    v = 1 - v;
                }
                const auto corner = [&](int c) {
                    return dvec3(object.mesh->positionsMesh[object.mesh->triangles[t][c]]);
                };
                const vec3 positionMesh(corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0)));
                const dvec3 centred =
                    transformPoint(scene::worldFromMesh(object), dvec3(positionMesh)) - room->world().originWorld;
                // Under the box, where nobody can see it, the floor has no patches.
                const dvec3 fromBox = glm::abs(centred + room->world().originWorld - dvec3(0.3, 1, -0.4));
                if (&object == scene.objects.data() && fromBox.x < 0.5 && fromBox.z < 0.25) continue;
                for (const bool front : {true, false}) {
                    const auto patch = patchAt(cells, first + t, front, positionMesh);
                    if (!patch) continue;
                    ++found;
                    const Patch& of = room->allPatches()[*patch];
                    // Floats of coordinates of some metres.
                    ASSERT_LT(outside(of, centred), 1e-5);
                    EXPECT_EQ(&room->objectOf(of), &room->simple().scene->objects[&object - scene.objects.data()]);
                }
            }
        first += static_cast<std::uint32_t>(object.mesh->triangles.size());
    }
    // The underside of the box, and the floor below it, are none: 2 of 16 triangles, and the insides of the box.
    EXPECT_GT(found, 5000);
}

TEST(SurfaceCells, MeshesThatWereSimplifiedHaveThePatchesOfThePlacesNearBy) {
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeSphere(0.5, 64), translation({0, 0.6, 0}));
    const auto room = roomOf(scene, 200);
    ASSERT_LT(room->patches().size(), 260u);
    const SurfaceCells cells = surfaceCells(scene, *room);
    const scene::Mesh& mesh = *scene.objects[1].mesh;
    const auto first = static_cast<std::uint32_t>(scene.objects[0].mesh->triangles.size());
    int found = 0;
    double farthest = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const vec3 middle = (mesh.positionsMesh[mesh.triangles[t][0]] + mesh.positionsMesh[mesh.triangles[t][1]] +
                             mesh.positionsMesh[mesh.triangles[t][2]]) /
                            3.0f;
        const auto patch = patchAt(cells, first + t, true, middle);
        ASSERT_TRUE(patch);
        const Patch& of = room->allPatches()[*patch];
        ASSERT_EQ(room->faceOf(of).object, 1u);
        const dvec3 centred =
            transformPoint(scene::worldFromMesh(scene.objects[1]), dvec3(middle)) - room->world().originWorld;
        farthest = std::max(farthest, glm::length(of.centre - centred));
        ++found;
        EXPECT_FALSE(patchAt(cells, first + t, false, middle)) << "no light gets inside";
    }
    EXPECT_GT(found, 3000);
    EXPECT_LT(farthest, 2 * room->simple().cellMetres);
    // A constant stays one.
    const std::vector<dvec3> ones(room->allPatches().size(), dvec3(1));
    for (const vec4& value : cellValues(cells, ones).ofBorders)
        ASSERT_NEAR(value.g, 1, 1e-6);
}

} // namespace
} // namespace shadowlab::radiosity
