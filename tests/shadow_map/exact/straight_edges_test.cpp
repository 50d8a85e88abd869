// An edge of a caster in the maps around a light: six cameras keep it straight, a paraboloid bends it, and a rasteriser draws chords.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {
namespace {

constexpr int kEdges = 1000;

/// How far the middle of an edge is, in the map, from the line between the ends.
double bend(const dvec2& from, const dvec2& middle, const dvec2& to) {
    const dvec2 way = to - from, aside = middle - from;
    return std::abs(way.x * aside.y - way.y * aside.x) / glm::length(way);
}

struct Edge {
    dvec3 from, to;
};

/// Of that length, in front of a camera that looks down +x, 2 to 4 m away and within its 90 degrees.
Edge edgeBefore(std::mt19937& random, double length) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const dvec3 middle(3 + unit(random), 0.9 * unit(random), 0.9 * unit(random));
    const dvec3 way = glm::normalize(dvec3(unit(random), unit(random), 1.5));
    return {middle - 0.5 * length * way, middle + 0.5 * length * way};
}

TEST(StraightEdges, StayStraightInEachOfSixMaps) {
    std::mt19937 random(3);
    int compared = 0;
    for (const dvec3& forward :
         {dvec3(1, 0, 0), dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)}) {
        const dmat4 viewFromLight = lookAlong(forward), toFirst = glm::inverse(viewFromLight) * lookAlong({1, 0, 0});
        const dmat4 clipFromLight = perspectiveProjection({-1, -1}, {1, 1}, 0.1, 100) * viewFromLight;
        const auto inMap = [&](const dvec3& p) {
            const dvec4 clip = clipFromLight * toFirst * dvec4(p, 1);
            return dvec2(clip) / clip.w;
        };
        for (int i = 0; i < kEdges; ++i) {
            const Edge edge = edgeBefore(random, 1);
            // Some roundings of double, of numbers up to one.
            ASSERT_LE(bend(inMap(edge.from), inMap(0.5 * (edge.from + edge.to)), inMap(edge.to)), 1e-14);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 6 * kEdges);
}

/// Brabec, Annen and Seidel, "Shadow Mapping for Hemispherical and Omnidirectional Light Sources", 2002.
dvec2 onParaboloid(const dvec3& p) { return dvec2(p.y, p.z) / (glm::length(p) + p.x); }

TEST(StraightEdges, BendOnAParaboloidByTheSquareOfTheirLength) {
    double meanBefore = 0;
    for (const double length : {2.0, 1.0, 0.5, 0.25}) {
        std::mt19937 random(3);
        double sum = 0;
        for (int i = 0; i < kEdges; ++i) {
            const Edge edge = edgeBefore(random, length);
            sum += bend(onParaboloid(edge.from), onParaboloid(0.5 * (edge.from + edge.to)), onParaboloid(edge.to));
        }
        const double mean = sum / kEdges;
        if (length == 2.0) {
            EXPECT_GT(mean * 512, 0.5) << "texels of a map of 1024, which goes from -1 to 1";
        } else {
            EXPECT_NEAR(meanBefore / mean, 4, 0.5) << length; // what is left of higher powers
        }
        meanBefore = mean;
    }
}

} // namespace
} // namespace shadowlab::shadow_map
