// Coarser meshes: few enough, still closed, of nearly the same size, and every corner of the original has its place on them.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/simplified_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/foundation/trace/world_triangles.h"
#include "techniques/radiosity/patches/faces.h"
#include "tests/support/scenes.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

scene::Scene sceneOf(scene::Mesh mesh, const dmat4& worldFromObject = dmat4(1.0)) {
    scene::Scene scene;
    scene.materials.resize(2);
    addObject(scene, std::move(mesh), worldFromObject);
    return scene;
}

dvec3 areaVector(const trace::Triangle& t) { return 0.5 * glm::cross(t.b - t.a, t.c - t.a); }

struct Sums {
    double area = 0, volume = 0;
    dvec3 vector{0.0};
};
Sums sumsOf(const scene::Scene& scene) {
    Sums sums;
    for (const trace::Triangle& t : trace::worldTriangles(scene).triangles) {
        sums.area += glm::length(areaVector(t));
        sums.vector += areaVector(t);
        sums.volume += glm::dot(areaVector(t), t.a) / 3;
    }
    return sums;
}

/// How far corners are from their places at most, and how many faced another way; all weights and numbers are in range.
struct Placed {
    double farthest = 0;
    int otherWay = 0, corners = 0;
};
Placed placed(const scene::Scene& before, const SimplifiedScene& after) {
    Placed result;
    const trace::WorldTriangles fine = trace::worldTriangles(before), coarse = trace::worldTriangles(*after.scene);
    const dvec3 shift = coarse.originWorld - fine.originWorld;
    for (std::size_t o = 0; o < before.objects.size(); ++o) {
        const auto& corners = after.cornersOfObject[o];
        for (std::size_t t = 0; t < corners.size(); ++t) {
            const trace::Triangle& triangle = fine.triangles[fine.firstOfObject[o] + t];
            const dvec3 positions[] = {triangle.a, triangle.b, triangle.c};
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const SurfacePlace& place = corners[t][corner];
                EXPECT_LT(place.triangle, coarse.triangles.size());
                EXPECT_EQ(coarse.objects[place.triangle], o);
                EXPECT_NEAR(place.weights[0] + place.weights[1] + place.weights[2], 1, 1e-5f);
                EXPECT_GE(std::ranges::min(place.weights), 0);
                const trace::Triangle& on = coarse.triangles[place.triangle];
                const dvec3 there = static_cast<double>(place.weights[0]) * on.a +
                                    static_cast<double>(place.weights[1]) * on.b +
                                    static_cast<double>(place.weights[2]) * on.c + shift;
                result.farthest = std::max(result.farthest, glm::distance(there, positions[corner]));
                const double facing = glm::dot(glm::normalize(areaVector(triangle)), glm::normalize(areaVector(on)));
                result.otherWay += !(facing > 0.2);
                ++result.corners;
            }
        }
    }
    return result;
}

int edgesWithoutOpposite(const scene::Mesh& mesh) {
    const scene::MeshTopology topology = scene::buildTopology(mesh);
    int count = 0;
    for (const scene::Edge& edge : topology.edges) {
        bool forth = false, back = false;
        for (std::uint32_t i = 0; i < edge.useCount; ++i)
            (topology.uses[edge.firstUse + i].direction > 0 ? forth : back) = true;
        count += !forth || !back;
    }
    return count;
}

/// A square of that many squares in each direction in the plane y = 0, each of two triangles. Right of the middle it is of a second
/// part, if wanted.
scene::Mesh grid(int squares, double side, bool twoParts) {
    scene::Mesh mesh;
    for (int j = 0; j <= squares; ++j)
        for (int i = 0; i <= squares; ++i)
            mesh.positionsMesh.emplace_back(side * (static_cast<double>(i) / squares - 0.5), 0.0,
                                            side * (static_cast<double>(j) / squares - 0.5));
    mesh.normalsMesh.assign(mesh.positionsMesh.size(), vec3(0, 1, 0));
    std::vector<uvec3> right;
    for (int j = 0; j < squares; ++j)
        for (int i = 0; i < squares; ++i) {
            const auto at = [&](int di, int dj) {
                return static_cast<std::uint32_t>((j + dj) * (squares + 1) + i + di);
            };
            std::vector<uvec3>& part = twoParts && 2 * i >= squares ? right : mesh.triangles;
            part.emplace_back(at(0, 0), at(0, 1), at(1, 1));
            part.emplace_back(at(0, 0), at(1, 1), at(1, 0));
        }
    const auto left = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.parts.push_back({"left", 0, left, false});
    if (twoParts) mesh.parts.push_back({"right", left, static_cast<std::uint32_t>(right.size()), false});
    mesh.triangles.insert(mesh.triangles.end(), right.begin(), right.end());
    return mesh;
}

TEST(SimplifiedScene, RoundThingsStayClosedAndKeepTheirSize) {
    int tried = 0;
    for (const bool isTorus : {false, true})
        for (const std::size_t most : {100u, 300u, 1000u, 3000u}) {
            const dmat4 turned = glm::rotate(translation({3, -2, 1}), 0.7, glm::normalize(dvec3(1, 2, 3)));
            const scene::Scene before =
                sceneOf(isTorus ? scene::makeTorus(1, 0.4, {128, 64}) : scene::makeSphere(1, 128), turned);
            const SimplifiedScene after = simplifiedScene(before, most);
            EXPECT_EQ(after.trianglesBefore, before.objects[0].mesh->triangles.size());
            EXPECT_EQ(after.trianglesAfter, after.scene->objects[0].mesh->triangles.size());
            EXPECT_LE(after.trianglesAfter, most);
            EXPECT_GT(after.trianglesAfter,
                      most / 3); // a step finer is some 40 % more, and lattices fit better or worse
            EXPECT_EQ(edgesWithoutOpposite(*after.scene->objects[0].mesh), 0) << isTorus << ' ' << most;
            const Placed corners = placed(before, after);
            EXPECT_EQ(corners.corners, 3 * static_cast<int>(after.trianglesBefore));
            EXPECT_EQ(corners.otherWay, 0);
            EXPECT_LT(corners.farthest, std::sqrt(3.0) * after.cellMetres);
            const Sums was = sumsOf(before), is = sumsOf(*after.scene);
            // What n triangles on a round thing miss falls as 1 / n; a torus bends more in less area, and its tube is folded where
            // cells are as wide.
            const double missed = (isTorus ? 24.0 : 8.0) / static_cast<double>(after.trianglesAfter);
            EXPECT_NEAR(is.area / was.area, 1, missed) << isTorus << ' ' << most;
            EXPECT_NEAR(is.volume / was.volume, 1, missed) << isTorus << ' ' << most;
            EXPECT_LT(glm::length(is.vector), 1e-12 * is.area); // nothing, of a closed surface
            ++tried;
        }
    EXPECT_EQ(tried, 8);
}

/// The corner cells have the square's corners for their vertices, not the means of what is in them.
TEST(SimplifiedScene, AFlatSquareKeepsItsOutline) {
    const scene::Scene before = sceneOf(grid(70, 2, false));
    ASSERT_EQ(before.objects[0].mesh->triangles.size(), 9800u);
    for (const std::size_t most : {20u, 200u, 2000u}) {
        const SimplifiedScene after = simplifiedScene(before, most);
        EXPECT_LE(after.trianglesAfter, most);
        const scene::Mesh& mesh = *after.scene->objects[0].mesh;
        for (const float x : {-1.0f, 1.0f})
            for (const float z : {-1.0f, 1.0f}) {
                float nearest = 1;
                for (const vec3& p : mesh.positionsMesh)
                    nearest = std::min(nearest, glm::distance(p, vec3(x, 0, z)));
                EXPECT_LT(nearest, 1e-6f) << most;
            }
        for (const vec3& p : mesh.positionsMesh)
            EXPECT_EQ(p.y, 0);
        const Sums is = sumsOf(*after.scene);
        EXPECT_NEAR(is.area, 4, 1e-5) << most; // nothing is folded
        EXPECT_NEAR(is.vector.y, 4, 1e-5) << most;
        EXPECT_LT(placed(before, after).farthest, 1e-6) << "all of it is where it was";
    }
}

TEST(SimplifiedScene, TwoPartsStayTwo) {
    scene::Scene before = sceneOf(grid(70, 2, true));
    before.objects[0].partMaterials = {0, 1};
    const SimplifiedScene after = simplifiedScene(before, 300);
    const scene::Mesh& mesh = *after.scene->objects[0].mesh;
    ASSERT_EQ(mesh.parts.size(), 2u);
    EXPECT_EQ(mesh.parts[0].materialName, "left");
    EXPECT_EQ(mesh.parts[1].firstTriangle, mesh.parts[0].triangleCount);
    EXPECT_EQ(mesh.parts[0].triangleCount + mesh.parts[1].triangleCount, mesh.triangles.size());
    int compared = 0;
    for (std::uint32_t part = 0; part < 2; ++part)
        for (std::uint32_t t = 0; t < mesh.parts[part].triangleCount; ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const float x = mesh.positionsMesh[mesh.triangles[mesh.parts[part].firstTriangle + t][corner]].x;
                EXPECT_GT(part == 0 ? -x : x, -1e-6f) << "the line between them stays where it is";
                ++compared;
            }
    EXPECT_GT(compared, 400);
    EXPECT_EQ(facesOf(*after.scene, trace::worldTriangles(*after.scene)).all.back().material, 1u);
    for (const auto& corners : after.cornersOfObject[0]) {
        const std::size_t t = static_cast<std::size_t>(&corners - after.cornersOfObject[0].data());
        const bool isLeft = t < before.objects[0].mesh->parts[0].triangleCount;
        for (const SurfacePlace& place : corners)
            ASSERT_EQ(place.triangle < mesh.parts[0].triangleCount, isLeft);
    }
}

/// Boxes are as they were, to the very mesh; lights' surfaces are gone; small things among large ones do not vanish.
TEST(SimplifiedScene, WhatStaysAndWhatDoesNotVanish) {
    scene::Scene before = sceneOf(scene::makeBox({1, 1, 1}));
    addObject(before, scene::makeSphere(1, 64), translation({3, 0, 0}));
    addObject(before, scene::makeTorus(0.01, 0.003, {64, 32}), translation({0, 2, 0}));
    scene::Light lamp;
    lamp.type = scene::LightType::sphere;
    lamp.positionWorld = dvec3(0, 5, 0);
    before.lights = {lamp};
    scene::addEmitterSurfaces(before);
    ASSERT_EQ(before.objects.size(), 4u);
    const SimplifiedScene after = simplifiedScene(before, 300);
    ASSERT_EQ(after.scene->objects.size(), 4u);
    EXPECT_LE(after.trianglesAfter, 300u);
    EXPECT_EQ(after.scene->objects[0].mesh, before.objects[0].mesh);
    EXPECT_TRUE(after.cornersOfObject[0].empty());
    EXPECT_EQ(after.cornersOfObject[1].size(), before.objects[1].mesh->triangles.size());
    EXPECT_GE(after.scene->objects[2].mesh->triangles.size(), 8u);
    EXPECT_LT(after.scene->objects[2].mesh->triangles.size(), 50u);
    EXPECT_EQ(after.scene->objects[3].mesh->triangles.size(), 0u);
    EXPECT_EQ(after.scene->objects[3].mesh->parts.size(), 1u);
    EXPECT_TRUE(after.cornersOfObject[3].empty());
    EXPECT_NE(after.scene->revisions.geometry, before.revisions.geometry);
    EXPECT_LT(placed(before, after).farthest, std::sqrt(3.0) * after.cellMetres);

    const SimplifiedScene all = simplifiedScene(before, 1000000);
    EXPECT_EQ(all.cellMetres, 0);
    EXPECT_EQ(all.trianglesAfter, all.trianglesBefore);
    EXPECT_EQ(all.scene->objects[1].mesh, before.objects[1].mesh);
    EXPECT_EQ(all.scene->objects[3].mesh->triangles.size(), 0u);
    // Not worth it, or not enough without it.
    const scene::Scene ring = sceneOf(scene::makeTorus(1, 0.5, {10, 8}));
    ASSERT_EQ(ring.objects[0].mesh->triangles.size(), 160u);
    for (const std::size_t most : {150u, 120u, 60u})
        EXPECT_LE(simplifiedScene(ring, most).trianglesAfter, std::min<std::size_t>(most, 120)) << most;
    EXPECT_EQ(simplifiedScene(before, 1).scene->objects[0].mesh, before.objects[0].mesh) << "as near as it gets";
}

/// A mesh so small that all of it fits into the smallest cells that the scene's size would give: hundreds of thousands of patches
/// too small to be seen would exchange light, each with all others.
TEST(SimplifiedScene, HoweverSmallSomethingIsItBecomesCoarser) {
    int tried = 0;
    for (const double radius : {1e-3, 1e-5, 1e-9, 1e-12, 1e-30})
        for (const bool isAlone : {false, true}) {
            scene::Scene before = sceneOf(scene::makeSphere(radius, 64));
            if (!isAlone) addObject(before, scene::makeSphere(1, 64), translation({3, 0, 0}));
            addObject(before, scene::makeBox({1, 1, 1}), translation({-3, 0, 0}));
            const SimplifiedScene after = simplifiedScene(before, 600);
            const scene::Mesh& mesh = *after.scene->objects[0].mesh;
            EXPECT_LE(after.trianglesAfter, 600u) << radius;
            EXPECT_GE(mesh.triangles.size(), 8u) << radius;
            EXPECT_EQ(edgesWithoutOpposite(mesh), 0) << radius;
            ASSERT_EQ(after.cornersOfObject[0].size(), before.objects[0].mesh->triangles.size());
            float farthest = 0;
            for (const vec3& p : mesh.positionsMesh)
                farthest = std::max(farthest, glm::length(p / static_cast<float>(radius)));
            EXPECT_NEAR(farthest, 1, 0.2)
                << radius; // cells of about its size: an octahedron's vertices lie outside or inside
            ++tried;
        }
    EXPECT_EQ(tried, 10);

    // And a scene whose things are all small, because one of them stands far away.
    scene::Scene far = sceneOf(scene::makeSphere(1, 64));
    addObject(far, scene::makeTorus(1, 0.4, {64, 32}), translation({3, 0, 0}));
    addObject(far, scene::makeBox({1, 1, 1}), translation({-4e11, 0, 0}));
    const SimplifiedScene after = simplifiedScene(far, 1000);
    EXPECT_LE(after.trianglesAfter, 1000u);
    EXPECT_GT(after.trianglesAfter, 1000u / 3);
}

TEST(SimplifiedScene, TheSameForAnyNumberOfThreads) {
    scene::Scene before = sceneOf(scene::makeSphere(1, 64));
    addObject(before, scene::makeTorus(1, 0.4, {64, 32}), translation({3, 0, 0}));
    const char* const kept = std::getenv("SHADOWLAB_THREADS");
    const std::string threadsBefore = kept ? kept : "";
    std::vector<SimplifiedScene> all;
    for (const char* threads : {"1", "2", "3"}) {
        ::setenv("SHADOWLAB_THREADS", threads, 1);
        all.push_back(simplifiedScene(before, 1000));
    }
    kept ? ::setenv("SHADOWLAB_THREADS", threadsBefore.c_str(), 1) : ::unsetenv("SHADOWLAB_THREADS");
    for (const SimplifiedScene& one : all)
        for (std::size_t o = 0; o < 2; ++o) {
            EXPECT_EQ(one.scene->objects[o].mesh->positionsMesh, all[0].scene->objects[o].mesh->positionsMesh);
            EXPECT_EQ(one.scene->objects[o].mesh->triangles, all[0].scene->objects[o].mesh->triangles);
            EXPECT_EQ(one.cornersOfObject[o], all[0].cornersOfObject[o]);
            EXPECT_GT(one.cornersOfObject[o].size(), 3000u);
        }
}

/// Two sides of a sheet thinner than a cell: both stay, and no corner goes to the other side.
TEST(SimplifiedScene, ThinSheetsKeepTheirSides) {
    scene::Mesh sheet = grid(40, 2, false), below = sheet;
    const auto first = static_cast<std::uint32_t>(sheet.positionsMesh.size());
    for (vec3 p : below.positionsMesh)
        sheet.positionsMesh.push_back(p - vec3(0, 0.001f, 0));
    sheet.normalsMesh.resize(sheet.positionsMesh.size(), vec3(0, -1, 0));
    for (const uvec3& t : below.triangles)
        sheet.triangles.emplace_back(first + t.x, first + t.z, first + t.y);
    sheet.parts[0].triangleCount *= 2;
    const scene::Scene before = sceneOf(std::move(sheet));
    const SimplifiedScene after = simplifiedScene(before, 400);
    const Sums is = sumsOf(*after.scene);
    EXPECT_NEAR(is.area, 8, 1e-2);
    EXPECT_LT(glm::length(is.vector), 1e-6);
    EXPECT_EQ(placed(before, after).otherWay, 0);
}

/// Scaled and mirrored objects have the same cells in metres; far from the origin nothing changes.
TEST(SimplifiedScene, MatricesCount) {
    const dmat4 flat = glm::scale(dmat4(1.0), dvec3(1, 0.2, -3));
    const scene::Scene before = sceneOf(scene::makeSphere(1, 64), flat);
    const SimplifiedScene after = simplifiedScene(before, 600);
    EXPECT_EQ(edgesWithoutOpposite(*after.scene->objects[0].mesh), 0);
    EXPECT_NEAR(sumsOf(*after.scene).volume / sumsOf(before).volume, 1, 0.05);
    EXPECT_LT(sumsOf(before).volume, 0) << "mirrored, and it stays so";
    const Placed corners = placed(before, after);
    EXPECT_LT(corners.farthest, std::sqrt(3.0) * after.cellMetres);
    EXPECT_EQ(corners.otherWay, 0);

    const SimplifiedScene away = simplifiedScene(moved(before, {1048576, 0, -1048576}), 600);
    EXPECT_EQ(away.scene->objects[0].mesh->triangles, after.scene->objects[0].mesh->triangles);
    EXPECT_EQ(away.scene->objects[0].mesh->positionsMesh, after.scene->objects[0].mesh->positionsMesh);
}

} // namespace
} // namespace shadowlab::radiosity
