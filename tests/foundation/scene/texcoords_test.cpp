// Texture coordinates: as files have them, on the built-in shapes, and without any say in what hangs together.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

/// (u, v) at a point of a triangle's corners, found by its place.
vec2 texcoordAt(const Mesh& mesh, const uvec3& triangle, const vec3& position) {
    for (int corner = 0; corner < 3; ++corner)
        if (mesh.positionsMesh[triangle[corner]] == position) return mesh.texcoords[triangle[corner]];
    ADD_FAILURE() << "no such corner";
    return vec2(-1);
}

// Two triangles of a square that share an edge, with other texture coordinates on each side of it.
TEST(Texcoords, OfAFileComeThroughAndPartNoEdge) {
    const TempFolder folder;
    const ObjFile obj = loadObj(folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                                      "vt 0.25 0.5\nvt 1.5 -2 0\nvt 3\nvt 0.125 1\n"
                                                      "f 1/1 2/2 3/3\nf 1/4 3/-2 4/-1\n"),
                                NormalMode::file, {});
    const Mesh& mesh = obj.mesh;
    ASSERT_EQ(mesh.triangles.size(), 2u);
    ASSERT_EQ(mesh.texcoords.size(), mesh.positionsMesh.size());
    EXPECT_EQ(mesh.positionsMesh.size(), 5u) << "corner 1 twice, corner 3 once: its coordinates agree";
    EXPECT_TRUE(mesh.parts.at(0).hasTexcoords);
    EXPECT_EQ(texcoordAt(mesh, mesh.triangles[0], {0, 0, 0}), vec2(0.25f, 0.5f));
    EXPECT_EQ(texcoordAt(mesh, mesh.triangles[0], {1, 0, 0}), vec2(1.5f, -2.0f));
    EXPECT_EQ(texcoordAt(mesh, mesh.triangles[0], {1, 1, 0}), vec2(3.0f, 0.0f));
    EXPECT_EQ(texcoordAt(mesh, mesh.triangles[1], {0, 0, 0}), vec2(0.125f, 1.0f));
    const MeshReport report = reportMesh(mesh, buildTopology(mesh));
    EXPECT_EQ(report.edges, 5u);
    EXPECT_EQ(report.boundaryEdges, 4u);
    EXPECT_EQ(report.weldedVertices, 4u);
    for (const NormalMode mode : {NormalMode::flat, NormalMode::smooth}) {
        const Mesh other = withNormals(mesh, mode);
        EXPECT_EQ(texcoordAt(other, other.triangles[0], {0, 0, 0}), vec2(0.25f, 0.5f));
        EXPECT_EQ(texcoordAt(other, other.triangles[1], {0, 0, 0}), vec2(0.125f, 1.0f));
    }
}

TEST(Texcoords, MeshesWithoutAnyHaveNone) {
    const TempFolder folder;
    const ObjFile obj =
        loadObj(folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1 2 3\n"), NormalMode::file, {});
    EXPECT_TRUE(obj.mesh.texcoords.empty());
    EXPECT_FALSE(obj.mesh.parts.at(0).hasTexcoords);
    EXPECT_TRUE(withNormals(obj.mesh, NormalMode::smooth).texcoords.empty());
}

/// How (u, v) grows along a triangle's surface: two vectors, du/dp and dv/dp.
struct Growth {
    dvec3 u, v, normal;
};
Growth growthOn(const Mesh& mesh, const uvec3& t) {
    const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
    const dvec3 normal = glm::cross(b - a, c - a);
    const double area = glm::dot(normal, normal);
    const dvec3 perB = glm::cross(c - a, normal) / area, perC = glm::cross(normal, b - a) / area;
    const dvec2 ua(mesh.texcoords[t.x]), ub(mesh.texcoords[t.y]), uc(mesh.texcoords[t.z]);
    return {(ub.x - ua.x) * perB + (uc.x - ua.x) * perC, (ub.y - ua.y) * perB + (uc.y - ua.y) * perC,
            glm::normalize(normal)};
}

TEST(Texcoords, NoShapeShowsAnImageMirrored) {
    const std::pair<const char*, Mesh> shapes[] = {{"quad", makeQuad({2, 3})},
                                                   {"box", makeBox({1, 2, 3})},
                                                   {"sphere", makeSphere(1, 24)},
                                                   {"torus", makeTorus(1, 0.3, {24, 12})}};
    for (const auto& [name, mesh] : shapes) {
        ASSERT_EQ(mesh.texcoords.size(), mesh.positionsMesh.size()) << name;
        ASSERT_TRUE(mesh.parts.at(0).hasTexcoords) << name;
        for (const uvec3& triangle : mesh.triangles) {
            const Growth growth = growthOn(mesh, triangle);
            EXPECT_GT(glm::dot(glm::cross(growth.u, growth.v), growth.normal), 0) << name;
            // Nowhere the whole image squeezed into the last column before the seam.
            vec2 lower(9), upper(-9);
            for (int corner = 0; corner < 3; ++corner) {
                lower = glm::min(lower, mesh.texcoords[triangle[corner]]);
                upper = glm::max(upper, mesh.texcoords[triangle[corner]]);
            }
            const bool round = mesh.triangles.size() > 12;
            EXPECT_LE(upper.x - lower.x, round ? 1.01 / 24 : 1) << name;
            EXPECT_LE(upper.y - lower.y, round ? 1.01 / 12 : 1) << name;
        }
        EXPECT_EQ(isClosed(mesh), mesh.triangles.size() > 2) << name;
        const MeshReport report = reportMesh(mesh, buildTopology(mesh));
        EXPECT_EQ(report.boundaryEdges, mesh.triangles.size() > 2 ? 0u : 4u) << name;
    }
}

TEST(Texcoords, ImagesStandUprightOnSidesAndFillEachFace) {
    const Mesh box = makeBox({1, 2, 4});
    int sides = 0;
    for (const uvec3& triangle : box.triangles) {
        const Growth growth = growthOn(box, triangle);
        const bool side = growth.normal.y == 0;
        sides += side;
        if (side) {
            EXPECT_EQ(growth.v, dvec3(0, 0.5, 0));
        } else {
            EXPECT_EQ(growth.v, dvec3(0, 0, growth.normal.y > 0 ? -0.25 : 0.25));
        }
    }
    EXPECT_EQ(sides, 8);
    const Growth quad = growthOn(makeQuad({2, 5}), makeQuad({2, 5}).triangles[1]);
    EXPECT_LT(glm::length(quad.u - dvec3(0.5, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(quad.v - dvec3(0, 0, -0.2)), 1e-8);
}

} // namespace
} // namespace shadowlab::scene
