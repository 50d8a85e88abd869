// Emitters as patches: the side that shines, emitters in a face, and rooms of one mesh, whichever way its faces wind.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/room_cache.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/area_lights.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr int kPatches = 600;

struct Balance {
    double emittedWatts = 0; ///< red, by materials
    double meanOfFloor = 0;  ///< radiosity of what lies at y = 0 and faces up
    std::size_t coveredPatches = 0;
};

Balance balanceOf(scene::Scene scene) {
    scene.revisions = {};
    RadiosityParams params;
    params.patches = kPatches;
    params.refine = 0;
    RoomCache cache;
    const scene::Snapshot snapshot = testing::snapshot(std::move(scene));
    while (!cache.advance(snapshot, params, Deadline::max())) {
    }
    const Sources sources = sourcesOf(cache.room(), cache.lights(), dvec3(0));
    LightBalance balance;
    balance.restart(cache.exchange(), sources, SolverKind::conjugateGradients);
    balance.advance({1e-6, 0}, 0, Deadline::max());
    Balance found;
    double area = 0;
    const std::vector<Patch>& patches = cache.room().allPatches();
    for (std::size_t i = 0; i < patches.size(); ++i) {
        found.emittedWatts += patches[i].area * sources.emission[i].x;
        const double height = patches[i].centre.y + cache.room().world().originWorld.y;
        if (std::abs(height) > 1e-6 || patches[i].normal.y < 0.5) continue;
        found.meanOfFloor += patches[i].area * balance.radiosity()[i].x;
        area += patches[i].area;
    }
    found.meanOfFloor /= area;
    found.coveredPatches = cache.room().coveredPatches();
    return found;
}

/// A room of 2 m, and a shining square of 0.5 x 0.5 m that far under its ceiling.
scene::Scene roomWithPanel(double gap, scene::EmittingSides sides) {
    scene::Scene scene = emptyRoom({2, 2, 2});
    scene::Material shining;
    shining.diffuse = vec3(0);
    shining.emission = vec3(6);
    shining.emits = sides;
    scene.materials.push_back(shining);
    addObject(scene, scene::makeQuad({1, 1}),
              translation({1, 2 - gap, 1}) * glm::rotate(dmat4(1), glm::radians(180.0), dvec3(1, 0, 0)))
        .partMaterials = {1};
    return scene;
}

// A Lambertian emitter of 1 m^2 and radiance 6 sends 6 pi = 18.85 W from a side. Vertices are floats.
TEST(Emitters, SendFromTheFrontOrFromBothSides) {
    using enum scene::EmittingSides;
    EXPECT_NEAR(balanceOf(roomWithPanel(0.005, front)).emittedWatts, 6 * M_PI, 1e-4);
    EXPECT_NEAR(balanceOf(roomWithPanel(0.005, both)).emittedWatts, 12 * M_PI, 1e-4);
    scene::Scene mirrored = roomWithPanel(0.3, front);
    mirrored.objects.back().worldFromObject[0] *= -1.0;
    const Balance straight = balanceOf(roomWithPanel(0.3, front)), other = balanceOf(mirrored);
    EXPECT_NEAR(other.meanOfFloor / straight.meanOfFloor, 1, 0.01) << "a mirrored panel still shines down";
}

/// The same room, its ceiling of eight pieces around the panel: nothing lies in anything.
scene::Scene roomWithFrame() {
    scene::Scene scene = roomWithPanel(0, scene::EmittingSides::front);
    scene.objects.erase(scene.objects.begin() + 1); // the ceiling
    for (const double x : {0.25, 1.0, 1.75})
        for (const double z : {0.25, 1.0, 1.75})
            if (x != 1 || z != 1)
                addObject(scene, scene::makeQuad({x == 1 ? 1.0 : 0.5, z == 1 ? 1.0 : 0.5}),
                          translation({x, 2, z}) * glm::rotate(dmat4(1), glm::radians(180.0), dvec3(1, 0, 0)));
    return scene;
}

// Whichever of the two comes first in the scene.
TEST(Emitters, InACeilingLightTheRoomAsInAHoleOfIt) {
    const double around = balanceOf(roomWithFrame()).meanOfFloor;
    EXPECT_GT(around, 1);
    scene::Scene last = roomWithPanel(0, scene::EmittingSides::front), first = last;
    std::rotate(first.objects.begin(), first.objects.end() - 1, first.objects.end());
    for (const scene::Scene& scene : {last, first}) {
        const Balance in = balanceOf(scene);
        EXPECT_GT(in.coveredPatches, 0u) << "the ceiling behind the panel";
        EXPECT_NEAR(in.meanOfFloor / around, 1, 0.005);
    }
}

// What lies on the boundary of a body counts as within, where it shines inward: the same as in a room of six single walls.
TEST(Emitters, ALampInTheSideOfARoomOfOneBoxLightsIt) {
    const auto lit = [](scene::Scene room, scene::LightType type, const dvec3& place) {
        room.lights = {rectLight(place, {0.5, 0, 0}, {0, 0, 0.5})};
        room.lights[0].type = type;
        room.lights[0].radius = 0.1;
        room.lights[0].intensity = 10;
        return balanceOf(std::move(room)).meanOfFloor;
    };
    scene::Scene box;
    box.materials.emplace_back();
    addObject(box, scene::makeBox({2, 2, 2}), translation({1, 1, 1}));
    using enum scene::LightType;
    for (const scene::LightType type : {rect, point, spot, sphere}) {
        const double inBox = lit(box, type, {1, 2, 1}), inWalls = lit(emptyRoom({2, 2, 2}), type, {1, 2, 1});
        EXPECT_GT(inWalls, 0.05) << toText(type);
        EXPECT_NEAR(inBox / inWalls, 1, 0.005) << toText(type);
        // Just below the ceiling a point sends half of its light there. Of a sphere, of which a half is above, more comes down.
        if (type == rect || type == spot) EXPECT_NEAR(inBox / lit(box, type, {1, 1.999, 1}), 1, 0.005) << toText(type);
    }
}

/// A box of 2 m whose upper side shines, from both sides as in an MTL file.
scene::Scene roomOfOneMesh(bool outward) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.materials.emplace_back().emission = vec3(1);
    scene.materials.back().emits = scene::EmittingSides::both;
    scene::Mesh mesh = scene::makeBox({2, 2, 2});
    std::vector<uvec3> above, others;
    for (const uvec3& t : mesh.triangles)
        (mesh.positionsMesh[t.x].y > 0 && mesh.positionsMesh[t.y].y > 0 && mesh.positionsMesh[t.z].y > 0 ? above
                                                                                                         : others)
            .push_back(t);
    mesh.triangles = others;
    mesh.triangles.insert(mesh.triangles.end(), above.begin(), above.end());
    if (!outward)
        for (uvec3& t : mesh.triangles)
            std::swap(t.y, t.z);
    mesh.parts = {{"wall", 0, 10, false}, {"lamp", 10, 2, false}};
    addObject(scene, std::move(mesh), translation({0, 1, 0})).partMaterials = {0, 1};
    return scene;
}

TEST(Emitters, ARoomOfOneMeshIsLitWhicheverWayItsFacesWind) {
    const auto floorOf = [](scene::Scene scene) {
        scene.objects[0].mesh =
            scene::sharedMesh(scene::Mesh(*scene.objects[0].mesh)); // finds out whether it is outward
        return balanceOf(std::move(scene)).meanOfFloor;
    };
    const double out = floorOf(roomOfOneMesh(true)), in = floorOf(roomOfOneMesh(false));
    EXPECT_GT(in, 0.5);
    EXPECT_NEAR(out / in, 1, 0.01); // patches are the same, and lines between them are not
}

/// Of all its triangles, m^2.
double areaOf(const scene::Mesh& mesh, const dmat3& worldFromMesh) {
    double area = 0;
    for (const uvec3& t : mesh.triangles) {
        const auto corner = [&](std::uint32_t vertex) { return worldFromMesh * dvec3(mesh.positionsMesh[vertex]); };
        area += glm::length(areaVector({corner(t.x), corner(t.y), corner(t.z)}));
    }
    return area;
}

scene::Material glowing(scene::EmittingSides sides) {
    scene::Material material;
    material.diffuse = vec3(0.5f);
    material.emission = vec3(6);
    material.emits = sides;
    return material;
}

// A body that was simplified has lost some of its surface, and a thin ring more of it where it folds onto itself, but none of its light.
TEST(Emitters, ASimplifiedBodySendsWhatItsMeshSends) {
    const auto wattsPerTrue = [](scene::Mesh mesh, const dvec3& scale) {
        scene::Scene scene = emptyRoom({4, 3, 5});
        scene.materials.push_back(glowing(scene::EmittingSides::front));
        addObject(scene, std::move(mesh), glm::scale(translation({2, 1.8, 2}), scale)).partMaterials = {1};
        EXPECT_TRUE(scene.objects.back().mesh->outward);
        const double area = areaOf(*scene.objects.back().mesh, dmat3(scene.objects.back().worldFromObject));
        return balanceOf(std::move(scene)).emittedWatts / (6 * M_PI * area);
    };
    EXPECT_NEAR(wattsPerTrue(scene::makeSphere(0.15, 48), dvec3(1)), 1, 1e-5) << "floats";
    for (const dvec3 scale : {dvec3(1), dvec3(1, -1, 1), dvec3(1, -1, 1.6), dvec3(1, 1, 1.6)}) // of the third four fifths were lost
        EXPECT_NEAR(wattsPerTrue(scene::makeTorus(0.5, 0.04, {200, 40}), scale), 1, 1e-5) << scale.y << ' ' << scale.z;
}

// What encloses a place is as bright there as it is, however it was simplified: B = E / (1 - rho).
TEST(Emitters, ASimplifiedBallThatIsTheRoomIsAsBrightAsItIs) {
    scene::Scene scene;
    scene.materials.push_back(glowing(scene::EmittingSides::both));
    addObject(scene, scene::makeSphere(2, 48), translation({0, 2, 0})).partMaterials = {0};
    RadiosityParams params;
    params.patches = kPatches;
    RoomCache cache;
    const scene::Snapshot snapshot = testing::snapshot(std::move(scene));
    while (!cache.advance(snapshot, params, Deadline::max())) {
    }
    ASSERT_FALSE(cache.room().simple().cornersOfObject[0].empty());
    const Sources sources = sourcesOf(cache.room(), cache.lights(), dvec3(0));
    int shining = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Patch& patch = cache.room().allPatches()[i];
        const dvec3 fromMiddle = patch.centre + cache.room().world().originWorld - dvec3(0, 2, 0);
        if (glm::dot(patch.normal, fromMiddle) > 0) continue; // seen from outside
        EXPECT_NEAR(sources.emission[i].x, 6 * M_PI, 1e-5);
        ++shining;
    }
    EXPECT_GT(shining, 50);
}

} // namespace
} // namespace shadowlab::radiosity
