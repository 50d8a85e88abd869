// Which faces of a mesh are flat, and what bounds them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/scene/shapes.h"
#include "techniques/planar/projection.h"
#include "tests/support/scenes.h"

namespace shadowlab::planar {
namespace {

double outlineLength(const FlatFace& face) {
    double length = 0;
    for (const auto& [from, to] : face.outlineMesh)
        length += glm::length(to - from);
    return length;
}

TEST(FlatFaces, AQuadIsOneAndABoxHasSix) {
    const std::vector<FlatFace> quad = flatFaces(scene::makeQuad({4, 2})).faces;
    ASSERT_EQ(quad.size(), 1u);
    EXPECT_EQ(quad[0].outlineMesh.size(), 4u) << "the diagonal does not bound it";
    EXPECT_DOUBLE_EQ(outlineLength(quad[0]), 12);
    EXPECT_EQ(quad[0].normalMesh, dvec3(0, 1, 0));
    EXPECT_NEAR(glm::length(quad[0].frameMesh[2] - quad[0].frameMesh[0]), std::sqrt(20.0), 1e-12);

    const std::vector<FlatFace> box = flatFaces(scene::makeBox({1, 2, 3})).faces;
    ASSERT_EQ(box.size(), 6u);
    for (const FlatFace& face : box) {
        EXPECT_EQ(face.outlineMesh.size(), 4u);
        EXPECT_TRUE(contains(face.runs, face.runs[0].first + 1));
        EXPECT_FALSE(contains(face.runs, face.runs[0].first + 2));
    }
}

TEST(FlatFaces, WhatIsCurvedHasNone) {
    EXPECT_TRUE(flatFaces(scene::makeSphere(1, 8)).faces.empty()) << "shaded smooth, so it is meant to be round";
    EXPECT_TRUE(flatFaces(scene::makeTorus(1, 0.3, {32, 16})).faces.empty());
}

// Two triangles of one edge that bend by a little less, and a little more, than floats can tell.
TEST(FlatFaces, ABendSeparates) {
    const auto bent = [](double by) {
        return testing::triangleSoup({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {1, 0, 0}, {1, by, -1}, {0, 0, -1}});
    };
    EXPECT_EQ(flatFaces(bent(1e-8)).faces.size(), 1u);
    EXPECT_EQ(flatFaces(bent(1e-5)).faces.size(), 2u);
}

// The matrix of the lecture's figure, by hand: light at height 4, a point at height 1.
TEST(Projection, TheShadowLiesOnTheLineAndInThePlane) {
    const auto projection = projectOnto({0, 1, 0, 0}, {0, 4, 0, 1});
    ASSERT_TRUE(projection);
    const dvec4 shadow = projection->flattenedFromView * dvec4(3, 1, -6, 1);
    EXPECT_DOUBLE_EQ(shadow.w, 0.75);
    EXPECT_NEAR(shadow.x / shadow.w, 4, 1e-12);
    EXPECT_NEAR(shadow.y, 0, 1e-12);
    EXPECT_NEAR(shadow.z / shadow.w, -8, 1e-12);
    // At the light's height it is at infinity, beyond on the other side.
    EXPECT_EQ((projection->flattenedFromView * dvec4(3, 4, 0, 1)).w, 0);
    EXPECT_LT((projection->flattenedFromView * dvec4(3, 5, 0, 1)).w, 0);
}

TEST(Projection, TheSunHasNoHeight) {
    const auto projection = projectOnto({0, 1, 0, 2}, {0.6, 0.8, 0, 0});
    ASSERT_TRUE(projection);
    const dvec4 shadow = projection->flattenedFromView * dvec4(0, 2, 5, 1);
    EXPECT_DOUBLE_EQ(shadow.w, 1);
    EXPECT_NEAR(shadow.x, -3, 1e-12);
    EXPECT_NEAR(shadow.y, -2, 1e-12);
    EXPECT_NEAR(shadow.z, 5, 1e-12);
}

TEST(Projection, ThePlaneIsTurnedToTheLight) {
    const auto below = projectOnto({0, 1, 0, 0}, {0, -4, 0, 1});
    ASSERT_TRUE(below);
    EXPECT_EQ(below->planeView.y, -1);
    EXPECT_EQ(below->lightHeight, 4);
    EXPECT_FALSE(projectOnto({0, 1, 0, 0}, {3, 0, 0, 1})) << "in the plane it does not shine on it";
}

} // namespace
} // namespace shadowlab::planar
