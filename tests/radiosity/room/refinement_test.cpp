// Where patches are cut finer, and what is known of those that are not.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/refinement.h"

#include <gtest/gtest.h>

#include "techniques/radiosity/patches/contacts.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;
using Reason = Refinement::Reason;

Faces floorFaces() {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({4, 4}));
    return facesOf(scene, trace::worldTriangles(scene));
}

/// Light from above on all that is nearer to the middle than `radius`, in squares or in circles.
DirectLight spotOfLight(const std::vector<Patch>& patches, double radius) {
    DirectLight light;
    for (const Patch& patch : patches) {
        constexpr int kSide = 8;
        int lit = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const double s = (i % kSide + 0.5) / kSide, t = (i / kSide + 0.5) / kSide;
            const Polygon& q = patch.polygon;
            lit += glm::length(glm::mix(glm::mix(q[0], q[1], s), glm::mix(q[3], q[2], s), t)) < radius;
        }
        light.visible.push_back(static_cast<double>(lit) / (kSide * kSide));
        light.irradiance.emplace_back(light.visible.back());
    }
    return light;
}

/// What they reflect: all of the light.
std::vector<dvec3> white(const std::vector<Patch>& patches) { return std::vector<dvec3>(patches.size(), dvec3(1)); }

double areaOf(const std::vector<Patch>& patches) {
    double sum = 0;
    for (const Patch& patch : patches)
        sum += patch.area;
    return sum;
}

TEST(Refinement, OnlyTheEdgeOfAShadowIsCut) {
    const Faces faces = floorFaces();
    const std::vector<Patch> patches = cutIntoPatches(faces, 0.25);
    ASSERT_EQ(patches.size(), 256u);
    const PatchBorders borders = patchBorders(faces, patches);
    const DirectLight light = spotOfLight(patches, 1.3);
    const std::vector<Refinement> cuts =
        patchesToRefine(patches, borders, light.irradiance, white(patches), {{light}}, {});
    int shadow = 0, gradient = 0;
    for (const Refinement& cut : cuts) {
        const double share = light.visible[cut.patch];
        shadow += cut.reason == Reason::shadow;
        gradient += cut.reason == Reason::gradient;
        EXPECT_LT(std::abs(glm::length(patches[cut.patch].centre) - 1.3), 0.5) << "far from the edge";
        if (cut.reason == Reason::shadow) {
            EXPECT_TRUE(share > 0 && share < 1);
        }
    }
    EXPECT_GE(shadow, 20);
    EXPECT_GT(gradient, 10);
    for (std::uint32_t i = 0; i < patches.size(); ++i)
        if (light.visible[i] > 0.1 && light.visible[i] < 0.9) {
            EXPECT_TRUE(std::ranges::count(cuts, i, &Refinement::patch)) << i;
        }
    const auto edges =
        patchesToRefine(patches, borders, light.irradiance, white(patches), {{light}}, {.gradientWeight = 0});
    EXPECT_EQ(std::ranges::count(edges, Reason::shadow, &Refinement::reason),
              std::ranges::count_if(light.visible, [](double share) { return share > 0 && share < 1; }));
    EXPECT_EQ(std::ranges::count(edges, Reason::gradient, &Refinement::reason), 0);
    // Light that is even all over is no reason.
    const std::vector<dvec3> even(patches.size(), dvec3(3));
    EXPECT_TRUE(patchesToRefine(patches, borders, even, {}, {}, {}).empty());
    EXPECT_TRUE(
        patchesToRefine(patches, borders, light.irradiance, white(patches), {{light}}, {.smallestArea = 0.07}).empty());
    EXPECT_TRUE(
        patchesToRefine(patches, borders, light.irradiance, white(patches), {{light}}, {.smallestError = 9}).empty());
}

TEST(Refinement, KeepsToABudget) {
    const Faces faces = floorFaces();
    for (const std::size_t most : {70u, 200u, 1500u}) {
        std::vector<Patch> patches = cutIntoPatches(faces, 0.5);
        ASSERT_EQ(patches.size(), 64u);
        std::vector<std::uint8_t> level;
        int rounds = 0;
        for (;; ++rounds) {
            const PatchBorders borders = patchBorders(faces, patches);
            const DirectLight light = spotOfLight(patches, 1.3);
            const auto cuts = patchesToRefine(patches, borders, light.irradiance, white(patches), {{light}},
                                              {.mostPatches = most, .smallestArea = rounds < 5 ? 0.0 : 9.0});
            if (cuts.empty()) break;
            const Refined finer = refined(patches, cuts, level);
            ASSERT_EQ(finer.patches.size(), patches.size() + 3 * cuts.size());
            for (std::size_t i = 0; i < finer.patches.size(); ++i) {
                const bool isNew = finer.from[i] == Refined::kNew;
                ASSERT_EQ(finer.patches[i].area < patches[finer.parent[i]].area, isNew);
                ASSERT_EQ(finer.level[i], (level.empty() ? 0 : level[finer.parent[i]]) + isNew);
            }
            patches = finer.patches;
            level = finer.level;
            ASSERT_LE(patches.size(), most);
        }
        EXPECT_NEAR(areaOf(patches), 16, 1e-9);
        if (most > 100) {
            EXPECT_GT(static_cast<double>(patches.size()), 0.7 * static_cast<double>(most));
            EXPECT_GE(rounds, 2);
        }
    }
}

/// Only the patch about one place is cut, again and again, and with it those that would be too large beside it.
TEST(Refinement, NeighboursAreOneLevelApart) {
    const Faces faces = floorFaces();
    std::vector<Patch> patches = cutIntoPatches(faces, 1);
    std::vector<std::uint8_t> level(patches.size(), 0);
    const dvec3 place(0.3, 0, 0.1);
    int balanced = 0;
    for (int round = 0; round < 6; ++round) {
        DirectLight light;
        for (const Patch& patch : patches) {
            const dvec3 toPlace = glm::abs(patch.centre - place);
            light.visible.push_back(std::max(toPlace.x, toPlace.z) < std::sqrt(patch.area) / 2 ? 0.5 : 1);
            light.irradiance.emplace_back(1);
        }
        const auto cuts =
            patchesToRefine(patches, patchBorders(faces, patches), light.irradiance, white(patches), {{light}}, {});
        EXPECT_EQ(std::ranges::count(cuts, Reason::shadow, &Refinement::reason), 1);
        balanced += static_cast<int>(cuts.size()) - 1;
        const Refined finer = refined(patches, cuts, level);
        patches = finer.patches;
        level = finer.level;
        const PatchBorders borders = patchBorders(faces, patches);
        for (std::uint32_t i = 0; i < patches.size(); ++i)
            for (const std::uint32_t next : borders.neighbours(i))
                ASSERT_LE(std::abs(level[i] - level[next]), 1);
    }
    EXPECT_GT(balanced, 10);
    EXPECT_EQ(*std::ranges::max_element(level), 6);
    EXPECT_LT(patches.size(), 150u) << "far from there nothing is cut";
}

TEST(Refinement, WhatIsSymmetricStaysSo) {
    const Faces faces = floorFaces();
    std::vector<Patch> patches = cutIntoPatches(faces, 0.25);
    for (int round = 0; round < 3; ++round) {
        DirectLight light = spotOfLight(patches, 1.1);
        for (std::size_t i = 0; i < patches.size(); ++i) // the noise of another order of sums
            light.irradiance[i] *= 1 + 1e-14 * static_cast<double>(i % 7);
        const auto cuts = patchesToRefine(patches, patchBorders(faces, patches), light.irradiance, white(patches),
                                          {{light}}, {.mostPatches = patches.size() + 100});
        ASSERT_GT(cuts.size(), 15u);
        const auto isCut = [&](const dvec3& centre) {
            return std::ranges::any_of(
                cuts, [&](const Refinement& cut) { return glm::distance(patches[cut.patch].centre, centre) < 1e-9; });
        };
        for (const Refinement& cut : cuts) {
            const dvec3& centre = patches[cut.patch].centre;
            EXPECT_TRUE(isCut(centre * dvec3(-1, 1, 1)));
            EXPECT_TRUE(isCut(centre * dvec3(1, 1, -1)));
            EXPECT_TRUE(isCut({centre.z, centre.y, centre.x}));
        }
        patches = refined(patches, cuts, {}).patches;
    }
}

/// Triangles, and what the foot of a turned box leaves of squares.
TEST(Refinement, PiecesOfAnyShapeCoverTheWhole) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({1.2, 0.5, 1.7}), 0.4, dvec3(0, 1, 0)));
    addObject(scene, scene::makeSphere(0.3, 8), translation({2.4, 1, 3}));
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const std::vector<Patch> patches = cutAtContacts(faces, cutIntoPatches(faces, 0.4));
    std::vector<Refinement> all;
    std::size_t odd = 0;
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
        all.push_back({i, Reason::gradient});
        odd += patches[i].polygon.count() > 4;
    }
    EXPECT_GT(odd, 5u);
    const Refined finer = refined(patches, all, {});
    EXPECT_GT(finer.patches.size(), 3 * patches.size());
    EXPECT_LT(finer.patches.size(), 4 * patches.size()) << "some are long, and only cut in two";
    EXPECT_NEAR(areaOf(finer.patches), areaOf(patches), 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(finer.patches, {}, &Patch::face));
    for (std::size_t i = 0; i < finer.patches.size(); ++i) {
        const Patch &piece = finer.patches[i], &whole = patches[finer.parent[i]];
        EXPECT_LT(piece.area, 0.75 * whole.area); // quads that are no parallelograms are not halved in area
        for (std::size_t k = 0; k < piece.polygon.count(); ++k) { // convex, and the same way round
            const Polygon& p = piece.polygon;
            const dvec3 &a = p[k], &b = p[(k + 1) % p.count()], &c = p[(k + 2) % p.count()];
            EXPECT_GE(glm::dot(whole.normal, glm::cross(b - a, c - b)), -1e-12);
        }
    }
    // All corners that a polygon can have.
    Polygon round;
    for (std::size_t i = 0; i < Polygon::kMostCorners; ++i)
        round.add({std::sin(0.39269908169872414 * static_cast<double>(i)), 0,
                   std::cos(0.39269908169872414 * static_cast<double>(i))});
    const std::vector<Patch> lone{{round, {0, 1, 0}, dvec3(0.0), glm::length(areaVector(round)), 0}};
    const std::vector<Patch> halves = refined(lone, {{Refinement{}}}, {}).patches;
    ASSERT_EQ(halves.size(), 2u);
    EXPECT_NEAR(areaOf(halves), lone[0].area, 1e-12);
}

} // namespace
} // namespace shadowlab::radiosity
