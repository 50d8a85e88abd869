// Triangulation: right area, right orientation, no triangle outside, convex or not.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/polygon_triangulation.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace shadowlab::scene {
namespace {

using Polygon = std::vector<dvec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles split(const Polygon& polygon) {
    Triangles triangles;
    triangulate(polygon, triangles);
    return triangles;
}

/// Every triangle turns like the polygon (z up) and they add up to its area: then none overlap and none lies outside.
void expectExact(const Polygon& polygon, double area) {
    const Triangles triangles = split(polygon);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    double sum = 0.0;
    for (const auto& t : triangles) {
        const double z = glm::cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]).z;
        EXPECT_GT(z, 0.0);
        sum += 0.5 * z;
    }
    EXPECT_NEAR(sum, area, 1e-12 * area);
}

TEST(Triangulate, ConvexQuadAlongItsFirstDiagonal) {
    EXPECT_EQ(split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, ConcaveQuadAlongTheDiagonalInside) {
    const Polygon dart{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}; // the third corner points inward
    for (int shift = 0; shift < 4; ++shift) {
        Polygon turned = dart;
        std::rotate(turned.begin(), turned.begin() + shift, turned.end());
        expectExact(turned, 4.0);
    }
}

TEST(Triangulate, ConcavePentagonAndStar) {
    expectExact({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}}, 10.0);
    Polygon star;
    for (int i = 0; i < 10; ++i) {
        const double radius = i % 2 ? 1.0 : 3.0, angle = 2.0 * 3.14159265358979 * i / 10.0;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
    double area = 0.0;
    for (int i = 0; i < 10; ++i)
        area += 0.5 * glm::cross(star[i], star[(i + 1) % 10]).z;
    expectExact(star, area);
}

TEST(Triangulate, CornersOnStraightEdgesMakeNoTriangleWithoutArea) {
    expectExact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 4.0);
    expectExact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, 2.0);
    expectExact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}, {0, 0.5, 0}}, 3.0);
}

TEST(Triangulate, KeepsTheOrientationOnEveryPlane) {
    // The same concave polygon, turned into each coordinate plane both ways.
    const std::vector<dvec2> dart{{0, 0}, {4, 0}, {1, 1}, {0, 4}, {-1, 1}};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool mirrored : {false, true}) {
            Polygon polygon;
            for (const dvec2& p : dart) {
                dvec3 q(0.25 * p.x, 0.25 * p.x, 0.25 * p.x); // a slanted plane
                q[(axis + 1) % 3] = mirrored ? p.y : p.x;
                q[(axis + 2) % 3] = mirrored ? p.x : p.y;
                polygon.push_back(q);
            }
            dvec3 newell(0.0);
            for (std::size_t i = 0; i < polygon.size(); ++i)
                newell += glm::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
            dvec3 sum(0.0);
            for (const auto& t : split(polygon)) {
                const dvec3 n = glm::cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]);
                EXPECT_GT(glm::dot(n, newell), 0.0);
                sum += n;
            }
            EXPECT_LT(glm::length(sum - newell), 1e-12);
        }
}

TEST(Triangulate, RandomStarShapedPolygonsAreCoveredExactly) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.2, 3.0);
    for (int round = 0; round < 200; ++round) {
        Polygon polygon;
        const int n = 5 + round % 40;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * 3.14159265358979 * i / n, r = radius(random);
            polygon.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
        }
        double area = 0.0;
        for (int i = 0; i < n; ++i)
            area += 0.5 * glm::cross(polygon[i], polygon[(i + 1) % n]).z;
        expectExact(polygon, area);
    }
}

TEST(Triangulate, DegeneratePolygonsStillGiveAllTriangles) {
    EXPECT_EQ(split({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}).size(), 3u);
    EXPECT_EQ(split(Polygon(6, dvec3(1.0))).size(), 4u);
    EXPECT_EQ(split({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}}).size(), 3u) << "crosses itself";
}

TEST(Triangulate, TenThousandCornersTakeNoNoticeableTime) {
    Polygon comb; // half the corners are concave: the slow case
    const int teeth = 5000;
    for (int i = 0; i < teeth; ++i) {
        comb.emplace_back(i, 0.0, 0.0);
        comb.emplace_back(i + 0.5, 0.001, 0.0);
    }
    comb.emplace_back(teeth, 100.0, 0.0);
    EXPECT_EQ(split(comb).size(), comb.size() - 2);
}

} // namespace
} // namespace shadowlab::scene
