// From a scene to its radiosity: patches, exchange areas and solution together, in rooms of which the answer is known.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/radiosity/equations/bounces.h"
#include "techniques/radiosity/exchange/exchange_builder.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kLines = 1e4;

struct Solved {
    ExchangeMatrix exchange;
    std::vector<double> areas;
    std::vector<dvec3> radiosity;
    double largestDeviation; ///< of a row sum
};

/// Of patches that emit and reflect what these functions of a patch say.
template <typename Emission, typename Reflectance>
Solved solved(const Room& room, const Emission& emission, const Reflectance& reflectance) {
    ExchangeBuilder builder(room.faces, room.patches, *room.occlusion, kLines);
    EXPECT_TRUE(builder.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_EQ(builder.done(), 1);
    const std::vector<double> deviations = builder.rowDeviations();
    Solved answer{builder.take(), {}, {}, *std::ranges::max_element(deviations)};
    std::vector<dvec3> e, rho;
    for (const Patch& patch : room.patches) {
        answer.areas.push_back(patch.area);
        e.emplace_back(emission(patch));
        rho.emplace_back(reflectance(patch));
    }
    const auto solver = makeSolver(SolverKind::conjugateGradients, {answer.exchange, answer.areas, e, rho});
    EXPECT_TRUE(solve(*solver, 1e-10, 200));
    answer.radiosity = solver->radiosity();
    return answer;
}

TEST(SolvedRoom, UniformEnclosures) {
    const Room room(emptyRoom({3, 2, 4}), 0.5);
    for (const double rho : {0.5, 0.9, 0.99}) {
        const Solved answer = solved(
            room, [](const Patch&) { return 1.0; }, [&](const Patch&) { return rho; });
        ASSERT_EQ(answer.radiosity.size(), room.patches.size());
        const double truth = 1 / (1 - rho);
        for (const dvec3& b :
             answer.radiosity) // row sums are right to 1e-7, and what is wrong with them adds up over all bounces
            ASSERT_NEAR(b.x / truth, 1, 1e-7 * truth);
    }
}

/// A wall across the room, at no multiple of the patches' size, and light on one side of it.
TEST(SolvedRoom, BehindAWallItIsExactlyDark) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({3, 2, 0.1}), translation({1.5, 1, 1.73}));
    Room room(scene, 0.5);
    const auto darkest = [&] {
        const Solved answer = solved(
            room, [&](const Patch& p) { return p.face == 1 && p.centre.z + room.originWorld.z < 1.2 ? 1.0 : 0.0; },
            [](const Patch&) { return 0.8; });
        double dark = 0, light = 0;
        int patches = 0;
        for (std::size_t i = 0; i < room.patches.size(); ++i) {
            const double z = room.patches[i].centre.z + room.originWorld.z;
            if (z > 1.78) {
                dark = std::max(dark, answer.radiosity[i].x);
                ++patches;
            } else if (z < 1.6) {
                light = std::max(light, answer.radiosity[i].x);
            }
        }
        EXPECT_GT(patches, 100);
        EXPECT_GT(light, 1);
        return dark;
    };
    EXPECT_GT(darkest(), 0.01) << "patches that go on under the wall should leak";
    room.patches = cutAtContacts(room.faces, room.patches);
    EXPECT_EQ(darkest(), 0);
}

TEST(SolvedRoom, MirroredRoomsAreMirrored) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({0.6, 1, 0.6}), translation({1.5, 0.5, 2}));
    Room room(scene, 0.4);
    room.patches = cutAtContacts(room.faces, room.patches);
    const Solved answer = solved(
        room, [&](const Patch& p) { return p.face == 1 ? 1.0 : 0.0; }, [](const Patch&) { return 0.6; });
    int compared = 0;
    double worst = 0;
    for (std::size_t i = 0; i < room.patches.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const dvec3 mirrored = room.patches[j].centre * dvec3(-1, 1, 1); // the middle of the scene is the room's
            if (glm::distance(room.patches[i].centre, mirrored) > 1e-9) continue;
            if (answer.radiosity[i].x < 0.01) continue; // under the box
            worst = std::max(worst, std::abs(answer.radiosity[i].x / answer.radiosity[j].x - 1));
            ++compared;
        }
    EXPECT_GT(compared, 100);
    // Lines that are tried do not lie mirrored. Two patches, each wrong by its deviation at most, and four of these among some
    // hundred pairs.
    EXPECT_LT(worst, 4 * std::sqrt(2.0) * answer.largestDeviation);
    EXPECT_LT(answer.largestDeviation, 0.005); // 10,000 lines for all that a patch sees
}

TEST(SolvedRoom, EnergyIsKept) {
    const Room room(emptyRoom({2, 2, 2}), 0.5);
    const auto e = [](const Patch& p) { return p.face == 1 ? 1.0 : 0.0; };
    const auto rho = [](const Patch& p) { return p.face == 0 ? 0.2 : p.face == 2 ? 0.9 : 0.5; };
    const Solved answer = solved(room, e, rho);
    std::vector<dvec3> emission, reflectance;
    for (const Patch& patch : room.patches) {
        emission.emplace_back(e(patch));
        reflectance.emplace_back(rho(patch));
    }
    const EnergyBalance balance =
        energyBalance({answer.exchange, answer.areas, emission, reflectance}, answer.radiosity);
    EXPECT_NEAR(balance.emitted.x, 4, 1e-6); // the ceiling; vertices are floats
    EXPECT_LT(std::abs(balance.residual().x), 1e-9) << "what is not absorbed escapes";
    EXPECT_LT(std::abs(balance.closedResidual().x), 1e-6) << "and next to nothing escapes";
}

/// The same numbers in slices and for any number of threads.
TEST(SolvedRoom, ExchangeAreasInSlices) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({0.6, 1, 0.6}), glm::rotate(translation({1.5, 0.5, 2}), 0.3, dvec3(0, 1, 0)));
    const Room room(scene, 0.6);
    ExchangeBuilder whole(room.faces, room.patches, *room.occlusion, kLines),
        sliced(room.faces, room.patches, *room.occlusion, kLines);
    EXPECT_TRUE(whole.advance(std::chrono::steady_clock::time_point::max()));
    int slices = 1;
    double last = 0;
    for (; !sliced.advance(std::chrono::steady_clock::now()); ++slices) {
        EXPECT_GT(sliced.done(), last);
        last = sliced.done();
    }
    EXPECT_GT(slices, 10);
    std::size_t different = 0;
    for (std::size_t i = 0; i < room.patches.size(); ++i)
        different += !std::ranges::equal(whole.exchange().row(i), sliced.exchange().row(i));
    EXPECT_EQ(different, 0u);
    EXPECT_EQ(whole.counts().ofKind, sliced.counts().ofKind);
    EXPECT_EQ(whole.rowDeviations(), sliced.rowDeviations());
    std::size_t pairs = 0;
    for (const std::size_t count : whole.counts().ofKind)
        pairs += count;
    EXPECT_GT(pairs, room.patches.size() * room.patches.size() / 3); // all but those of one face
    EXPECT_GT(whole.counts().of(VisibleExchange::Kind::partial), 1000u);
}

} // namespace
} // namespace shadowlab::radiosity
