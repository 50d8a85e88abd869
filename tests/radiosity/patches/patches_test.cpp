// Faces and patches: rectangles are found in triangles, nothing is lost or counted twice, and no patch is too large.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/patches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/radiosity/patches/patch_cells.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

double areaOf(const scene::Scene& scene) {
    double area = 0;
    for (const trace::Triangle& t : trace::worldTriangles(scene).triangles)
        area += 0.5 * glm::length(glm::cross(t.b - t.a, t.c - t.a));
    return area;
}

TEST(Faces, WallsAndBoxesAreRectangles) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({1, 0.5, 1}), 0.3, dvec3(0, 1, 0)));
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    ASSERT_EQ(faces.all.size(), 12u);
    for (const Face& face : faces.all) {
        EXPECT_EQ(face.polygon.count(), 4u);
        EXPECT_NE(face.triangles[0], face.triangles[1]);
    }
    ASSERT_EQ(faces.ofTriangle.size(), 24u);
    // Toward the inside of the room, and out of the box.
    const dvec3 middle = dvec3(1.5, 1, 2) - trace::worldTriangles(scene).originWorld;
    for (std::size_t f = 0; f < 6; ++f)
        EXPECT_GT(glm::dot(areaVector(faces.all[f].polygon), middle - centroid(faces.all[f].polygon)), 0) << f;
}

TEST(Faces, OfRoundThingsTheFlatQuadsOnly) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeSphere(1, 16));
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    // 16 triangles about each pole, between them 6 rings of 16 trapezoids, each flat.
    EXPECT_EQ(faces.all.size(), 32u + 6 * 16);
    EXPECT_EQ(std::ranges::count(faces.all, 4u, [](const Face& f) { return f.polygon.count(); }), 6 * 16);
}

TEST(Patches, CoverTheSceneOnce) {
    scene::Scene scene = simpleScene();
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    const double area = areaOf(scene);
    for (const double size : {10.0, 0.7, 0.2}) {
        const std::vector<Patch> patches = cutIntoPatches(faces, size);
        double sum = 0, longest = 0;
        for (const Patch& patch : patches) {
            sum += patch.area;
            EXPECT_NEAR(glm::length(patch.normal), 1, 1e-12);
            for (std::size_t i = 0; i < patch.polygon.count(); ++i)
                longest =
                    std::max(longest, glm::length(patch.polygon[(i + 1) % patch.polygon.count()] - patch.polygon[i]));
            const dvec3 ofFace = areaVector(faces.all[patch.face].polygon);
            EXPECT_GT(glm::dot(patch.normal, ofFace), 0.99 * glm::length(ofFace));
        }
        EXPECT_GE(patches.size(), faces.all.size());
        EXPECT_NEAR(sum / area, 1, 1e-6); // quads of round things are flat to 1e-7 of their size only
        EXPECT_LE(longest, size * (1 + 1e-6));
    }
}

TEST(Patches, KeepToABudget) {
    const scene::Scene scene = emptyRoom({3, 2, 4});
    const Faces faces = facesOf(scene, trace::worldTriangles(scene));
    for (const std::size_t most : {6u, 100u, 5000u}) {
        const std::size_t count = cutIntoPatches(faces, sizeForBudget(faces, most)).size();
        EXPECT_LE(count, most);
        EXPECT_GE(count, most / 2); // a sixteenth of a doubling finer would be too many; walls are cut by whole numbers
    }
    EXPECT_EQ(sizeForBudget(Faces(), 10), 0);
    EXPECT_EQ(cutIntoPatches(faces, sizeForBudget(faces, 1)).size(), 6u) << "fewer than faces are not to be had";
}

// Of a trapezium twice as wide below as above, and of a pentagon: as many points on every part as it is large.
TEST(Patches, PlacesAreEvenWithoutWeights) {
    const Polygon trapezium{{0, 0, 0}, {2, 0, 0}, {1.5, 1, 0}, {0.5, 1, 0}}, pentagon{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 2, 0}};
    constexpr int kSide = 200; // a step is a 200th, in a polygon of a few
    for (const Polygon& polygon : {trapezium, pentagon}) {
        dvec3 even(0), bySquare(0);
        int within = 0, left = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const double s = (i % kSide + 0.5) / kSide, t = (i / kSide + 0.5) / kSide;
            const dvec3 place = evenPlaceIn(polygon, s, t);
            even += place / double{kSide * kSide};
            bySquare += placeIn(polygon, s, t).point / double{kSide * kSide};
            within += holds(polygon, place, {0, 0, 1}) ? 1 : 0;
            left += place.x < 0.5 ? 1 : 0;
        }
        const Plane cut{{0.5, 0, 0}, {-1, 0, 0}};
        const double shareLeft = glm::length(areaVector(partBefore(cut, polygon, 0))) / glm::length(areaVector(polygon));
        EXPECT_EQ(within, kSide * kSide);
        EXPECT_LT(glm::distance(even, centroid(polygon)), 0.005);
        EXPECT_NEAR(left / double{kSide * kSide}, shareLeft, 0.005);
        EXPECT_GT(glm::distance(bySquare, centroid(polygon)), 0.03) << "without weights the square's points are not even";
    }
}

// Of circles within a polygon, around it, across one of its sides, of two corners, and beside it; and of any, by counting points.
TEST(Patches, WhatACircleHasOfAPolygon) {
    const Polygon square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    const double pi = glm::pi<double>();
    EXPECT_NEAR(areaWithinCircle(square, {1, 1, 0}, 0.5), 0.25 * pi, 1e-14);
    EXPECT_NEAR(areaWithinCircle(square, {1, 1, 0}, 2), 4, 1e-14);
    EXPECT_NEAR(areaWithinCircle(square, {2, 1, 0}, 0.5), 0.125 * pi, 1e-14);
    EXPECT_NEAR(areaWithinCircle(square, {0, 0, 0}, 2), pi, 1e-14);
    EXPECT_NEAR(areaWithinCircle(square, {4, 1, 0}, 1.5), 0, 1e-14);
    const Polygon pentagon{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 2, 0}};
    constexpr int kSide = 400;
    const double area = glm::length(areaVector(pentagon));
    for (const dvec3& middle : {dvec3(0.2, 0.4, 0), dvec3(2.6, 0.5, 0), dvec3(1, 1, 0), dvec3(-0.4, 1, 0)}) {
        int within = 0;
        for (int i = 0; i < kSide * kSide; ++i)
            within += glm::distance(evenPlaceIn(pentagon, (i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide), middle) < 0.9 ? 1 : 0;
        EXPECT_GT(within, 1000);
        EXPECT_NEAR(areaWithinCircle(pentagon, middle, 0.9), area * within / (kSide * kSide), 0.003 * area);
    }
}

// Of polygons that do not fill the rectangle around them: each cell is as large as the share of even points that it holds, and some are empty.
TEST(Patches, CellsAreAsLargeAsWhatThePatchHasOfThem) {
    constexpr std::size_t kOnSide = 6;
    constexpr int kSide = 300;
    const Polygon triangle{{0, 0, 1}, {3, 0, 1}, {0, 2, 1}}, pentagon{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 2, 0}};
    for (const Polygon& polygon : {triangle, pentagon}) {
        const PatchCells cells(polygon, kOnSide);
        const std::vector<double> areas = cells.areasIn(polygon);
        ASSERT_EQ(areas.size(), kOnSide * kOnSide);
        std::vector<double> points(areas.size());
        const double area = glm::length(areaVector(polygon));
        for (int i = 0; i < kSide * kSide; ++i)
            points[cells.at(evenPlaceIn(polygon, (i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide))] += area / (kSide * kSide);
        double sum = 0;
        for (std::size_t c = 0; c < areas.size(); ++c) {
            EXPECT_NEAR(areas[c], points[c], 0.05 * cells.area()) << "along its rim a cell has some fifty points more or less";
            sum += areas[c];
        }
        EXPECT_NEAR(sum, area, 1e-9);
        EXPECT_GT(std::ranges::count(areas, 0.0), 3) << "beside the polygon";
        EXPECT_GT(std::ranges::count_if(areas, [&](double one) { return one > 0 && one < 0.9 * cells.area(); }), 3) << "partly beside it";
    }
}

} // namespace
} // namespace shadowlab::radiosity
