// Form factors by drawing, against closed forms and against exact exchange areas.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/hemicube_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/patches/contacts.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;
using HemicubeTest = GlTest;

/// With an upper face of 128 x 128 pixels no form factor is further off than this: a fifth of what a row of pixels through the middle
/// counts, 4 / (128 pi). Of a row along an edge of a patch some pixels are counted to it and some to its neighbour.
constexpr int kSide = 128;
constexpr double kLargestError = 2e-3;

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The largest error of the form factors from all patches of a convex room to all, against Lambert's formula at their centres.
double largestError(const std::vector<Patch>& patches, int side) {
    Hemicube hemicube(side);
    hemicube.setPatches(patches);
    double largest = 0;
    for (const Patch& from : patches) {
        const std::vector<double> factors = hemicube.formFactors(from);
        EXPECT_EQ(factors.size(), patches.size());
        for (std::size_t j = 0; j < patches.size(); ++j) {
            const bool sees = patches[j].face != from.face;
            const double truth = sees ? pointFormFactor(from.centre, from.normal, patches[j].polygon) : 0;
            largest = std::max(largest, std::abs(factors[j] - truth));
        }
    }
    return largest;
}

TEST_F(HemicubeTest, ACubeAgainstLambert) {
    const Room room(emptyRoom({1, 1, 1}), 0.25);
    ASSERT_EQ(room.patches.size(), 96u);
    double before = 1;
    for (const int side : {16, 32, 64, 128, 256}) {
        const double error = largestError(room.patches, side);
        EXPECT_LT(error, before) << side;
        if (side == kSide) {
            EXPECT_LE(error, kLargestError);
        }
        if (side == 16) {
            EXPECT_GT(error, kLargestError) << "any picture would do";
        }
        before = error;
    }
}

/// A closed room with two blocks in the air, turned out of its axes: from every patch something is seen in every pixel, so rows sum
/// to 1. Nothing meets at other places than corners, or a pixel on a seam could show nothing.
TEST_F(HemicubeTest, EverythingInAClosedRoomIsHit) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({1, 0.9, 1}), 0.3, dvec3(0, 1, 0)));
    addObject(scene, scene::makeBox({0.6, 0.8, 0.6}), glm::rotate(translation({2, 1, 2.7}), -0.4, dvec3(1, 2, 0)));
    const Room room(scene, 0.3);
    ASSERT_GT(room.patches.size(), 700u);
    Hemicube hemicube(kSide);
    hemicube.setPatches(room.patches);
    double worst = 0;
    for (const Patch& from : room.patches)
        worst = std::max(worst, std::abs(sumOf(hemicube.formFactors(from)) - 1));
    EXPECT_LE(worst, 1e-6);
}

/// Between a floor and a block that stands on it nothing is seen from its front.
TEST_F(HemicubeTest, UnderABlockIsNothing) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), translation({1, 0.5, 1}));
    const Room room(scene, 0.3);
    const std::vector<Patch> patches = cutAtContacts(room.faces, room.patches);
    Hemicube hemicube(kSide);
    hemicube.setPatches(patches);
    int covered = 0, free = 0;
    for (const Patch& from : patches) {
        const dvec3 position = from.centre + room.originWorld;
        if (position.y > 0.001) continue;
        const double sum = sumOf(hemicube.formFactors(from));
        if (std::max(std::abs(position.x - 1), std::abs(position.z - 1)) < 0.5) {
            ASSERT_EQ(sum, 0);
            ++covered;
        } else {
            ASSERT_GT(sum, 0.99);
            ++free;
        }
    }
    EXPECT_GT(covered, 20);
    EXPECT_GT(free, 100);
}

/// A near plane that reaches farther than the patch does cuts away the wall beside it, and the outside, where nothing is, shows.
TEST_F(HemicubeTest, WhatTouchesThePatchIsNotCutOff) {
    const Room room(emptyRoom({1, 1, 1}), 0.1);
    Hemicube hemicube(kSide);
    hemicube.setPatches(room.patches);
    const Patch& corner = room.patches.front();
    EXPECT_NEAR(sumOf(hemicube.formFactors(corner)), 1, 1e-6);
    EXPECT_LT(sumOf(hemicube.formFactors(corner.centre, corner.normal, 0.1)), 0.8);
}

/// Two rooms with a wall in between, which ends where the patches of both end.
TEST_F(HemicubeTest, BehindAWallIsNothing) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({3, 2, 0.1}), translation({1.5, 1, 1.73}));
    const Room room(scene, 0.5);
    const std::vector<Patch> patches = cutAtContacts(room.faces, room.patches);
    Hemicube hemicube(kSide);
    hemicube.setPatches(patches);
    int hidden = 0, lit = 0;
    for (const Patch& from : patches) {
        const double z = from.centre.z + room.originWorld.z;
        if (z > 1.6) continue;
        const std::vector<double> factors = hemicube.formFactors(from);
        for (std::size_t j = 0; j < patches.size(); ++j) {
            const double otherZ = patches[j].centre.z + room.originWorld.z;
            if (otherZ > 1.78) {
                ASSERT_EQ(factors[j], 0) << "from z = " << z << " to z = " << otherZ;
                ++hidden;
            }
            lit += otherZ < 1.7 && factors[j] > 0;
        }
    }
    EXPECT_GT(hidden, 10000);
    EXPECT_GT(lit, 5000);
}

/// Unit squares a metre apart, and half-way between them a screen that ends in their middle: from (x, .) the far one is seen
/// from 1 - x on.
TEST_F(HemicubeTest, AScreenThatHidesHalf) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({1, 1}), translation({0.5, 0, 0.5}));
    addObject(scene, scene::makeQuad({1, 1}),
              translation({0.5, 1, 0.5}) * glm::rotate(dmat4(1), glm::pi<double>(), dvec3(1, 0, 0)));
    addObject(scene, scene::makeQuad({20, 20}), translation({-9.5, 0.5, 0.5}));
    const Room room(scene, 30);
    ASSERT_EQ(room.patches.size(), 3u);
    Hemicube hemicube(kSide);
    hemicube.setPatches(room.patches);
    constexpr int kPieces = 16; // their midpoints stand for them: the mean errs by 1e-4
    double mean = 0, unoccluded = 0;
    for (int i = 0; i < kPieces; ++i)
        for (int j = 0; j < kPieces; ++j) {
            const double x = (i + 0.5) / kPieces, z = (j + 0.5) / kPieces;
            const dvec3 position(x, 0, z), up(0, 1, 0);
            const std::vector<double> factors = hemicube.formFactors(position - room.originWorld, up, 0.01);
            const double truth = pointFormFactor(position, up, {{1 - x, 1, 0}, {1, 1, 0}, {1, 1, 1}, {1 - x, 1, 1}});
            ASSERT_NEAR(factors[1], truth, kLargestError) << x << ' ' << z;
            ASSERT_EQ(factors[2], 0) << "the screen is seen from behind";
            mean += factors[1] / (kPieces * kPieces);
            unoccluded +=
                pointFormFactor(position, up, {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}) / (kPieces * kPieces);
        }
    const VisibleExchange seen = room.exchange(0, 1, 1e4);
    ASSERT_EQ(seen.kind, VisibleExchange::Kind::partial);
    // Twice the deviation of the lines, and as much as one pixel's row in a picture may err, less for a mean of many pictures.
    const double tolerance = 2 * seen.error + kLargestError + 1e-4;
    EXPECT_NEAR(mean, seen.area, tolerance);
    EXPECT_GT(unoccluded - seen.area, 10 * tolerance) << "the screen isBlocked too little to prove anything";
}

/// The same bytes again, in slices, and both directions of every pair together.
TEST_F(HemicubeTest, ExchangeAreasInSlices) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({1, 0.5, 1}), 0.3, dvec3(0, 1, 0)));
    const Room room(scene, 0.7);
    HemicubeExchange whole(room.patches, 64), sliced(room.patches, 64);
    EXPECT_TRUE(whole.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_EQ(whole.done(), 1);
    std::size_t slices = 1;
    for (; !sliced.advance(std::chrono::steady_clock::now()); ++slices)
        EXPECT_LT(sliced.done(), 1);
    EXPECT_EQ(slices, room.patches.size());

    Hemicube hemicube(64);
    hemicube.setPatches(room.patches);
    std::vector<std::vector<double>> factors;
    std::vector<double> areas;
    for (const Patch& patch : room.patches) {
        factors.push_back(hemicube.formFactors(patch));
        areas.push_back(patch.area);
    }
    std::size_t different = 0, exchanging = 0;
    double largestGap = 0;
    for (std::size_t i = 0; i < room.patches.size(); ++i) {
        different += !std::ranges::equal(whole.exchange().row(i), sliced.exchange().row(i));
        for (std::size_t j = 0; j < i; ++j) {
            const double there = areas[i] * factors[i][j], back = areas[j] * factors[j][i];
            ASSERT_NEAR(whole.exchange()(i, j), (there + back) / 2, 1e-15);
            ASSERT_EQ(whole.exchange()(i, j), whole.exchange()(j, i));
            largestGap = std::max(largestGap, std::abs(there - back) / (areas[i] + areas[j]));
            exchanging += there > 0;
        }
    }
    EXPECT_EQ(different, 0u);
    EXPECT_GT(exchanging, 1000u);
    EXPECT_EQ(whole.gap().largest, largestGap);
    EXPECT_EQ(whole.gap().share, sliced.gap().share);
    EXPECT_GT(whole.gap().share, 0.01) << "pictures are no measures: each direction has an error of its own";
    EXPECT_LT(whole.gap().share, 0.1);
}

} // namespace
} // namespace shadowlab::radiosity
