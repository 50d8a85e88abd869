// Which parts of a mesh are never inside out, and what would be wrong if a weaker test let others pass.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/outward_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using scene::OutwardParts;

OutwardParts partsOf(const scene::Mesh& mesh) { return scene::outwardParts(mesh, scene::buildTopology(mesh)); }

bool allPass(const scene::Mesh& mesh) {
    const OutwardParts parts = partsOf(mesh);
    return !parts.boxes.empty() && std::ranges::count(parts.partOfTriangle, OutwardParts::kNone) == 0;
}

scene::Mesh turnedInsideOut(scene::Mesh mesh) {
    for (uvec3& t : mesh.triangles)
        std::swap(t.y, t.z);
    mesh.outward = false;
    return mesh;
}

/// Two meshes as one.
scene::Mesh together(scene::Mesh mesh, const scene::Mesh& other, const vec3& offset) {
    const auto base = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    for (const vec3& position : other.positionsMesh)
        mesh.positionsMesh.push_back(position + offset);
    for (const uvec3& t : other.triangles)
        mesh.triangles.push_back(t + base);
    return mesh;
}

double signedVolume(const scene::Mesh& mesh) {
    double volume = 0;
    for (const uvec3& t : mesh.triangles)
        volume += glm::dot(dvec3(mesh.positionsMesh[t.x]),
                           glm::cross(dvec3(mesh.positionsMesh[t.y]), dvec3(mesh.positionsMesh[t.z]))) /
                  6;
    return volume;
}

/// A prism over a bow tie: the large lobe is the right way round, the small one inside out.
scene::Mesh bowTie() {
    const dvec3 a(-2, 0, -2), b(1, 0, 1), c(1, 0, -1), d(-2, 0, 2), up(0, 1, 0);
    std::vector<dvec3> corners = {a, b, c, a, c, d, a + up, c + up, b + up, a + up, d + up, c + up};
    const dvec3 around[] = {a, b, c, d, a};
    for (int i = 0; i < 4; ++i) {
        const dvec3 p = around[i], q = around[i + 1];
        corners.insert(corners.end(), {p, p + up, q, q, p + up, q + up});
    }
    scene::Mesh mesh = testing::triangleSoup(corners);
    return signedVolume(mesh) > 0 ? mesh : turnedInsideOut(mesh);
}

std::shared_ptr<const scene::Mesh> model(const std::string& name) {
    const auto staged = scene::loadScene((context::assetsRoot() / "models" / name).string(),
                                         {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    return std::ranges::max_element(staged->objects, {},
                                    [](const scene::Object& o) {
                                        return o.mesh->triangles.size(); // the rest is the stage it stands on
                                    })
        ->mesh;
}

TEST(OutwardParts, BoxesSpheresToriAndColumnsPass) {
    EXPECT_TRUE(allPass(scene::makeBox({1, 2, 3})));
    EXPECT_TRUE(allPass(scene::makeSphere(0.5, 32)));
    EXPECT_TRUE(allPass(scene::makeTorus(1, 0.4, {24, 12}))); // toward the plane in its middle
    EXPECT_TRUE(allPass(*model("column.obj")));
    EXPECT_TRUE(allPass(*model("entablature.obj")));
}

TEST(OutwardParts, WhatMeetsItselfNowherePasses) {
    EXPECT_TRUE(allPass(*model("torus_knot.obj")));
    EXPECT_TRUE(partsOf(turnedInsideOut(*model("torus_knot.obj"))).boxes.empty());
}

TEST(OutwardParts, WhatIsOpenOrInsideOutOrCannotBeShownDoesNot) {
    scene::Mesh open = scene::makeBox({1, 1, 1});
    open.triangles.pop_back();
    EXPECT_FALSE(allPass(open));
    EXPECT_TRUE(partsOf(open).boxes.empty());
    EXPECT_TRUE(partsOf(turnedInsideOut(scene::makeSphere(0.5, 32))).boxes.empty());
    scene::Mesh oneTurned = scene::makeBox({1, 1, 1});
    std::swap(oneTurned.triangles[3].y, oneTurned.triangles[3].z);
    EXPECT_TRUE(partsOf(oneTurned).boxes.empty());
}

TEST(OutwardParts, PiecesAreToldApart) {
    const scene::Mesh box = scene::makeBox({2, 2, 2});
    const scene::Mesh hollow = together(box, turnedInsideOut(scene::makeBox({1, 1, 1})), {0, 0, 0});
    const OutwardParts parts = partsOf(hollow);
    EXPECT_EQ(parts.boxes.size(), 1u); // the inner wall goes the general way
    EXPECT_EQ(std::ranges::count(parts.partOfTriangle, OutwardParts::kNone), 12);
    EXPECT_EQ(partsOf(together(box, box, {1, 0.5, 0.25})).boxes.size(), 2u); // they may well intersect
}

// Closed, consistently wound and of positive volume: not enough. Behind the small lobe the light meets back faces alone.
TEST(OutwardParts, ASurfaceThatIntersectsItselfDoesNotPassThoughItsVolumeIsPositive) {
    const scene::Mesh mesh = bowTie();
    EXPECT_TRUE(scene::reportMesh(mesh, scene::buildTopology(mesh)).isClosed());
    EXPECT_GT(signedVolume(mesh), 0);
    EXPECT_TRUE(partsOf(mesh).boxes.empty());
}

TEST(OutwardParts, ALightWithinTheBoxKeepsBackFaces) {
    const scene::Mesh mesh = scene::makeBox({2, 2, 2});
    const OutwardParts parts = partsOf(mesh);
    const auto left = [&](const dvec4& light) {
        std::vector<std::int8_t> facing(mesh.triangles.size(), -1);
        scene::keepFrontFacesAlone(facing, parts, light);
        return std::ranges::count(facing, -1);
    };
    EXPECT_EQ(left({0, 0.5, 0, 1}), 12);
    EXPECT_EQ(left({0, 1, 0, 1}), 12) << "on the surface is not outside";
    EXPECT_EQ(left({0, 1.25, 0, 1}), 0);
    EXPECT_EQ(left({0, 0.5, 0, 0}), 0) << "a direction is outside everything";
}

} // namespace
} // namespace shadowlab
