// The construction of a volume, without a graphics card: silhouettes by signed edge counts, and closed results.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "techniques/foundation/scene/facing.h"
#include "techniques/foundation/scene/shapes.h"
#include "techniques/shadow_volume/volume.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using shadow_volume::SilhouetteEdge;
using shadow_volume::Volume;

struct Built {
    std::vector<SilhouetteEdge> silhouette;
    Volume volume;
};

Built build(const scene::Object& object, const scene::Light& light) {
    const auto topology = scene::buildTopology(*object.mesh);
    const auto facing = scene::facingSigns(object, light);
    Built built{shadow_volume::silhouetteEdges(topology, facing), {}};
    built.volume = shadow_volume::buildVolume(*object.mesh, facing, built.silhouette);
    return built;
}

/// How often each directed edge is left over once opposite ones have cancelled, with vertices named by position:
/// nothing, for a surface without boundary.
int unmatchedEdges(const scene::Mesh& mesh, const Volume& volume) {
    const auto n = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    using Key = std::array<float, 4>;
    const auto key = [&](std::uint32_t index) -> Key {
        const vec3 p = mesh.positionsMesh[index % n];
        return {p.x, p.y, p.z, index >= n ? 1.0f : 0.0f};
    };
    std::map<std::pair<Key, Key>, int> count;
    const auto add = [&](const std::vector<std::uint32_t>& list, bool reversed) {
        for (std::size_t i = 0; i < list.size(); i += 3)
            for (std::size_t c = 0; c < 3; ++c) {
                Key from = key(list[i + c]), to = key(list[i + (c + 1) % 3]);
                if (reversed) std::swap(from, to);
                if (from == to) continue;
                from < to ? ++count[{from, to}] : --count[{to, from}];
            }
    };
    add(volume.topCap, false);
    add(volume.topCapReversed, true);
    add(volume.sides, false);
    add(volume.bottomCap, false);
    int unmatched = 0;
    for (const auto& [edge, sum] : count)
        unmatched += sum != 0;
    return unmatched;
}

TEST(Volume, ABoxLitFromACornerHasSixSilhouetteEdges) {
    scene::Scene scene;
    const scene::Object& box = testing::addObject(scene, scene::makeBox({1, 1, 1}));
    const Built built = build(box, testing::directionalLight({-1, -1, -1}));
    EXPECT_EQ(built.silhouette.size(), 6u);
    for (const SilhouetteEdge& edge : built.silhouette)
        EXPECT_EQ(edge.multiplicity, 2u); // front and back both count
    EXPECT_EQ(built.volume.topCap.size(), 6u * 3);
    EXPECT_EQ(built.volume.topCapReversed.size(), 6u * 3);
    EXPECT_EQ(built.volume.sides.size(), 24u * 3); // two triangles for each edge, each twice
    EXPECT_EQ(built.volume.bottomCap.size(), 12u * 3);
}

TEST(Volume, ABoxLitFromStraightAboveHasFour) {
    scene::Scene scene;
    const scene::Object& box = testing::addObject(scene, scene::makeBox({1, 1, 1}));
    const Built built = build(box, testing::directionalLight({0, -1, 0}));
    // The four sides are edge-on: N.L = 0, they are left out and the silhouette is both the upper and the lower square.
    EXPECT_EQ(built.volume.topCap.size(), 2u * 3);
    EXPECT_EQ(built.silhouette.size(), 8u);
    EXPECT_EQ(unmatchedEdges(*box.mesh, built.volume), 0);
}

TEST(Volume, ASheetHasItsBoundaryForSilhouette) {
    scene::Scene scene;
    const scene::Object& sheet = testing::addObject(scene, scene::makeQuad({2, 2}));
    for (const double height : {3.0, -3.0}) { // from either side
        const Built built = build(sheet, testing::pointLight({0.25, height, 0.5}));
        EXPECT_EQ(built.silhouette.size(), 4u);
        for (const SilhouetteEdge& edge : built.silhouette)
            EXPECT_EQ(edge.triangles, 1u);
        EXPECT_EQ(built.volume.sides.size(), 4u * 6);
        EXPECT_EQ(built.volume.bottomCap.size(), 2u * 3);
        EXPECT_EQ(unmatchedEdges(*sheet.mesh, built.volume), 0);
    }
}

TEST(Volume, ThreeSheetsOnOneEdgeExtrudeItOnceOrThrice) {
    scene::Scene scene;
    const dvec3 a(0, 1, 0), b(0, 1, 1);
    const scene::Object& fan =
        testing::addObject(scene, testing::triangleSoup({a, b, {1, 1, 0}, a, b, {1, 1.25, 0}, a, b, {1, 1.5, 0}}));
    const Built built = build(fan, testing::pointLight({0.5, 5, 0.5}));
    const auto shared = std::ranges::find(built.silhouette, 3u, &SilhouetteEdge::triangles);
    ASSERT_NE(shared, built.silhouette.end());
    EXPECT_EQ(shared->multiplicity, 3u) << "all three lie to one side of it";
    EXPECT_EQ(unmatchedEdges(*fan.mesh, built.volume), 0);
}

// The boundary of a sum of triangles is a cycle, so the volume closes whatever the triangles are.
TEST(Volume, IsClosedForEveryHardScene) {
    int volumes = 0;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 20; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, i, directional);
                for (const scene::Object& object : scene.objects) {
                    const Built built = build(object, scene.lights[0]);
                    EXPECT_EQ(unmatchedEdges(*object.mesh, built.volume), 0) << toText(hardClass) << " " << i;
                    ++volumes;
                }
            }
    EXPECT_GE(volumes, 400);
}

// One sign changed after the sides were made opens the volume: the check above can fail.
TEST(Volume, ASecondOpinionOnAFacingSignOpensIt) {
    scene::Scene scene;
    const scene::Object& torus = testing::addObject(scene, scene::makeTorus(1, 0.4, {16, 8}));
    const auto light = testing::pointLight({1, 3, 2});
    const auto topology = scene::buildTopology(*torus.mesh);
    auto facing = scene::facingSigns(torus, light);
    const auto silhouette = shadow_volume::silhouetteEdges(topology, facing);
    facing[10] = static_cast<std::int8_t>(-facing[10]);
    const Volume volume = shadow_volume::buildVolume(*torus.mesh, facing, silhouette);
    EXPECT_GT(unmatchedEdges(*torus.mesh, volume), 0);
}

} // namespace
} // namespace shadowlab
