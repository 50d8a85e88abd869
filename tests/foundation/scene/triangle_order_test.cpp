// Triangles in an order in which neighbours follow one another (techniques/foundation/scene/query/topology/triangle_order.h).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <random>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/foundation/scene/query/topology/triangle_order.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/scenes.h"

namespace shadowlab::scene {
namespace {

/// The same in any order, part by part.
Mesh shuffled(Mesh mesh) {
    std::mt19937 random(1);
    for (const MeshPart& part : mesh.parts) {
        const auto first = mesh.triangles.begin() + part.firstTriangle;
        std::shuffle(first, first + part.triangleCount, random);
    }
    return mesh;
}

double transformedPerTriangle(const Mesh& mesh) { return scene::transformedPerTriangle(weldedTriangles(mesh)); }

Mesh torusOfTwoParts() {
    Mesh torus = makeTorus(1, 0.3, {96, 48});
    const auto all = static_cast<std::uint32_t>(torus.triangles.size());
    torus.parts = {{"a", 0, all / 3, false}, {"b", all / 3, all - all / 3, false}};
    return torus;
}

/// Position and normal of each.
std::array<vec3, 6> cornersOf(const Mesh& mesh, std::size_t triangle) {
    std::array<vec3, 6> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.triangles[triangle][static_cast<int>(i)];
        corners[2 * i] = mesh.positionsMesh[vertex];
        corners[2 * i + 1] = mesh.normalsMesh[vertex];
    }
    return corners;
}

TEST(TriangleOrderTest, OneRowOfSquaresNeedsOneVertexForATriangle) {
    // Two more vertices for each square of a strip.
    std::vector<uvec3> triangles;
    for (std::uint32_t i = 0; i < 500; ++i) {
        triangles.emplace_back(2 * i, 2 * i + 2, 2 * i + 1);
        triangles.emplace_back(2 * i + 1, 2 * i + 2, 2 * i + 3);
    }
    EXPECT_DOUBLE_EQ(scene::transformedPerTriangle(triangles), 1.002);
}

TEST(TriangleOrderTest, AMeshInAnyOrderIsSortedWithinItsParts) {
    const Mesh before = shuffled(torusOfTwoParts());
    ASSERT_GT(transformedPerTriangle(before), 2.9);
    Mesh mesh = before;
    keepNeighboursTogether(mesh);
    EXPECT_LT(transformedPerTriangle(mesh), 0.95);
    ASSERT_EQ(mesh.fileOrder.size(), before.triangles.size());
    std::vector<int> uses(before.triangles.size(), 0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t place = mesh.fileOrder[i];
        ++uses[place];
        ASSERT_EQ(cornersOf(mesh, i), cornersOf(before, place));
        ASSERT_EQ(partOf(mesh, static_cast<std::uint32_t>(i)), partOf(before, place)) << i;
    }
    EXPECT_EQ(std::ranges::count(uses, 1), static_cast<std::ptrdiff_t>(uses.size()));
    std::uint32_t next = 0; // vertices are numbered as they are used
    for (const uvec3& corners : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            ASSERT_LE(corners[i], next);
            if (corners[i] == next) ++next;
        }
    EXPECT_EQ(next, mesh.positionsMesh.size());
}

TEST(TriangleOrderTest, PlacesInTheFileAreKeptThroughBoth) {
    Mesh before = shuffled(torusOfTwoParts());
    for (std::uint32_t i = 0; i < before.triangles.size(); ++i)
        before.fileOrder.push_back(static_cast<std::uint32_t>(before.triangles.size()) - 1 - i);
    Mesh mesh = before;
    keepNeighboursTogether(mesh);
    ASSERT_NE(mesh.triangles, before.triangles);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        ASSERT_EQ(cornersOf(mesh, i), cornersOf(before, before.triangles.size() - 1 - mesh.fileOrder[i]));
}

TEST(TriangleOrderTest, AGoodOrderAndASmallMeshAreLeftAsTheyAre) {
    const Mesh rows = torusOfTwoParts(), small = shuffled(makeTorus(1, 0.3, {24, 12}));
    EXPECT_LT(transformedPerTriangle(rows), 1.1);
    EXPECT_GT(transformedPerTriangle(small), 1.5);
    for (const Mesh& before : {rows, small}) {
        Mesh mesh = before;
        keepNeighboursTogether(mesh);
        EXPECT_EQ(mesh.triangles, before.triangles);
        EXPECT_TRUE(mesh.fileOrder.empty());
    }
}

TEST(TriangleOrderTest, AFileInAnyOrderIsSortedWhenItIsRead) {
    const Mesh before = shuffled(makeTorus(1, 0.3, {96, 48}));
    std::string text;
    for (const vec3& p : before.positionsMesh)
        text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const uvec3& t : before.triangles)
        text += "f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " + std::to_string(t.z + 1) + "\n";
    const TempFolder folder;
    const std::filesystem::path file = folder.write("mesh.obj", text);
    for (const NormalMode mode : {NormalMode::flat, NormalMode::smooth}) {
        const Mesh mesh = loadObj(file, mode, {}).mesh;
        ASSERT_EQ(mesh.triangles.size(), before.triangles.size());
        ASSERT_EQ(mesh.fileOrder.size(), before.triangles.size());
        EXPECT_LT(transformedPerTriangle(mesh), 0.95);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const vec3 here = mesh.positionsMesh[mesh.triangles[i].x];
            ASSERT_LT(glm::distance(here, before.positionsMesh[before.triangles[mesh.fileOrder[i]].x]), 2e-6f); // six digits
        }
    }
}

TEST(TriangleOrderTest, LooseTrianglesStayInTheirOrder) {
    std::vector<dvec3> corners;
    for (int i = 0; i < 5000; ++i)
        for (const dvec3& corner : {dvec3(0, 0, 0), dvec3(0.3, 0, 0), dvec3(0, 0.3, 0)})
            corners.push_back(corner + dvec3(i * 37 % 100, i * 61 % 71, 0));
    Mesh mesh = testing::triangleSoup(corners);
    EXPECT_GT(transformedPerTriangle(mesh), 2.9);
    keepNeighboursTogether(mesh);
    EXPECT_TRUE(mesh.fileOrder.empty());
}

} // namespace
} // namespace shadowlab::scene
