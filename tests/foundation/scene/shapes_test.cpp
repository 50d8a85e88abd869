// The built-in shapes: counts, closedness, orientation, and vertices exactly where they belong.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/shapes.h"

#include <cmath>
#include <numbers>
#include <set>

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

TEST(Shapes, QuadHasFourVerticesAndTwoTrianglesFacingUp) {
    const Mesh quad = makeQuad({4.0, 3.0});
    EXPECT_EQ(quad.positionsMesh.size(), 4u);
    EXPECT_EQ(quad.triangles.size(), 2u);
    EXPECT_EQ(areaVectorSum(quad), dvec3(0.0, 12.0, 0.0));
    for (const vec3& normal : quad.normalsMesh)
        EXPECT_EQ(normal, vec3(0.0f, 1.0f, 0.0f));
    for (const vec3& position : quad.positionsMesh)
        EXPECT_EQ(glm::abs(position), vec3(2.0f, 0.0f, 1.5f));
}

TEST(Shapes, BoxIsClosedOutwardAndExact) {
    const Mesh box = makeBox({1.0, 2.0, 3.0});
    EXPECT_EQ(box.triangles.size(), 12u);
    EXPECT_EQ(box.positionsMesh.size(), 24u) << "flat faces share no vertex";
    EXPECT_TRUE(isClosed(box));
    EXPECT_DOUBLE_EQ(volume(box), 6.0);
    for (const vec3& position : box.positionsMesh)
        EXPECT_EQ(glm::abs(position), vec3(0.5f, 1.0f, 1.5f));
}

TEST(Shapes, ShadingNormalsAgreeWithTheWinding) {
    for (const Mesh& mesh : {makeQuad({1, 1}), makeBox({1, 2, 3}), makeSphere(2.0, 9), makeTorus(1.0, 0.3, {7, 5}),
                             makeParallelogram({1, 0, 0}, {0, 1, 1})})
        for (const uvec3& t : mesh.triangles) {
            const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
            const dvec3 geometric = glm::cross(b - a, c - a);
            for (int i = 0; i < 3; ++i)
                EXPECT_GT(glm::dot(geometric, dvec3(mesh.normalsMesh[t[i]])), 0.0);
        }
}

TEST(Shapes, SpheresAreClosedAndOutwardForAnySegmentCount) {
    for (const int segments : {3, 4, 5, 8, 17, 64}) {
        const Mesh sphere = makeSphere(0.5, segments);
        const int bands = std::max(2, segments / 2);
        EXPECT_EQ(sphere.triangles.size(), static_cast<std::size_t>(2 * segments * (bands - 1))) << segments;
        EXPECT_TRUE(isClosed(sphere)) << segments;
        EXPECT_GT(volume(sphere), 0.0) << segments;
    }
}

TEST(Shapes, SphereVerticesLieOnTheSphereAndPolesAreExact) {
    const Mesh sphere = makeSphere(3.0, 64);
    std::set<std::array<float, 3>> places;
    bool north = false, south = false;
    for (const vec3& p : sphere.positionsMesh) {
        EXPECT_NEAR(glm::length(dvec3(p)), 3.0, 3.0 * 1e-7); // one rounding to float per coordinate
        places.insert({p.x, p.y, p.z});
        north |= p == vec3(0, 3, 0);
        south |= p == vec3(0, -3, 0);
    }
    EXPECT_TRUE(north && south);
    EXPECT_EQ(places.size(), 64u * 31u + 2u);
    // Twice only where the right end of an image meets its left one, and at the poles, once for each triangle.
    EXPECT_EQ(sphere.positionsMesh.size(), 65u * 31u + 2u * 64u);
    // The volume of the polyhedron comes close to the ball's from below.
    EXPECT_LT(volume(sphere), 36.0 * std::numbers::pi);
    EXPECT_GT(volume(sphere), 36.0 * std::numbers::pi * 0.99);
}

TEST(Shapes, SpheresAreExactlySymmetric) {
    const Mesh sphere = makeSphere(0.7, 64);
    std::set<std::array<float, 3>> places;
    for (const vec3& p : sphere.positionsMesh)
        places.insert({p.x, p.y, p.z});
    for (const vec3& p : sphere.positionsMesh) {
        EXPECT_TRUE(places.contains({-p.x + 0.0f, p.y, p.z}));
        EXPECT_TRUE(places.contains({p.x, -p.y + 0.0f, p.z}));
        EXPECT_TRUE(places.contains({p.z, p.y, p.x}));
    }
}

TEST(Shapes, TorusIsClosedOutwardAndOnTheTube) {
    const Mesh torus = makeTorus(1.0, 0.3, {64, 32});
    EXPECT_EQ(torus.positionsMesh.size(), 65u * 33u) << "its seams twice, for an image";
    EXPECT_EQ(torus.triangles.size(), 2u * 64u * 32u);
    EXPECT_TRUE(isClosed(torus));
    EXPECT_NEAR(volume(torus), 2.0 * std::numbers::pi * std::numbers::pi * 0.09, 0.02);
    for (const vec3& p : torus.positionsMesh)
        EXPECT_NEAR(std::hypot(std::hypot(double(p.x), double(p.z)) - 1.0, double(p.y)), 0.3, 1e-6);
    EXPECT_TRUE(isClosed(makeTorus(2.0, 1.0, {3, 3})));
}

TEST(Shapes, ParallelogramFacesTheCrossProductOfItsEdges) {
    const dvec3 u(2.0, 0.0, 0.0), v(0.5, 0.0, 1.0);
    const Mesh mesh = makeParallelogram(u, v);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(areaVectorSum(mesh), glm::cross(u, v));
    vec3 sum(0.0f);
    for (const vec3& p : mesh.positionsMesh)
        sum += p;
    EXPECT_EQ(sum, vec3(0.0f)) << "centred on the origin";
}

TEST(Shapes, NoNegativeZerosSoThatEqualPositionsHaveEqualBits) {
    for (const Mesh& mesh : {makeQuad({1, 1}), makeBox({1, 1, 1}), makeSphere(1.0, 8), makeTorus(1.0, 0.25, {8, 8})})
        for (const vec3& p : mesh.positionsMesh)
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_FALSE(p[axis] == 0.0f && std::signbit(p[axis]));
}

TEST(Normals, FlatGivesEachTriangleItsOwnNormalAndKeepsTheOrder) {
    const Mesh sphere = makeSphere(1.0, 8);
    const Mesh flat = withNormals(sphere, NormalMode::flat);
    ASSERT_EQ(flat.triangles.size(), sphere.triangles.size());
    for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
        dvec3 p[3];
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(flat.positionsMesh[flat.triangles[t][i]], sphere.positionsMesh[sphere.triangles[t][i]]);
            p[i] = dvec3(flat.positionsMesh[flat.triangles[t][i]]);
        }
        const dvec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(glm::length(dvec3(flat.normalsMesh[flat.triangles[t][i]]) - normal), 1e-6);
    }
    EXPECT_TRUE(isClosed(flat));
}

TEST(Normals, SmoothGivesEachPositionOneAreaWeightedNormal) {
    const Mesh smooth = withNormals(makeBox({2.0, 2.0, 2.0}), NormalMode::smooth);
    EXPECT_TRUE(isClosed(smooth));
    // Three corners of faces meet at a place; they keep their texture coordinates, so there are more vertices than places.
    std::map<std::array<float, 3>, vec3> normals;
    for (std::size_t i = 0; i < smooth.positionsMesh.size(); ++i) {
        const vec3 p = smooth.positionsMesh[i];
        EXPECT_EQ(normals.try_emplace({p.x, p.y, p.z}, smooth.normalsMesh[i]).first->second, smooth.normalsMesh[i]);
        EXPECT_NEAR(glm::length(smooth.normalsMesh[i]), 1.0f, 1e-6f);
        EXPECT_GT(glm::dot(smooth.normalsMesh[i], smooth.positionsMesh[i]), 0.0f);
    }
    EXPECT_EQ(normals.size(), 8u);
    Mesh bare = makeBox({2.0, 2.0, 2.0});
    bare.texcoords.clear();
    EXPECT_EQ(withNormals(bare, NormalMode::smooth).positionsMesh.size(), 8u)
        << "the 24 vertices of the box fall together";
    const Mesh unchanged = withNormals(smooth, NormalMode::file);
    EXPECT_EQ(unchanged.positionsMesh, smooth.positionsMesh);
}

} // namespace
} // namespace shadowlab::scene
