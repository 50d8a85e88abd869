// Surfaces that meet themselves are never taken for simple ones, and ordinary ones are seen to be simple.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/simple_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"
#include "tests/support/trefoil.h"

namespace shadowlab {
namespace {

bool isSimple(const scene::Mesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    return scene::isCertainlySimple(mesh, scene::buildTopology(mesh), all);
}

TEST(SimpleSurface, OrdinaryOnesAre) {
    EXPECT_TRUE(isSimple(scene::makeBox({1, 2, 3})));
    EXPECT_TRUE(isSimple(scene::makeSphere(0.5, 48)));
    EXPECT_TRUE(isSimple(scene::makeTorus(1, 0.4, {48, 24})));
    EXPECT_TRUE(isSimple(testing::trefoil(0.3, 180, 16)));
    EXPECT_TRUE(isSimple(scene::makeQuad({2, 3}))) << "neighbours in one plane";
}

TEST(SimpleSurface, ATubeTooThickForItsKnotIsNot) { EXPECT_FALSE(isSimple(testing::trefoil(0.9, 180, 16))); }

// One corner pushed through the opposite face, or to just before it.
TEST(SimpleSurface, ADentThatComesOutAgainIsNot) {
    const auto dented = [](double depth) {
        scene::Mesh mesh = scene::makeSphere(1, 24);
        const auto top = std::ranges::max_element(mesh.positionsMesh, {}, [](const vec3& p) { return p.y; });
        const vec3 at = *top;
        for (vec3& position : mesh.positionsMesh)
            if (position == at) position.y -= static_cast<float>(depth);
        return mesh;
    };
    EXPECT_TRUE(isSimple(dented(0.5)));
    EXPECT_TRUE(isSimple(dented(1.99)));
    EXPECT_FALSE(isSimple(dented(2.01)));
}

// It would take a grid of billions of cells, or millions of triangles in one of them: given up instead.
TEST(SimpleSurface, OneStrayVertexTakesNoTimeAndNoMemory) {
    for (const dvec3& astray : {dvec3(1e4, 1e4, 1e4), dvec3(1e9, 3, -1e9), dvec3(400, 0, 0)}) {
        scene::Mesh mesh = scene::makeSphere(1, 300);
        mesh.positionsMesh[mesh.positionsMesh.size() / 2] = vec3(astray);
        EXPECT_FALSE(isSimple(mesh));
    }
}

TEST(SimpleSurface, TrianglesOnTopOfEachOtherAreNot) {
    const std::vector<dvec3> sheet = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    EXPECT_TRUE(isSimple(testing::triangleSoup(sheet)));
    std::vector<dvec3> twice = sheet;
    twice.insert(twice.end(), {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
    EXPECT_FALSE(isSimple(testing::triangleSoup(twice))) << "the same three corners";
    std::vector<dvec3> folded = sheet;
    folded.insert(folded.end(), {{1, 0, 0}, {0, 0, 0}, {0.5, 0, 0.25}});
    EXPECT_FALSE(isSimple(testing::triangleSoup(folded))) << "folded flat along an edge";
    std::vector<dvec3> cornered = sheet;
    cornered.insert(cornered.end(), {{0, 0, 0}, {1, 0, 0.5}, {0.5, 0, 1}});
    EXPECT_FALSE(isSimple(testing::triangleSoup(cornered))) << "one corner in common, in one plane, one over the other";
    std::vector<dvec3> fan = sheet;
    fan.insert(fan.end(), {{0, 0, 0}, {-1, 0, -0.5}, {-0.5, 0, -1}});
    EXPECT_TRUE(isSimple(testing::triangleSoup(fan))) << "one corner in common, beside each other";
}

/// Do they cross? By the signs of volumes, with coordinates so small that those are exact.
bool cross(const std::array<dvec3, 3>& a, const std::array<dvec3, 3>& b) {
    const auto side = [](const dvec3& p, const dvec3& q, const dvec3& r, const dvec3& s) {
        const double volume = glm::dot(glm::cross(q - p, r - p), s - p);
        return volume > 0 ? 1 : volume < 0 ? -1 : 0;
    };
    const auto pierces = [&](const dvec3& from, const dvec3& to, const std::array<dvec3, 3>& t) {
        const int before = side(t[0], t[1], t[2], from), behind = side(t[0], t[1], t[2], to);
        if (before * behind >= 0) return false;
        const int around[3] = {side(from, to, t[0], t[1]), side(from, to, t[1], t[2]), side(from, to, t[2], t[0])};
        return around[0] == around[1] && around[1] == around[2] && around[0] != 0;
    };
    for (std::size_t i = 0; i < 3; ++i)
        if (pierces(a[i], a[(i + 1) % 3], b) || pierces(b[i], b[(i + 1) % 3], a)) return true;
    return false;
}

TEST(SimpleSurface, PairsThatCrossAreNeverCertain) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> coordinate(-8, 8);
    const auto point = [&] { return dvec3(coordinate(random), coordinate(random), coordinate(random)); };
    int crossing = 0, certain = 0, undecided = 0;
    for (int i = 0; i < 20000; ++i) {
        std::array<dvec3, 3> a = {point(), point(), point()}, b = {point(), point(), point()};
        if (i % 3 == 1) b[0] = a[0];
        if (i % 3 == 2) b[0] = a[1], b[1] = a[0];
        const auto degenerate = [](const std::array<dvec3, 3>& t) {
            return glm::cross(t[1] - t[0], t[2] - t[0]) == dvec3(0);
        };
        if (degenerate(a) || degenerate(b)) continue;
        const bool simple = isSimple(testing::triangleSoup({a[0], a[1], a[2], b[0], b[1], b[2]}));
        if (cross(a, b)) {
            ++crossing;
            EXPECT_FALSE(simple) << "pair " << i;
        } else {
            ++(simple ? certain : undecided);
        }
    }
    EXPECT_GT(crossing, 500);
    EXPECT_GT(certain, 10000);
    EXPECT_LT(undecided, certain / 10) << "those that touch, and no more";
}

} // namespace
} // namespace shadowlab
