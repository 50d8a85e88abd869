// What patches exchange with other things in the way.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/visible_exchange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;
using Kind = VisibleExchange::Kind;

/// Sum over a row, and what of it may be wrong by lines chosen at random: their errors are independent.
struct Row {
    double sum = 0, deviation = 0;
};
Row rowOf(const Room& room, std::size_t i, double linesPerPatch) {
    Row row;
    double squares = 0;
    for (std::size_t j = 0; j < room.patches.size(); ++j) {
        if (j == i) continue;
        const VisibleExchange exchange = room.exchange(i, j, linesPerPatch);
        row.sum += exchange.area / room.patches[i].area;
        squares += exchange.error * exchange.error;
    }
    row.deviation = std::sqrt(squares) / room.patches[i].area;
    return row;
}

TEST(VisibleExchange, AnEmptyRoomIsClosed) {
    const Room room(emptyRoom({3, 2, 4}), 0.5);
    ASSERT_EQ(room.patches.size(), 2 * (6 * 8 + 6 * 4 + 4 * 8u));
    int compared = 0;
    for (std::size_t i = 0; i < room.patches.size(); i += 7) {
        // Each of some hundred terms is a closed form, or right to a ten millionth.
        EXPECT_NEAR(rowOf(room, i, 16).sum, 1, 1e-7);
        ++compared;
    }
    EXPECT_GT(compared, 25);
}

TEST(VisibleExchange, ARoomWithBlocksIsClosedUpToTheLines) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({1, 0.5, 1}), 0.3, dvec3(0, 1, 0)));
    addObject(scene, scene::makeBox({0.6, 1.4, 0.6}), glm::rotate(translation({2, 0.7, 2.7}), -0.4, dvec3(0, 1, 0)));
    const Room room(scene, 0.5);
    int compared = 0, kinds[4] = {};
    double worst = 0, naiveWorst = 0;
    for (std::size_t i = 0; i < room.patches.size(); i += 5) {
        if (room.patches[i].centre.y < -0.999) continue; // floor: part of it is under the blocks
        const Row row = rowOf(room, i, 1e4);
        EXPECT_LT(std::abs(row.sum - 1), 4 * row.deviation + 1e-6) << i;
        worst = std::max(worst, std::abs(row.sum - 1));
        double naive = 0;
        for (std::size_t j = 0; j < room.patches.size(); ++j) {
            if (j == i) continue;
            ++kinds[static_cast<int>(room.exchange(i, j, 1).kind)];
            const Patch &a = room.patches[i], &b = room.patches[j];
            const auto& ends = room.faces.all;
            const bool hidden = room.occlusion->isBlocked(
                room.occlusion->between(ends[a.face].polygon, ends[b.face].polygon), a.centre, b.centre);
            if (!hidden) naive += unoccludedExchange(a.polygon, b.polygon).area / a.area;
        }
        naiveWorst = std::max(naiveWorst, std::abs(naive - 1));
        ++compared;
    }
    EXPECT_GT(compared, 30);
    for (const int kind : kinds)
        EXPECT_GT(kind, 200);
    // A row seen all in part by 10,000 lines would scatter by at most half a hundredth.
    EXPECT_LT(worst, 0.01);
    EXPECT_GT(naiveWorst, 0.02) << "one line from middle to middle should be worse than this";
}

/// Unit squares a metre apart, and half-way between them a screen that ends in their middle: from (x, .) the far one is seen
/// from 1 - x on.
TEST(VisibleExchange, AScreenThatHidesHalf) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({1, 1}), translation({0.5, 0, 0.5}));
    addObject(scene, scene::makeQuad({1, 1}),
              translation({0.5, 1, 0.5}) * glm::rotate(dmat4(1), glm::pi<double>(), dvec3(1, 0, 0)));
    addObject(scene, scene::makeQuad({20, 20}), translation({-9.5, 0.5, 0.5}));
    const Room room(scene, 30);
    ASSERT_EQ(room.patches.size(), 3u);
    double truth = 0;
    constexpr int kPieces = 400; // midpoints: the error is the square of a piece, 1e-6
    for (int i = 0; i < kPieces; ++i)
        for (int j = 0; j < 40; ++j) {
            const double x = (i + 0.5) / kPieces, z = (j + 0.5) / 40;
            truth += pointFormFactor({x, 0, z}, {0, 1, 0}, {{1 - x, 1, 0}, {1, 1, 0}, {1, 1, 1}, {1 - x, 1, 1}}) /
                     (kPieces * 40);
        }
    EXPECT_GT(truth, 0.05);
    EXPECT_LT(truth, 0.15);
    double before = 1;
    for (const double lines : {100.0, 1000.0, 10000.0}) {
        const VisibleExchange seen = room.exchange(0, 1, lines);
        EXPECT_EQ(seen.kind, Kind::partial);
        EXPECT_LT(std::abs(seen.area - truth), 2 * seen.error) << lines; // evenly spread lines do better than chance
        EXPECT_LT(seen.error, before);
        before = seen.error;
    }
    EXPECT_NEAR(room.exchange(0, 1, 1e4).area / truth, 1, 0.01);
    // One line from middle to middle sees all or nothing.
    EXPECT_FALSE(room.occlusion->isBlocked({2}, room.patches[0].centre + dvec3(1e-9, 0, 0), room.patches[1].centre));
    EXPECT_TRUE(room.occlusion->isBlocked({2}, room.patches[0].centre - dvec3(1e-9, 0, 0), room.patches[1].centre));
}

/// What is called fully seen is blocked on no line, and what is called hidden free on none, among random triangles and boxes.
TEST(VisibleExchange, FullAndHiddenAreCertain) {
    Random random(3);
    int full = 0, hidden = 0, partial = 0;
    for (int trial = 0; trial < 12; ++trial) {
        scene::Scene scene = emptyRoom({3, 2, 4});
        std::vector<dvec3> corners;
        for (int i = 0; i < 18; ++i)
            corners.push_back(dvec3(1.5, 1, 2) + dvec3(1.4, 0.9, 1.9) * inCube(random, 1));
        addObject(scene, triangleSoup(corners));
        addObject(scene, scene::makeBox({1.5, 1, 0.1}),
                  glm::rotate(translation({1.5, 1, 2}), number(random, 0, 3), dvec3(0, 1, 0)));
        const Room room(scene, 0.9);
        for (int pair = 0; pair < 400; ++pair) {
            const std::size_t i = random() % room.patches.size(), j = random() % room.patches.size();
            const Patch &a = room.patches[i], &b = room.patches[j];
            const VisibleExchange seen = room.exchange(i, j, 16);
            if (seen.kind == Kind::none) continue;
            int blocked = 0, lines = 0;
            for (int line = 0; line < 100; ++line) {
                const auto pointOf = [&](const Polygon& p) {
                    double s = number(random, 0, 1), t = number(random, 0, 1);
                    if (p.count() == 4) return glm::mix(glm::mix(p[0], p[1], s), glm::mix(p[3], p[2], s), t);
                    if (s + t > 1) s = 1 - s, t = 1 - t;
                    return p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
                };
                trace::Ray ray;
                ray.originCentred = pointOf(a.polygon);
                ray.directionCentred = pointOf(b.polygon) - ray.originCentred;
                const dvec3& way = ray.directionCentred;
                if (glm::dot(way, a.normal) <= 1e-9 || glm::dot(way, b.normal) >= -1e-9) continue; // behind one of them
                ++lines;
                ray.nearest = 1e-9;
                ray.farthest = 1 - 1e-9;
                blocked += room.bvh.any(
                               ray, [](std::uint32_t) { return true; }, trace::NoHoles()) != trace::kNoPrimitive;
            }
            if (seen.kind != Kind::partial) {
                EXPECT_EQ(blocked, seen.kind == Kind::full ? 0 : lines) << trial << ' ' << i << ' ' << j;
            }
            full += seen.kind == Kind::full;
            hidden += seen.kind == Kind::hidden;
            partial += seen.kind == Kind::partial;
        }
    }
    EXPECT_GT(full, 200);
    EXPECT_GT(hidden, 20);
    EXPECT_GT(partial, 200);
}

} // namespace
} // namespace shadowlab::radiosity
