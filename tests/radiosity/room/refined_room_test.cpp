// Rooms whose patches are cut where light changes: what is known is not looked for again, and the light comes out better.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/radiosity/exchange/exchange_builder.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/room/refinement.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kLines = 1000;
constexpr auto kNever = std::chrono::steady_clock::time_point::max();

/// Every third patch, and what balance there must be is not asked for here.
std::vector<Refinement> everyThird(std::size_t patches) {
    std::vector<Refinement> cuts;
    for (std::uint32_t i = 1; i < patches; i += 3)
        cuts.push_back({i, Refinement::Reason::gradient});
    return cuts;
}

TEST(RefinedRoom, WhatIsKnownIsTakenOver) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({0.6, 1, 0.6}), glm::rotate(translation({1.5, 0.5, 2}), 0.3, dvec3(0, 1, 0)));
    Room room(scene, 0.7);
    room.patches = cutAtContacts(room.faces, room.patches);
    ExchangeBuilder before(room.faces, room.patches, *room.occlusion, kLines);
    ASSERT_TRUE(before.advance(kNever));
    const Refined finer = refined(room.patches, everyThird(room.patches.size()), {});
    ExchangeBuilder afresh(room.faces, finer.patches, *room.occlusion, kLines),
        sliced(room.faces, finer.patches, *room.occlusion, kLines,
               KnownExchange{before, before.exchange(), finer.from});
    ASSERT_TRUE(afresh.advance(kNever));
    int slices = 1;
    for (; !sliced.advance(std::chrono::steady_clock::now()); ++slices)
        EXPECT_LT(sliced.done(), 1);
    EXPECT_GT(slices, 10);
    std::size_t different = 0, taken = 0;
    for (std::size_t i = 0; i < finer.patches.size(); ++i) {
        different += !std::ranges::equal(afresh.exchange().row(i), sliced.exchange().row(i));
        for (std::size_t j = 0; j < i; ++j)
            taken += finer.from[i] != Refined::kNew && finer.from[j] != Refined::kNew && sliced.exchange()(i, j) > 0;
    }
    // Which lines are tried between two patches depends on these alone.
    EXPECT_EQ(different, 0u);
    EXPECT_GT(taken, 3000u);
    using Kind = VisibleExchange::Kind;
    const ExchangeCounts ofAfresh = afresh.counts(), ofSliced = sliced.counts();
    for (const Kind kind : {Kind::full, Kind::partial}) {
        EXPECT_EQ(ofAfresh.of(kind), ofSliced.of(kind));
        EXPECT_GT(ofAfresh.of(kind), 1000u);
    }
    EXPECT_EQ(ofAfresh.of(Kind::none) + ofAfresh.of(Kind::hidden), ofSliced.of(Kind::none) + ofSliced.of(Kind::hidden));
    EXPECT_NEAR(static_cast<double>(ofAfresh.of(Kind::hidden)), static_cast<double>(ofSliced.of(Kind::hidden)), 30);
    EXPECT_EQ(afresh.rowDeviations(), sliced.rowDeviations());
    EXPECT_GT(ofAfresh.of(Kind::hidden), 1000u);
}

TEST(RefinedRoom, AnEmptyRoomStaysClosed) {
    const Room room(emptyRoom({3, 2, 4}), 0.7);
    ExchangeBuilder before(room.faces, room.patches, *room.occlusion, kLines);
    ASSERT_TRUE(before.advance(kNever));
    const Refined finer = refined(room.patches, everyThird(room.patches.size()), {});
    ExchangeBuilder after(room.faces, finer.patches, *room.occlusion, kLines,
                          KnownExchange{before, before.exchange(), finer.from});
    ASSERT_TRUE(after.advance(kNever));
    std::vector<double> areas;
    for (const Patch& patch : finer.patches)
        areas.push_back(patch.area);
    for (const double sum : rowSums(after.exchange(), areas))
        ASSERT_NEAR(sum, 1, 1e-7); // some hundred terms, each right to a ten millionth
}

// A point light over a box in the air: a room with shadows on its floor and walls.
constexpr dvec3 kLightWorld{1.1, 1.35, 0.9};
constexpr double kIntensity = 5, kReflectance = 0.5;

scene::Scene roomWithScreen() {
    scene::Scene scene = emptyRoom({2, 1.5, 2});
    addObject(scene, scene::makeBox({0.5, 0.04, 0.5}), translation({1.2, 0.7, 0.8}));
    return scene;
}

/// The irradiance of a point by the light itself, and 0 where it is hidden.
double direct(const Room& room, const dvec3& positionCentred, const dvec3& normal) {
    static const Blockers kBox{6, 7, 8, 9, 10, 11};
    const dvec3 toLight = kLightWorld - room.originWorld - positionCentred;
    const double distance = glm::length(toLight), cosine = glm::dot(normal, toLight) / distance;
    if (cosine <= 0 || room.occlusion->isBlocked(kBox, positionCentred + 1e-9 * normal, positionCentred + toLight))
        return 0;
    return kIntensity * cosine / (distance * distance);
}

/// The mean over each patch, by eight times eight points.
DirectLight directLight(const Room& room, const std::vector<Patch>& patches) {
    DirectLight light;
    for (const Patch& patch : patches) {
        constexpr int kSide = 8;
        const Polygon& q = patch.polygon;
        double sum = 0, seen = 0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const double s = (i % kSide + 0.5) / kSide, t = (i / kSide + 0.5) / kSide;
            const double here =
                direct(room, glm::mix(glm::mix(q[0], q[1], s), glm::mix(q[3], q[2], s), t), patch.normal);
            sum += here;
            seen += here > 0;
        }
        light.visible.push_back(seen / (kSide * kSide));
        light.irradiance.emplace_back(sum / (kSide * kSide));
    }
    return light;
}

struct Solution {
    std::vector<Patch> patches;
    std::vector<dvec3> radiosity;
};

Solution solved(const std::vector<Patch>& patches, const DirectLight& light, const ExchangeMatrix& exchange) {
    std::vector<double> areas;
    std::vector<dvec3> emission; // what the light itself brings, once reflected
    for (std::size_t i = 0; i < patches.size(); ++i) {
        areas.push_back(patches[i].area);
        emission.push_back(kReflectance * light.irradiance[i]);
    }
    const std::vector<dvec3> rho(patches.size(), dvec3(kReflectance));
    const auto solver = makeSolver(SolverKind::conjugateGradients, {exchange, areas, emission, rho});
    EXPECT_TRUE(solve(*solver, 1e-6, 100));
    return {patches, solver->radiosity()};
}

/// The patch in which a point of a face lies.
std::size_t patchAt(const std::vector<Patch>& patches, std::uint32_t face, const dvec3& positionCentred) {
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Polygon& p = patches[i].polygon;
        bool isInside = patches[i].face == face;
        for (std::size_t k = 0; k < p.count() && isInside; ++k) {
            const dvec3 edge = p[(k + 1) % p.count()] - p[k];
            isInside = glm::dot(patches[i].normal, glm::cross(edge, positionCentred - p[k])) > -1e-9;
        }
        if (isInside) return i;
    }
    ADD_FAILURE() << "no patch there";
    return 0;
}

/// The mean difference to the light itself at each point plus what is reflected in a uniform solution, which is smooth; by the
/// mean of both.
double meanError(const Room& room, const Solution& solution, const Solution& smooth, const DirectLight& ofSmooth) {
    double sum = 0, whole = 0;
    for (const Patch& point : cutIntoPatches(room.faces, 0.06)) {
        const std::size_t here = patchAt(solution.patches, point.face, point.centre),
                          there = patchAt(smooth.patches, point.face, point.centre);
        const double truth = kReflectance * direct(room, point.centre, point.normal) + smooth.radiosity[there].x -
                             kReflectance * ofSmooth.irradiance[there].x;
        sum += point.area * std::abs(solution.radiosity[here].x - truth);
        whole += point.area * truth;
    }
    return sum / whole;
}

TEST(RefinedRoom, AsManyPatchesShowMore) {
    const auto uniform = [](const Room& room, const DirectLight& light) {
        ExchangeBuilder builder(room.faces, room.patches, *room.occlusion, kLines);
        EXPECT_TRUE(builder.advance(kNever));
        return solved(room.patches, light, builder.exchange());
    };
    const Room fine(roomWithScreen(), 0.2);
    const DirectLight fineLight = directLight(fine, fine.patches);
    const Solution fineSolution = uniform(fine, fineLight);

    const Room coarse(roomWithScreen(), 0.5);
    auto mesh = std::make_unique<Refined>(Refined{coarse.patches, {}, {}, {}});
    auto builder = std::make_unique<ExchangeBuilder>(coarse.faces, mesh->patches, *coarse.occlusion, kLines);
    ASSERT_TRUE(builder->advance(kNever));
    DirectLight light = directLight(coarse, mesh->patches);
    Solution solution = solved(mesh->patches, light, builder->exchange());
    const double coarseError = meanError(coarse, solution, fineSolution, fineLight);
    int rounds = 0;
    for (;; ++rounds) {
        const RefinementLimits limits{.mostPatches = std::min(fine.patches.size(), mesh->patches.size() * 3 / 2),
                                      .smallestError = 0.005};
        const auto cuts =
            patchesToRefine(mesh->patches, patchBorders(coarse.faces, mesh->patches), solution.radiosity,
                            std::vector<dvec3>(mesh->patches.size(), dvec3(kReflectance)), {{light}}, limits);
        if (cuts.empty()) break;
        auto finer = std::make_unique<Refined>(refined(mesh->patches, cuts, {}));
        auto next = std::make_unique<ExchangeBuilder>(coarse.faces, finer->patches, *coarse.occlusion, kLines,
                                                      KnownExchange{*builder, builder->exchange(), finer->from});
        ASSERT_TRUE(next->advance(kNever));
        builder = std::move(next);
        mesh = std::move(finer);
        light = directLight(coarse, mesh->patches);
        solution = solved(mesh->patches, light, builder->exchange());
    }
    const double error = meanError(coarse, solution, fineSolution, fineLight),
                 uniformError = meanError(coarse, fineSolution, fineSolution, fineLight);
    RecordProperty("coarse", std::to_string(coarseError));
    RecordProperty("refined", std::to_string(error));
    RecordProperty("uniform", std::to_string(uniformError));
    EXPECT_GE(rounds, 3);
    EXPECT_LE(mesh->patches.size(), fine.patches.size());
    EXPECT_GT(mesh->patches.size(), fine.patches.size() - 30);
    // Found: 0.24 of 86 coarse patches; 0.062 of 548, refined in 5 rounds; 0.087 of 550 all of one size.
    EXPECT_LT(uniformError, 0.5 * coarseError);
    EXPECT_LT(error, 0.8 * uniformError);
}

} // namespace
} // namespace shadowlab::radiosity
