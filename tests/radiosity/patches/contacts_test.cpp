// Patches end where things touch.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

/// Does any patch of that face have corners on both sides of the line through `point` across `normal`, more than a micrometre?
int straddling(const std::vector<Patch>& patches, std::uint32_t face, const dvec3& point, const dvec3& normal) {
    return static_cast<int>(std::ranges::count_if(patches, [&](const Patch& patch) {
        const auto beyond = [&](double side) {
            return std::ranges::any_of(patch.polygon.corners(),
                                       [&](const dvec3& p) { return side * glm::dot(normal, p - point) > 1e-6; });
        };
        return patch.face == face && beyond(1) && beyond(-1);
    }));
}

double areaOf(const std::vector<Patch>& patches) {
    double sum = 0;
    for (const Patch& patch : patches)
        sum += patch.area;
    return sum;
}

TEST(Contacts, AWallAcrossAFloorCutsItsPatches) {
    // A thin wall from side to side, at no multiple of the patches' size.
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({3, 2, 0.1}), translation({1.5, 1, 1.73}));
    const trace::WorldTriangles world = trace::worldTriangles(scene);
    const Faces faces = facesOf(scene, world);
    const std::vector<Patch> before = cutIntoPatches(faces, 0.5), after = cutAtContacts(faces, before);
    EXPECT_NEAR(areaOf(after), areaOf(before), 1e-12);
    EXPECT_GT(after.size(), before.size() + 20);
    for (const std::uint32_t face : {0u, 1u, 4u, 5u}) // floor, ceiling, and the long walls
        for (const double side : {1.68, 1.78}) {
            const dvec3 point = dvec3(0, 0, side) - world.originWorld;
            EXPECT_GT(straddling(before, face, point, {0, 0, 1}), 0) << "the case is too easy";
            EXPECT_EQ(straddling(after, face, point, {0, 0, 1}), 0) << face << ' ' << side;
        }
    EXPECT_TRUE(std::ranges::is_sorted(after, {}, &Patch::face));
}

TEST(Contacts, ATurnedBoxCutsOnlyWhatItTouches) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    const dmat4 place = glm::rotate(translation({1.2, 0.5, 1.7}), 0.4, dvec3(0, 1, 0));
    addObject(scene, scene::makeBox({1, 1, 1}), place);
    const trace::WorldTriangles world = trace::worldTriangles(scene);
    const Faces faces = facesOf(scene, world);
    const std::vector<Patch> before = cutIntoPatches(faces, 0.25), after = cutAtContacts(faces, before);
    EXPECT_NEAR(areaOf(after), areaOf(before), 1e-12);
    // Only the floor has more patches than before: where the box stands.
    for (std::uint32_t face = 0; face < faces.all.size(); ++face) {
        const auto count = [&](const std::vector<Patch>& patches) {
            return std::ranges::count(patches, face, &Patch::face);
        };
        if (face == 0)
            EXPECT_GT(count(after), count(before) + 10);
        else
            EXPECT_EQ(count(after), count(before)) << face;
    }
    // Every floor patch is under the box or beside it.
    int under = 0, beside = 0;
    for (const Patch& patch : after) {
        if (patch.face != 0) continue;
        int in = 0, out = 0;
        for (const dvec3& corner : patch.polygon.corners()) {
            const dvec3 local = glm::abs(dvec3(glm::inverse(place) * dvec4(corner + world.originWorld, 1)));
            const double beyond = std::max(local.x, local.z) - 0.5;
            in += beyond < -1e-6;
            out += beyond > 1e-6;
        }
        EXPECT_FALSE(in > 0 && out > 0);
        under += in > 0;
        beside += out > 0;
    }
    EXPECT_GT(under, 10);
    EXPECT_GT(beside, 100);
}

TEST(Contacts, WhatGoesThroughCutsToo) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({2, 2}));
    addObject(scene, scene::makeQuad({0.7, 0.7}), glm::rotate(translation({0.1, 0.05, 0}), 1.2, dvec3(1, 0, 0.3)));
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const std::vector<Patch> whole = cutIntoPatches(faces, 4);
    ASSERT_EQ(whole.size(), 2u);
    const std::vector<Patch> pieces = cutAtContacts(faces, whole);
    EXPECT_EQ(pieces.size(), 4u);            // each in two
    EXPECT_NEAR(areaOf(pieces), 4.49, 1e-6); // the small one's vertices are floats
}

// The disc that a ball cuts out of a wall has more corners than a polygon can have, so it is in several pieces, and none of them reaches beyond it.
TEST(Contacts, ABallCutsADiscOutOfAWall) {
    constexpr double kRadius = 0.5;
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({4, 4}));
    addObject(scene, scene::makeSphere(kRadius, 48), translation({0.3, 0.02, 0.1}));
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const std::vector<Patch> pieces = cutAtContacts(faces, cutIntoPatches(faces, 4));
    double within = 0, all = 0;
    for (const Patch& patch : pieces) {
        if (faces.all[patch.face].object != 0) continue;
        const auto isWithin = [&](const dvec3& corner) { return glm::distance(corner, dvec3(0.3, 0, 0.1)) < kRadius; };
        all += patch.area;
        if (std::ranges::all_of(patch.polygon.corners(), isWithin)) within += patch.area;
    }
    EXPECT_NEAR(all, 16, 1e-6);
    EXPECT_NEAR(within / (M_PI * (kRadius * kRadius - 0.02 * 0.02)), 1, 0.01) << "48 corners leave 0.3 % of a circle, and the mesh lies within the ball";
}

// A rug, or a lamp under a ceiling: hardly any light gets between it and the floor, so the floor's part beneath it is dark.
TEST(Contacts, WhatLiesCloseAboveCutsAlongItsOutline) {
    for (const double height : {0.001, 0.05, 0.5}) {
        scene::Scene scene;
        scene.materials.emplace_back();
        addObject(scene, scene::makeQuad({4, 4}));
        // Its lower side faces the floor.
        addObject(scene, scene::makeQuad({0.7, 0.9}), glm::rotate(translation({0.13, height, 0.21}), glm::pi<double>(), dvec3(1, 0, 0)));
        const Faces faces = facesOf(scene, trace::worldTriangles(scene));
        const std::vector<Patch> before = cutIntoPatches(faces, 1), after = cutAtContacts(faces, before);
        EXPECT_NEAR(areaOf(after), areaOf(before), 1e-9);
        const dvec3 edge(0.13 + 0.35, 0, 0.21);
        ASSERT_GT(straddling(before, 0, edge, {1, 0, 0}), 0);
        EXPECT_EQ(std::ranges::count(after, 1u, &Patch::face), 1) << "the floor is no smaller thing close to the rug";
        if (height < 0.1) {
            double beneath = 0;
            for (const Patch& patch : after)
                if (patch.face == 0 && std::abs(patch.centre.x - 0.13) < 0.35 && std::abs(patch.centre.z - 0.21) < 0.45) beneath += patch.area;
            EXPECT_NEAR(beneath, 0.7 * 0.9, 1e-6) << height;
        } else {
            EXPECT_EQ(after.size(), before.size()) << "too far away";
        }
    }
}

TEST(Contacts, WhatTouchesTheBackDoesNotCut) {
    for (const double height : {0.5, -0.5}) { // of the middle of a wall a metre high: on the floor, and under it
        scene::Scene scene;
        scene.materials.emplace_back();
        addObject(scene, scene::makeQuad({2, 2}));
        addObject(scene, scene::makeQuad({1, 1}),
                  glm::rotate(translation({0.1, height, 0}), glm::half_pi<double>(), dvec3(1, 0, 0)));
        const Faces faces = facesOf(scene, trace::worldTriangles(scene));
        const std::vector<Patch> pieces = cutAtContacts(faces, cutIntoPatches(faces, 4));
        EXPECT_EQ(std::ranges::count(pieces, 0u, &Patch::face), height > 0 ? 2 : 1) << height;
    }
}

} // namespace
} // namespace shadowlab::radiosity
