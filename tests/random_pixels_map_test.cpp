// Depths of shadow maps for pixels taken by chance over all built-in scenes: of the point, by the matrix that the probe tells, and of
// the texel, by the line through its centre and a plain loop over all triangles in double.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <iostream>

#include "techniques/probed/map_probe.h"
#include "tests/support/random_pixels.h"

namespace shadowlab {
namespace {

using testing::AskedPixel;
using testing::Deviation;
using testing::WorldTriangle;

double depthOf(const MapProbe& map, const dvec3& placeWorld) {
    const dvec4 clip = map.lightClipFromLightRelative * dvec4(placeWorld - map.originWorld, 1.0);
    return clip.z / clip.w * 0.5 + 0.5;
}

TEST(RandomPixelsMapTest, DepthsOfPointAndTexelAreThoseOfTheTriangles) {
    Deviation point, texel, place;
    int compared = 0, filled = 0, empty = 0, doubtful = 0, own = 0, outside = 0;
    for (const char* bias : {"none", "receiver-plane"})
        testing::forRandomPixels(
            {.technique = "shadow-map",
             .values = {{"filter", "hard"}, {"bias-mode", bias}, {"resolution", "512"}, {"cull", "false"}},
             .pixels = 40,
             .seed = 53},
            [&](const AskedPixel& asked) {
                if (!asked.probe.find<MapProbe>()) return;
                const MapProbe& map = *asked.probe.find<MapProbe>();
                ++compared;
                const dvec4 clip = map.lightClipFromLightRelative * dvec4(asked.pointWorld - map.originWorld, 1.0);
                const dvec3 str = dvec3(clip) / clip.w * 0.5 + 0.5;
                for (int axis = 0; axis < 3; ++axis)
                    point.add(map.str[axis] - str[axis]);
                const bool hasBias = bias != std::string("none");
                // The line through the texel's centre, from the near side of the map; in front of it things are kept as on it.
                const dmat4 back = glm::inverse(map.lightClipFromLightRelative);
                const dvec2 ndc = (dvec2(map.texel) + 0.5) / static_cast<double>(map.resolution) * 2.0 - 1.0;
                const auto world = [&](double z) {
                    const dvec4 p = back * dvec4(ndc, z, 1.0);
                    return map.originWorld + dvec3(p) / p.w;
                };
                if (!hasBias) {
                    EXPECT_EQ(map.texel, ivec2(glm::floor(dvec2(str) * static_cast<double>(map.resolution))));
                }
                if (glm::any(glm::lessThan(map.texel, ivec2(0))) ||
                    glm::any(glm::greaterThanEqual(map.texel, ivec2(map.resolution)))) {
                    ++outside; // and nothing is compared
                    return;
                }
                if (!hasBias) place.add(map.compared - std::min(str.z, 1.0)); // never beyond the map's range
                const dvec3 near = world(-1), far = world(1), way = far - near;
                const bool isParallel = asked.lightWorld().w == 0;
                const double least = isParallel ? -1e6 : -glm::length(near - map.originWorld) / glm::length(way);
                const auto first = firstOn(asked.triangles, near, way, least, [&](const WorldTriangle& one) {
                    return asked.scene.objects[one.object].castsShadow;
                });
                if (first && !first->isClear) {
                    ++doubtful;
                    return;
                }
                // What lies beyond the far side is not drawn.
                if (!first || first->along > 1) {
                    EXPECT_GE(map.first, 1) << asked.where();
                    ++empty;
                    return;
                }
                ++filled;
                own += first->index == asked.seen;
                const double expected = glm::clamp(depthOf(map, near + first->along * way), 0.0, 1.0);
                texel.add(map.first - expected);
                EXPECT_NEAR(map.first, expected, 1e-9) << asked.where();
            },
            false);
    std::cout << compared << " points, off by " << point.largest << " at most; " << filled << " texels filled (" << own
              << " by the point's own triangle), off by " << texel.largest << "; " << empty << " empty, " << doubtful
              << " at an edge, " << outside << " outside the map; compared without bias, off by " << place.largest
              << "\n";
    EXPECT_GT(compared, 250);
    EXPECT_GT(filled, 200);
    EXPECT_GT(own, 30);
    EXPECT_LT(doubtful, filled / 5);
    EXPECT_LT(point.largest, 1e-9);
    EXPECT_LT(place.largest, 1e-9);
}

} // namespace
} // namespace shadowlab
