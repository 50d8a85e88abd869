// The construction of a volume, without a graphics card: silhouettes by signed edge counts, and closed results.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/shadow_volume/count/volume.h"
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
    Built built;
    shadow_volume::buildVolume(*object.mesh, shadow_volume::edgeTable(topology), facing, built.silhouette,
                               built.volume);
    return built;
}

/// The same, slowly and plainly: every edge asks all its triangles, every list grows by itself.
Built buildPlainly(const scene::Mesh& mesh, const scene::MeshTopology& topology,
                   const std::vector<std::int8_t>& facing) {
    Built built;
    for (const scene::Edge& edge : topology.edges) {
        int sum = 0;
        for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u)
            sum += topology.uses[u].direction * facing[topology.uses[u].triangle];
        const auto times = static_cast<std::uint32_t>(std::abs(sum));
        if (sum > 0) built.silhouette.push_back({edge.a, edge.b, times, edge.useCount});
        if (sum < 0) built.silhouette.push_back({edge.b, edge.a, times, edge.useCount});
    }
    const auto n = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    const auto add = [](std::vector<std::uint32_t>& list, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        list.insert(list.end(), {i, j, k});
    };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = std::array{mesh.triangles[t].x, mesh.triangles[t].y, mesh.triangles[t].z};
        if (facing[t] > 0) add(built.volume.topCap, a, b, c), add(built.volume.bottomCap, a + n, c + n, b + n);
        if (facing[t] < 0) add(built.volume.topCapReversed, a, b, c), add(built.volume.bottomCap, a + n, b + n, c + n);
    }
    for (const SilhouetteEdge& edge : built.silhouette)
        for (std::uint32_t i = 0; i < edge.multiplicity; ++i)
            add(built.volume.sides, edge.b, edge.a, edge.a + n);
    for (const SilhouetteEdge& edge : built.silhouette)
        for (std::uint32_t i = 0; i < edge.multiplicity; ++i)
            add(built.volume.sides, edge.b, edge.a + n, edge.b + n);
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
    const auto edges = shadow_volume::edgeTable(topology);
    Built first, second;
    shadow_volume::buildVolume(*torus.mesh, edges, facing, first.silhouette, first.volume);
    facing[10] = static_cast<std::int8_t>(-facing[10]);
    shadow_volume::buildVolume(*torus.mesh, edges, facing, second.silhouette, second.volume);
    EXPECT_EQ(unmatchedEdges(*torus.mesh, second.volume), 0);
    second.volume.sides = first.volume.sides;
    EXPECT_GT(unmatchedEdges(*torus.mesh, second.volume), 0);
}

// The one-pass construction and the direct one give the same indices in the same order, whatever the memory held before.
TEST(Volume, IsThatOfThePlainConstruction) {
    Built kept;
    std::size_t silhouettes = 0, manyTimes = 0, boundaries = 0, multiples = 0, reversed = 0, edgeOn = 0;
    const auto compare = [&](const scene::Object& object, const scene::Light& light) {
        const auto topology = scene::buildTopology(*object.mesh);
        const auto edges = shadow_volume::edgeTable(topology);
        auto facing = scene::facingSigns(object, light);
        for (const bool frontAlone : {false, true}) {
            if (frontAlone) std::ranges::replace(facing, std::int8_t{-1}, std::int8_t{0});
            const Built plain = buildPlainly(*object.mesh, topology, facing);
            shadow_volume::buildVolume(*object.mesh, edges, facing, kept.silhouette, kept.volume);
            ASSERT_EQ(kept.silhouette, plain.silhouette);
            ASSERT_EQ(kept.volume.topCap, plain.volume.topCap);
            ASSERT_EQ(kept.volume.topCapReversed, plain.volume.topCapReversed);
            ASSERT_EQ(kept.volume.sides, plain.volume.sides);
            ASSERT_EQ(kept.volume.bottomCap, plain.volume.bottomCap);
            for (const SilhouetteEdge& edge : plain.silhouette) {
                ++silhouettes;
                manyTimes += edge.multiplicity > 2;
                boundaries += edge.triangles == 1;
                multiples += edge.triangles > 2;
            }
            reversed += plain.volume.topCapReversed.size() / 3;
            edgeOn += static_cast<std::size_t>(std::ranges::count(facing, 0));
        }
    };
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 20; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, i, directional);
                for (const scene::Object& object : scene.objects)
                    compare(object, scene.lights[0]);
            }
    scene::Scene shapes;
    testing::addObject(shapes, scene::makeTorus(1, 0.4, {60, 30}));
    testing::addObject(shapes, scene::makeSphere(1, 40));
    testing::addObject(shapes, scene::makeBox({1, 1, 1}));
    for (const scene::Object& object : shapes.objects)
        for (const scene::Light& light :
             {testing::pointLight({1, 3, 2}), testing::pointLight({1, 0, 0}), testing::directionalLight({0, -1, 0})})
            compare(object, light);
    EXPECT_GT(silhouettes, 10000u);
    EXPECT_GT(manyTimes, 50u);
    EXPECT_GT(boundaries, 1000u);
    EXPECT_GT(multiples, 100u);
    EXPECT_GT(reversed, 1000u);
    EXPECT_GT(edgeOn, 1000u);
}

} // namespace
} // namespace shadowlab
