// The lecture's form factors against closed forms, and their two properties: reciprocity, and rows that sum to 1.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/lecture/lecture.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab {
namespace {

using testing::translation;

struct Factors {
    explicit Factors(const scene::Scene& scene, std::size_t most) : rays(testing::snapshot(scene)) {
        surfaces = lecture::divideSurfaces(rays, most);
        F.n = 2 * surfaces.patches.size();
        F.all.resize(F.n * F.n);
        for (std::size_t j = 0; j < surfaces.patches.size(); ++j)
            lecture::addFormFactors(rays, surfaces.patches, j, F);
    }
    [[nodiscard]] std::uint32_t objectOf(std::size_t side) const {
        return surfaces.patches[side / 2].points[0].triangle->object;
    }
    /// From one object to another, of all their patches; `backs`: from back to back instead of from front to front.
    [[nodiscard]] double between(std::uint32_t from, std::uint32_t to, bool backs = false) const {
        double sum = 0, area = 0;
        for (std::size_t j = backs; j < F.n; j += 2) {
            if (objectOf(j) != from) continue;
            area += surfaces.patches[j / 2].area;
            for (std::size_t k = backs; k < F.n; k += 2)
                if (objectOf(k) == to) sum += surfaces.patches[j / 2].area * static_cast<double>(F.at(j, k));
        }
        return sum / area;
    }
    lecture::RayScene rays;
    lecture::DividedSurfaces surfaces;
    lecture::FormFactors F;
};

scene::Scene cubeOfOne() { return testing::emptyRoom({1, 1, 1}); }

// J. R. Howell, "A Catalog of Radiation Configuration Factors", C-11 and C-14: opposite walls of a cube see 0.199825 of each other,
// neighbours 0.200044.
TEST(LectureFormFactors, OfACubeAreThoseOfTheClosedForms) {
    std::array<double, 3> errorOfOpposite{}, errorOfNeighbours{};
    const std::array<std::size_t, 3> most{50, 200, 800};
    for (std::size_t i = 0; i < most.size(); ++i) {
        const Factors cube(cubeOfOne(), most[i]);
        ASSERT_GT(cube.F.n, most[i] / 2);
        errorOfOpposite[i] = std::abs(cube.between(0, 1) / 0.199825 - 1);
        errorOfNeighbours[i] = std::abs(cube.between(0, 2) / 0.200044 - 1);
        std::cout << cube.F.n / 2 << " patches: opposite " << 100 * errorOfOpposite[i] << " %, neighbours "
                  << 100 * errorOfNeighbours[i] << " %\n";
        EXPECT_EQ(cube.between(0, 1, true), 0) << "backs look out of the cube";
    }
    // Sums at the middles of pieces: their error falls with the square of a piece's length where the integrand is smooth, and
    // with the length where two walls touch.
    EXPECT_LT(errorOfOpposite[2], 0.001);
    EXPECT_LT(errorOfNeighbours[2], 0.02);
    EXPECT_LT(errorOfOpposite[2], errorOfOpposite[0]);
    EXPECT_LT(errorOfNeighbours[2], errorOfNeighbours[0]);
}

TEST(LectureFormFactors, AreReciprocal) {
    scene::Scene scene = testing::emptyRoom({3, 2, 4});
    testing::addObject(scene, scene::makeSphere(0.4, 16), translation({1, 0.5, 2}));
    const Factors room(scene, 300);
    int compared = 0;
    for (std::size_t j = 0; j < room.F.n; ++j)
        for (std::size_t k = 0; k < j; ++k) {
            const double there = room.surfaces.patches[j / 2].area * static_cast<double>(room.F.at(j, k));
            const double back = room.surfaces.patches[k / 2].area * static_cast<double>(room.F.at(k, j));
            ASSERT_NEAR(there, back, 2e-7 * there) << j << ", " << k; // both are rounded to float
            compared += there > 0;
        }
    EXPECT_GT(compared, 10'000);
}

TEST(LectureFormFactors, OfAnEnclosedSpaceRowsSumToOne) {
    const Factors room(testing::emptyRoom({3, 2, 4}), 600);
    int rows = 0;
    double mean = 0;
    for (std::size_t j = 0; j < room.F.n; j += 2, ++rows) {
        double sum = 0;
        for (std::size_t k = 0; k < room.F.n; ++k)
            sum += static_cast<double>(room.F.at(j, k));
        mean += sum;
        EXPECT_NEAR(sum, 1, 0.12) << j; // in corners: a neighbour is as near as four points of either are apart
    }
    EXPECT_GT(rows, 300);
    EXPECT_NEAR(mean / rows, 1, 0.025); // as much as neighbouring walls of a cube are wrong at this number of patches
}

TEST(LectureFormFactors, WhatStandsBetweenTakesItsShare) {
    const auto facing = [](bool screen, double width) {
        scene::Scene scene = cubeOfOne();
        scene.objects.resize(2); // floor and ceiling
        if (screen) testing::addObject(scene, scene::makeQuad({width, width}), translation({0.5, 0.5, 0.5}));
        return Factors(scene, 600).between(0, 1);
    };
    EXPECT_NEAR(facing(false, 0), 0.199825, 0.001 * 0.199825);
    EXPECT_EQ(facing(true, 1), 0) << "every line between them passes the middle plane within the unit square";
    // Within half the square, seen from both, lies the share S of the exchange that passes there; by symmetry more than none.
    EXPECT_GT(facing(true, 0.5), 0.02);
    EXPECT_LT(facing(true, 0.5), 0.16);
}

TEST(LecturePatches, CoverAllOfTheSurfaces) {
    for (const std::size_t most : {100, 1000}) {
        const lecture::RayScene rays(testing::snapshot(testing::simpleScene()));
        const lecture::DividedSurfaces surfaces = lecture::divideSurfaces(rays, most);
        EXPECT_GT(surfaces.patches.size(), most / 2);
        EXPECT_LE(surfaces.patches.size(), most);
        double ofPatches = 0, ofPoints = 0, ofTriangles = 0;
        for (const lecture::Patch& patch : surfaces.patches) {
            ofPatches += patch.area;
            EXPECT_FALSE(patch.points.empty());
            for (const lecture::SurfacePoint& point : patch.points)
                ofPoints += point.area;
        }
        for (const lecture::Triangle& t : rays.triangles())
            ofTriangles += 0.5 * glm::length(glm::cross(t.bWorld - t.aWorld, t.cWorld - t.aWorld));
        EXPECT_NEAR(ofPatches, ofTriangles, 1e-9 * ofTriangles); // thousands of roundings
        EXPECT_NEAR(ofPoints, ofTriangles, 1e-9 * ofTriangles);
    }
}

TEST(LecturePatches, ASceneOfTooManyObjectsIsRefusedWithARemedy) {
    scene::Scene scene = testing::floorScene();
    for (int i = 0; i < 20; ++i)
        testing::addObject(scene, scene::makeBox({0.1, 0.1, 0.1}), translation({0.4 * i, 0.5, 0}));
    const lecture::RayScene rays(testing::snapshot(scene));
    try {
        lecture::divideSurfaces(rays, 100);
        FAIL() << "20 boxes have 120 faces";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::overLimit);
        EXPECT_NE(std::string(error.what()).find("choose a larger lecture-radiosity.patches"), std::string::npos);
    }
    EXPECT_LE(lecture::divideSurfaces(rays, 150).patches.size(), 150u);
}

} // namespace
} // namespace shadowlab
