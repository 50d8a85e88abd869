// The report on meshes made by hand, whose numbers can be counted, and on shapes, whose numbers follow from Euler.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::scene {
namespace {

Mesh meshOf(std::vector<vec3> positions, std::vector<uvec3> triangles) {
    Mesh mesh;
    mesh.positionsMesh = std::move(positions);
    mesh.triangles = std::move(triangles);
    return mesh;
}

MeshReport report(const Mesh& mesh) { return reportMesh(mesh, buildTopology(mesh)); }

const std::vector<vec3> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

TEST(MeshReport, NothingAtAll) {
    const MeshReport none = report({});
    EXPECT_EQ(none.triangles + none.vertices + none.weldedVertices + none.edges + none.components, 0u);
}

TEST(MeshReport, ClosedShapesObeyEuler) {
    for (const auto& [mesh, euler] :
         {std::pair{makeBox(dvec3(1.0)), 2}, {makeSphere(1.0, 24), 2}, {makeTorus(1.0, 0.25, {24, 12}), 0}}) {
        const MeshReport closed = report(mesh);
        EXPECT_TRUE(closed.isClosed());
        EXPECT_EQ(closed.components, 1u);
        EXPECT_EQ(closed.duplicateTriangles, 0u);
        EXPECT_EQ(closed.vertices, mesh.positionsMesh.size());
        EXPECT_EQ(static_cast<int>(closed.weldedVertices + closed.triangles) - static_cast<int>(closed.edges), euler);
    }
    EXPECT_EQ(report(makeBox(dvec3(1.0))).vertices, 24u);
    EXPECT_EQ(report(makeBox(dvec3(1.0))).weldedVertices, 8u);
}

TEST(MeshReport, NormalsChangeOnlyTheVerticesOfTheBuffers) {
    const Mesh sphere = makeSphere(1.0, 16);
    const MeshReport smooth = report(sphere), flat = report(withNormals(sphere, NormalMode::flat));
    EXPECT_GT(flat.vertices, smooth.vertices);
    EXPECT_EQ(flat.weldedVertices, smooth.weldedVertices);
    EXPECT_EQ(flat.edges, smooth.edges);
    EXPECT_EQ(flat.components, smooth.components);
}

TEST(MeshReport, EveryOrderOfTheSameThreeCornersIsADuplicate) {
    for (const uvec3 again :
         {uvec3(0, 1, 2), uvec3(1, 2, 0), uvec3(2, 0, 1), uvec3(0, 2, 1), uvec3(2, 1, 0), uvec3(1, 0, 2)}) {
        const MeshReport twice = report(meshOf(kCorners, {{0, 1, 2}, {0, 1, 3}, again}));
        EXPECT_EQ(twice.duplicateTriangles, 1u);
        EXPECT_EQ(twice.multipleEdges, 1u);
        EXPECT_EQ(twice.boundaryEdges, 2u);
    }
    EXPECT_EQ(report(meshOf(kCorners, {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {3, 1, 2}, {2, 3, 1}})).duplicateTriangles, 3u);
    EXPECT_EQ(report(meshOf(kCorners, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})).duplicateTriangles, 0u);
}

TEST(MeshReport, CornersAtOnePlaceAreOneCorner) {
    const std::vector<vec3> twice = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    const MeshReport doubled = report(meshOf(twice, {{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(doubled.duplicateTriangles, 1u);
    EXPECT_EQ(doubled.vertices, 6u);
    EXPECT_EQ(doubled.weldedVertices, 3u);
    EXPECT_EQ(doubled.inconsistentEdges, 3u);
    EXPECT_EQ(doubled.components, 1u);
}

TEST(MeshReport, PiecesHangTogetherByEdges) {
    EXPECT_EQ(report(meshOf(kCorners, {{0, 1, 2}, {0, 3, 4}})).components, 2u); // they touch in a point
    EXPECT_EQ(report(meshOf(kCorners, {{0, 1, 2}, {0, 3, 4}, {0, 2, 3}})).components, 1u);
    // A strip whose triangles come in an order that joins its pieces late.
    std::vector<vec3> positions;
    std::vector<uvec3> strip;
    for (std::uint32_t i = 0; i < 40; ++i)
        positions.emplace_back(static_cast<float>(i / 2), static_cast<float>(i % 2), 0.0f);
    for (std::uint32_t i = 0; i < 38; ++i)
        if (i != 20) strip.push_back(uvec3(0, 1, 2) + uvec3((i * 7) % 38));
    EXPECT_EQ(report(meshOf(positions, strip)).components, 2u); // (20 * 7) % 38 is left out
}

TEST(MeshReport, TrianglesWithoutSidesAreNoDuplicates) {
    const MeshReport odd = report(meshOf(kCorners, {{0, 1, 2}, {0, 0, 1}, {0, 1, 0}, {3, 3, 3}}));
    EXPECT_EQ(odd.triangles, 4u);
    EXPECT_EQ(odd.duplicateTriangles, 0u);
    EXPECT_EQ(odd.weldedVertices, 3u);
}

TEST(MeshReport, TellsWhatWasLeftOut) {
    Mesh mesh = meshOf(kCorners, {{0, 1, 2}});
    mesh.droppedTriangles = 7;
    EXPECT_EQ(report(mesh).droppedTriangles, 7u);
}

} // namespace
} // namespace shadowlab::scene
