// Which faces of a mesh are flat, and what bounds them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
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

/// A prism of so many sides around y, two metres high and `radius` thick, shaded flat, with its lids.
scene::Mesh prism(int sides, double radius) {
    std::vector<dvec3> corners;
    const auto at = [&](int i, double y) {
        const double angle = 2 * M_PI * i / sides;
        return dvec3(radius * std::cos(angle), y, radius * std::sin(angle));
    };
    for (int i = 0; i < sides; ++i) {
        const dvec3 a = at(i, 0), b = at(i + 1, 0), c = at(i + 1, 2), d = at(i, 2);
        corners.insert(corners.end(), {a, c, b, a, d, c, dvec3(0, 2, 0), c, d, dvec3(0, 0, 0), a, b});
    }
    return testing::triangleSoup(corners);
}

// Sides that meet at 90 and 45 degrees are faces, at 15 they are a column's. The lids are faces of all.
TEST(FlatFaces, FacetsOfSomethingRoundAreNone) {
    EXPECT_EQ(flatFaces(prism(4, 0.05)).faces.size(), 6u);
    EXPECT_EQ(flatFaces(prism(8, 0.05)).faces.size(), 10u);
    const FlatFaces column = flatFaces(prism(24, 0.05));
    // As long as the mesh is, a side is large: what counts as a facet is small.
    EXPECT_EQ(column.faces.size(), 26u);
    const FlatFaces coin = flatFaces(prism(96, 4));
    EXPECT_EQ(coin.faces.size(), 98u) << "two metres high: a side is an eighth of ten";
    const FlatFaces flat = flatFaces(prism(96, 40));
    EXPECT_EQ(flat.faces.size(), 2u);
    EXPECT_NEAR(flat.facetArea, 96 * 2 * 2 * 40 * std::sin(M_PI / 96), 1e-3);
    EXPECT_NEAR(flat.area - flat.facetArea, 96 * 40 * 40 * std::sin(2 * M_PI / 96), 1e-2);
}

// A stair of twenty steps, each a twentieth of it: small, but with edges all around.
TEST(FlatFaces, TheStepsOfAStairAreFaces) {
    std::vector<dvec3> corners;
    for (int i = 0; i < 20; ++i) {
        const dvec3 a(0, i, -i), b(1, i, -i), up(0, 1, 0), in(0, 0, -1);
        corners.insert(corners.end(), {a, b, b + up, a, b + up, a + up}); // riser
        const dvec3 c = a + up, d = b + up;
        corners.insert(corners.end(), {c, d, d + in, c, d + in, c + in}); // tread
    }
    const FlatFaces stair = flatFaces(testing::triangleSoup(corners));
    EXPECT_EQ(stair.faces.size(), 40u);
    EXPECT_EQ(stair.facetArea + stair.smoothArea + stair.leftOverArea, 0);
    EXPECT_NEAR(stair.area, 40, 1e-9);
}

// Whatever the size of its mesh: a card of 5 cm in a house of a kilometre.
TEST(FlatFaces, ASmallThingOfALargeMeshIsOne) {
    const FlatFaces house = flatFaces(
        testing::triangleSoup({{0, 0, 0}, {1000, 0, 0}, {0, 0, -1000}, {3, 1, -3}, {3.05, 1, -3}, {3, 1, -3.05}}));
    EXPECT_EQ(house.faces.size(), 2u);
}

TEST(FlatFaces, WhatIsCurvedIsCounted) {
    const FlatFaces ball = flatFaces(scene::makeSphere(1, 64));
    EXPECT_TRUE(ball.faces.empty());
    EXPECT_EQ(ball.smoothArea, ball.area);
    EXPECT_NEAR(ball.area, 4 * M_PI, 0.05);
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
