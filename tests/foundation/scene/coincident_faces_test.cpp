// Which faces coincide, which of them is seen, and which sides need not be drawn for that.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/foundation/scene/query/coincident/seen_sides.h"
#include "techniques/foundation/scene/query/coincident/touching_boxes.h"
#include "tests/support/scenes.h"
#include "tests/support/trefoil.h"

namespace shadowlab::scene {
namespace {

using namespace shadowlab::testing;

TEST(TouchingBoxesTest, AreThoseThatComparingAllFinds) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-3, 3), power(-12, 2);
    std::vector<Bounds> boxes;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 lower(place(random), place(random), place(random));
        boxes.push_back({lower, lower + dvec3(std::exp2(power(random)), std::exp2(power(random)), i % 3 ? std::exp2(power(random)) : 0)});
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected, found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
            if (touch(boxes[i], boxes[j])) expected.emplace(i, j);
    forEachTouchingPair(boxes, [&](std::uint32_t i, std::uint32_t j) {
        EXPECT_TRUE(found.emplace(i, j).second) << "a pair twice";
    });
    EXPECT_GT(expected.size(), 1000u);
    EXPECT_EQ(found, expected);
}

Scene empty() {
    Scene scene;
    scene.materials.emplace_back();
    return scene;
}

std::vector<dvec3> square(double half, bool facesUp) {
    std::vector<dvec3> corners{{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {-half, 0, -half}, {half, 0, half}, {half, 0, -half}};
    if (!facesUp) std::ranges::reverse(corners);
    return corners;
}

std::size_t pairsOf(const Scene& scene) { return CoincidentFaces(scene).pairs().size() / 2; }

TEST(CoincidentPairsTest, ShareAPlaneAndMoreThanAnEdge) {
    EXPECT_EQ(pairsOf(simpleScene()), 2u) << "of the box's bottom, all in one of the floor's triangles";
    Scene scene = empty();
    addObject(scene, triangleSoup(square(1, true)));
    EXPECT_EQ(pairsOf(scene), 0u) << "two halves of a square share an edge alone";
    addObject(scene, triangleSoup(square(1, true)), translation({2, 0, 0}));
    EXPECT_EQ(pairsOf(scene), 0u) << "squares side by side";
    addObject(scene, triangleSoup(square(1, true)), translation({0, 1e-4, 0}));
    EXPECT_EQ(pairsOf(scene), 0u) << "a tenth of a millimetre above";
    addObject(scene, triangleSoup(square(0.25, false)));
    EXPECT_EQ(pairsOf(scene), 2u) << "one within, cut along the same diagonal";
    const dmat4 turned = glm::rotate(translation({1e5, 0, 1e5}), 0.7, dvec3(1, 2, 3));
    for (Object& object : scene.objects)
        object.worldFromObject = turned * object.worldFromObject;
    EXPECT_EQ(pairsOf(scene), 2u) << "turned, and far from the origin";
}

/// Programs that turn a plane before they write it leave noise in coordinates that should be nought, and write six decimals.
TEST(CoincidentPairsTest, AreFoundThroughTheRoundingOfFiles) {
    for (const double noise : {1e-30, 1e-18, 1e-16, 1e-9, -1e-7}) {
        Scene scene = empty();
        addObject(scene, triangleSoup(square(1, true)));
        addObject(scene, triangleSoup(square(0.25, true)), translation({0, noise, 0}));
        EXPECT_EQ(pairsOf(scene), 2u) << noise;
    }
    int found = 0, exact = 0;
    for (int i = 0; i < 50; ++i) {
        const dmat4 turned = glm::rotate(translation({0.1 * i, 2, -0.3}), 0.3 + 0.11 * i, dvec3(1, 0.2 * i, 3));
        const auto written = [&](std::vector<dvec3> corners, double unit) {
            for (dvec3& corner : corners)
                corner = glm::round(transformPoint(turned, corner) / unit) * unit;
            return triangleSoup(corners);
        };
        for (const double unit : {1e-6, 1e-4}) {
            Scene scene = empty();
            addObject(scene, written(square(1, true), unit));
            addObject(scene, written(square(0.25, true), unit));
            (unit == 1e-6 ? found : exact) += pairsOf(scene) == 2;
        }
    }
    EXPECT_EQ(found, 50);
    EXPECT_LT(exact, 25) << "of planes with four decimals no rounding of ours can tell that they were one";
}

TEST(CoincidentPairsTest, AFineCurvedMeshHasNone) {
    Scene scene = empty();
    addObject(scene, trefoil(0.25, 120, 24));
    EXPECT_EQ(pairsOf(scene), 0u);
    EXPECT_GT(scene.objects[0].mesh->triangles.size(), 5000u);
}

TEST(CoincidentPairsTest, AreFoundAgainOnlyWhereSomethingHasMoved) {
    Scene scene = empty();
    addObject(scene, triangleSoup(square(1, true)));
    addObject(scene, triangleSoup(square(0.5, true)));
    const CoincidentFaces before(scene);
    ASSERT_EQ(before.pairs().size(), 4u) << "two pairs, in both orders";
    EXPECT_TRUE(std::ranges::equal(CoincidentFaces(scene, &before).pairs(), before.pairs()));
    scene.objects[1].worldFromObject = translation({0, 1, 0});
    EXPECT_TRUE(CoincidentFaces(scene, &before).isEmpty());
}

TEST(CoincidentPairsTest, WhatFacesTheEyeGoesBeforeWhatDoesNotAndTheLaterBeforeTheEarlier) {
    Scene scene = empty();
    scene.materials.emplace_back().emission = vec3(1);
    addObject(scene, triangleSoup(square(1, true)));
    addObject(scene, triangleSoup(square(1, true)));
    addObject(scene, triangleSoup(square(1, false)));
    addObject(scene, triangleSoup(square(1, true))).partMaterials = {1};
    const CoincidentFaces faces(scene);
    const auto rank = [&](std::uint32_t object, bool isFront) { return faces.rank(2 * object, isFront); };
    EXPECT_LT(rank(0, true), rank(1, true)) << "the later";
    EXPECT_LT(rank(0, false), rank(1, false));
    EXPECT_LT(rank(2, false), rank(0, true)) << "from above the front of the first, not the back of the third";
    EXPECT_LT(rank(1, false), rank(2, true));
    EXPECT_LT(rank(1, true), rank(3, true)) << "an emitter that shines toward the eye before all";
    EXPECT_LT(rank(3, false), rank(0, false)) << "one that is dark there behind all";
}

/// In a file the later face goes before the earlier one, also where its material was used before.
TEST(CoincidentPairsTest, TheOrderIsThatOfTheFile) {
    Scene scene = empty();
    scene.materials.emplace_back();
    Mesh mesh = triangleSoup([] {
        std::vector<dvec3> corners = square(1, true), again = square(1, true);
        corners.insert(corners.end(), again.begin(), again.end());
        return corners;
    }());
    mesh.parts = {{"a", 0, 2, false}, {"b", 2, 2, false}};
    mesh.fileOrder = {2, 3, 0, 1};
    addObject(scene, mesh).partMaterials = {0, 1};
    const CoincidentFaces faces(scene);
    ASSERT_FALSE(faces.isEmpty());
    EXPECT_LT(faces.rank(2, true), faces.rank(0, true));
}

const SeenSides* sidesOf(const std::vector<SeenSides>& all, std::uint32_t triangle) {
    const auto found = std::ranges::find(all, triangle, &SeenSides::triangle);
    return found == all.end() ? nullptr : &*found;
}

TEST(SeenSidesTest, AFaceWrittenTwiceLeavesOutBothBacksAndNeedsNoLayers) {
    for (const bool cutOtherwise : {false, true}) {
        Scene scene = empty();
        addObject(scene, triangleSoup(square(1, true)));
        std::vector<dvec3> reversed = square(1, false);
        if (cutOtherwise) reversed = {{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
        addObject(scene, triangleSoup(reversed));
        const std::vector<SeenSides> sides = seenSides(scene, CoincidentFaces(scene));
        ASSERT_EQ(sides.size(), 4u);
        for (const SeenSides& both : sides) {
            EXPECT_TRUE(both.back.isHidden);
            EXPECT_FALSE(both.front.isHidden);
        }
    }
}

TEST(SeenSidesTest, ABoxOnAFloorLeavesTheFloorAsItIs) {
    const Scene scene = simpleScene();
    const CoincidentFaces faces(scene);
    EXPECT_FALSE(faces.mayShowAnother(0, true, false)) << "from above the floor is seen in any case";
    EXPECT_TRUE(faces.mayShowAnother(0, false, false)) << "from below the box may be";
    for (const SeenSides& both : seenSides(scene, faces)) {
        EXPECT_EQ(both.front.isHidden, false);
        if (both.triangle < 2)
            EXPECT_EQ(both.front.layer, 0) << "the floor from above";
        else
            EXPECT_TRUE(both.back.isHidden) << "the bottom of the box from within";
    }
}

TEST(SeenSidesTest, ADecalIsALayerNearer) {
    Scene scene = empty();
    addObject(scene, triangleSoup(square(1, true)));
    addObject(scene, triangleSoup(square(0.5, true)));
    const std::vector<SeenSides> sides = seenSides(scene, CoincidentFaces(scene));
    ASSERT_TRUE(sidesOf(sides, 2) && sidesOf(sides, 3));
    for (const std::uint32_t decal : {2u, 3u}) {
        EXPECT_EQ(sidesOf(sides, decal)->front.layer, 1);
        EXPECT_EQ(sidesOf(sides, decal)->back.layer, 1);
    }
    EXPECT_EQ(sidesOf(sides, 0), nullptr);
    std::swap(scene.objects[0], scene.objects[1]); // under the floor it is hidden
    const std::vector<SeenSides> under = seenSides(scene, CoincidentFaces(scene));
    ASSERT_TRUE(sidesOf(under, 0) && sidesOf(under, 1));
    EXPECT_TRUE(sidesOf(under, 0)->front.isHidden && sidesOf(under, 0)->back.isHidden);
}

TEST(SeenSidesTest, TilesHideAFaceOnceTheyCoverItTogether) {
    Scene scene = empty();
    addObject(scene, triangleSoup(square(0.5, true)));
    int tiles = 0;
    for (const dvec3& at : {dvec3(-0.5, 0, -0.5), dvec3(0.5, 0, -0.5), dvec3(-0.5, 0, 0.5), dvec3(0.5, 0, 0.5)}) {
        addObject(scene, triangleSoup(square(0.5, true)), translation(at));
        const std::vector<SeenSides> sides = seenSides(scene, CoincidentFaces(scene));
        const auto isHidden = [&](std::uint32_t triangle) {
            const SeenSides* both = sidesOf(sides, triangle);
            return both && both->front.isHidden && both->back.isHidden;
        };
        EXPECT_EQ(isHidden(0) && isHidden(1), ++tiles == 4) << tiles;
    }
}

} // namespace
} // namespace shadowlab::scene
