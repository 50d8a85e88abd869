// Light does not creep under a wall: not into the room behind it, and around its end only.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/radiosity/exchange/exchange_builder.h"
#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/interpolation/interpolated.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kWall = 1.73; // at no multiple of the patches' size

/// Of patches whose ceiling shines on the near side of the wall.
std::vector<dvec3> solved(const Room& room) {
    ExchangeBuilder builder(room.faces, room.patches, *room.occlusion, 1000);
    EXPECT_TRUE(builder.advance(std::chrono::steady_clock::time_point::max()));
    std::vector<double> areas;
    std::vector<dvec3> e, rho(room.patches.size(), dvec3(0.8));
    for (const Patch& patch : room.patches) {
        areas.push_back(patch.area);
        e.emplace_back(patch.face == 1 && patch.centre.z + room.originWorld.z < 1.2 ? 1 : 0);
    }
    const auto solver = makeSolver(SolverKind::conjugateGradients, {builder.exchange(), areas, e, rho});
    EXPECT_TRUE(solve(*solver, 1e-6, 100));
    return solver->radiosity();
}

/// The brightest that is shown behind the wall: at corners as they are made here, and at means of all patches that have a
/// corner in that place, whatever stands between them.
struct Behind {
    dvec3 ours{0.0}, ofMeans{0.0};
    int corners = 0;
};
Behind behind(const Room& room, double wallEnd, const std::vector<dvec3>& radiosity) {
    const PatchCorners corners = patchCorners(room.faces, room.patches);
    const std::vector<dvec3> values = corners.values(radiosity);
    const PatchBorders& borders = corners.borders;
    std::vector<dvec3> sums(borders.pointsCentred.size(), dvec3(0.0));
    std::vector<double> counts(borders.pointsCentred.size(), 0.0);
    for (const PatchBorders::Piece& piece : borders.pieces) {
        sums[piece.point] += radiosity[piece.patch];
        ++counts[piece.point];
    }
    Behind found;
    for (std::size_t piece = 0; piece < borders.pieces.size(); ++piece) {
        if (room.patches[borders.pieces[piece].patch].centre.z + room.originWorld.z < wallEnd + 1e-6) continue;
        const std::uint32_t point = borders.pieces[piece].point;
        found.ours = glm::max(found.ours, values[corners.cornerOfPiece[piece]]);
        found.ofMeans = glm::max(found.ofMeans, sums[point] / counts[point]);
        ++found.corners;
    }
    return found;
}

TEST(PartedRoom, TheDarkSideStaysExactlyDark) {
    for (const bool isSheet : {true, false}) {
        scene::Scene scene = emptyRoom({3, 2, 4});
        if (isSheet)
            addObject(scene, scene::makeQuad({3, 2}),
                      translation({1.5, 1, kWall}) * glm::rotate(dmat4(1), -glm::half_pi<double>(), dvec3(1, 0, 0)));
        else
            addObject(scene, scene::makeBox({3, 2, 0.1}), translation({1.5, 1, kWall}));
        Room room(scene, 0.5);
        room.patches = cutAtContacts(room.faces, room.patches);
        const std::vector<dvec3> radiosity = solved(room);
        const double end = isSheet ? kWall : kWall + 0.05;
        const Behind found = behind(room, end, radiosity);
        EXPECT_GT(found.corners, 400);
        EXPECT_EQ(found.ours, dvec3(0.0)) << isSheet;
        if (isSheet) {
            EXPECT_GT(found.ofMeans.x, 0.05) << "means over the wall should leak";
        }
    }
}

/// A wall that ends in the middle of the floor: what it parts comes together at its end.
TEST(PartedRoom, AFreeStandingWallPartsWhereItStands) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({4, 4}));
    addObject(scene, scene::makeQuad({1.7, 1}),
              translation({-0.05, 0.5, 0.13}) * glm::rotate(dmat4(1), -glm::half_pi<double>(), dvec3(1, 0, 0)));
    Room room(scene, 0.25);
    room.patches = cutAtContacts(room.faces, room.patches);
    std::vector<dvec3> radiosity;
    for (const Patch& patch : room.patches)
        radiosity.emplace_back(patch.centre.z + room.originWorld.z < 0.13 ? 1 : 0);
    const PatchCorners corners = patchCorners(room.faces, room.patches);
    const std::vector<dvec3> values = corners.values(radiosity);
    int parted = 0, joined = 0, ends = 0;
    for (std::size_t piece = 0; piece < corners.borders.pieces.size(); ++piece) {
        const PatchBorders::Piece& here = corners.borders.pieces[piece];
        if (room.patches[here.patch].face != 0) continue;
        const dvec3 point = corners.borders.pointsCentred[here.point] + room.originWorld;
        if (std::abs(point.z - 0.13) > 1e-6) continue;
        const double value = values[corners.cornerOfPiece[piece]].x, fromMiddle = std::abs(point.x + 0.05);
        if (fromMiddle < 0.85 - 1e-6) {
            // Close to an end, patches beyond it have a say in how the light goes on; on their own side they are few.
            EXPECT_NEAR(value, radiosity[here.patch].x, fromMiddle < 0.6 ? 0 : 0.2) << point.x;
            ++parted;
        } else {
            EXPECT_GT(value, 0.05) << point.x;
            EXPECT_LT(value, 0.95) << point.x;
            ++joined;
            ends += fromMiddle < 0.85 + 1e-6;
        }
    }
    EXPECT_EQ(parted, 28) << "seven places, two sides, two patches";
    EXPECT_EQ(joined, 10);
    EXPECT_EQ(ends, 4) << "on both sides of both ends";
}

/// A floor of one object but two faces, and a wall exactly where these meet, on one half of it.
TEST(PartedRoom, AWallOnTheSeamOfTwoFacesPartsThem) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, triangleSoup({{-2, 0, -2},
                                   {-2, 0, 2},
                                   {0, 0, 2},
                                   {-2, 0, -2},
                                   {0, 0, 2},
                                   {0, 0, -2},
                                   {0, 0, -2},
                                   {0, 0, 2},
                                   {2, 0, 2},
                                   {0, 0, -2},
                                   {2, 0, 2},
                                   {2, 0, -2}}));
    addObject(scene, triangleSoup({{0, 0, -2}, {0, 0, 0}, {0, 1, 0}}));
    Room room(scene, 1);
    room.patches = cutAtContacts(room.faces, room.patches);
    ASSERT_EQ(std::ranges::count_if(room.patches, [](const Patch& p) { return p.face < 2; }), 16);
    const PatchBorders borders = patchBorders(room.faces, room.patches);
    int open = 0, closed = 0;
    for (std::uint32_t piece = 0; piece < borders.pieces.size(); ++piece) {
        const auto pointWorld = [&](std::uint32_t of) {
            return borders.pointsCentred[borders.pieces[of].point] + room.originWorld;
        };
        const dvec3 from = pointWorld(piece), to = pointWorld(borders.after(piece));
        if (room.patches[borders.pieces[piece].patch].face > 1 || std::abs(from.x) + std::abs(to.x) > 1e-6) continue;
        const bool isOpen = borders.pieces[piece].across != PatchBorders::kNone;
        EXPECT_EQ(isOpen, from.z + to.z > 0) << from.z << ' ' << to.z;
        (isOpen ? open : closed) += 1;
    }
    EXPECT_EQ(open, 4);
    EXPECT_EQ(closed, 4);
}

} // namespace
} // namespace shadowlab::radiosity
