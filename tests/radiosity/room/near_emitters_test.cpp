// What lies close to an emitter is cut by its distance.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/near_emitters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/exchange/exchange_builder.h"
#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kSide = 0.6;

/// A room of 4 x 3 x 4 m, and a plate that glows on all sides that far under its ceiling.
scene::Scene roomWithPlate(double gap) {
    scene::Scene scene = emptyRoom({4, 3, 4});
    scene.materials[0].diffuse = vec3(0.6f);
    scene::Material glowing;
    glowing.diffuse = vec3(0.3f);
    glowing.emission = vec3(6);
    scene.materials.push_back(glowing);
    addObject(scene, scene::makeBox({kSide, 0.02, kSide}), translation({2, 3 - gap - 0.01, 2})).partMaterials = {1};
    return scene;
}

RoomSettings settingsFor(const scene::Scene& scene, std::size_t patches, bool divides) {
    RoomSettings settings{patches, true, std::vector<bool>(scene.objects.size(), false)};
    settings.dividesNearEmitters = divides;
    return settings;
}

/// Mean radiosity of the floor, W/m^2.
double floorsRadiosity(const scene::Scene& scene, std::size_t budget, bool divides) {
    Room room(scene, settingsFor(scene, budget, divides));
    EXPECT_TRUE(room.advance(Deadline::max()));
    EXPECT_LE(room.patches().size(), budget);
    ExchangeBuilder builder(room.exchangingFaces(), room.patches(), room.occlusion(), 1e4);
    EXPECT_TRUE(builder.advance(Deadline::max()));
    const PreparedExchange exchange = preparedExchange(builder.take(), room.patches(), room.surroundings(), true);
    LightBalance balance;
    balance.restart(exchange, sourcesOf(room, {}, dvec3(0)), SolverKind::conjugateGradients);
    balance.advance({1e-6, 0}, 0, Deadline::max());
    double power = 0, area = 0;
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        const Patch& patch = room.patches()[i];
        if (std::abs(patch.centre.y + room.world().originWorld.y) > 1e-6 || patch.normal.y < 0.5) continue;
        power += patch.area * balance.radiosity()[i].x;
        area += patch.area;
    }
    EXPECT_NEAR(area, 16, 1e-6);
    return power / area;
}

// A patch of the ceiling that is larger than the plate spreads over the room what the plate would have taken back.
// Cut alike, 600 patches make it 6, 4 and 2 % too bright, and more patches help only from some thousand on; found 0.1, 0.1 and 0.6 %.
TEST(NearEmitters, ALampCloseToTheCeilingDoesNotMakeTheRoomTooBright) {
    for (const double gap : {0.1, 0.15, 0.25}) {
        const scene::Scene scene = roomWithPlate(gap);
        const double fine = floorsRadiosity(scene, 2400, true), coarse = floorsRadiosity(scene, 600, true), alike = floorsRadiosity(scene, 600, false);
        EXPECT_GT(fine, 0.1);
        EXPECT_NEAR(coarse / fine, 1, 0.01) << gap;
        EXPECT_GT(std::abs(alike / fine - 1), 0.015) << gap << ": the case is too easy";
    }
}

/// The largest diagonals of patches of the ceiling above the plate, and of the floor.
TEST(NearEmitters, OnlyWhatIsCloseAndSeesItIsCutFiner) {
    const scene::Scene scene = roomWithPlate(0.15);
    Room room(scene, settingsFor(scene, 600, true)), alike(scene, settingsFor(scene, 600, false));
    ASSERT_TRUE(room.advance(Deadline::max()) && alike.advance(Deadline::max()));
    const auto largest = [](const Room& of, bool isCeiling) {
        double most = 0;
        for (const Patch& patch : of.patches()) {
            const dvec3 centre = patch.centre + of.world().originWorld;
            const bool isAbovePlate = std::max(std::abs(centre.x - 2), std::abs(centre.z - 2)) < kSide / 2;
            if (of.faceOf(patch).object < 6 && (isCeiling ? patch.normal.y < -0.5 && isAbovePlate : patch.normal.y > 0.5))
                most = std::max(most, sizeOf(patch.polygon));
        }
        EXPECT_GT(most, 0);
        return most;
    };
    EXPECT_LE(largest(room, true), 2 * 0.15 + 1e-9) << "twice the distance";
    EXPECT_GT(largest(alike, true), 2 * 0.15);
    EXPECT_GT(largest(room, false), 0.9 * largest(alike, false)) << "the floor is far away";
    EXPECT_LT(largest(room, false), 1.5 * largest(alike, false)) << "and is not much coarser for it";
}

// No side of a sun-lit room is close to an emitter.
TEST(NearEmitters, WithoutEmittersNothingIsDivided) {
    scene::Scene scene = roomWithPlate(0.15);
    scene.materials[1].emission = vec3(0);
    const RoomSettings settings = settingsFor(scene, 300, true);
    Room room(scene, settings);
    ASSERT_TRUE(room.advance(Deadline::max()));
    EXPECT_FALSE(NearEmitters(room.tracer(), room.sides()).divided({}, 1, 300));
    const scene::Scene glowing = roomWithPlate(0.15);
    Room lit(glowing, settings);
    ASSERT_TRUE(lit.advance(Deadline::max()));
    EXPECT_TRUE(NearEmitters(lit.tracer(), lit.sides()).divided({}, 1, 300));
    EXPECT_FALSE(NearEmitters(lit.tracer(), lit.sides()).divided({}, 1, 3)) << "they are more than three";
}

// A room whose walls glow, as a furnace's do, is cut evenly.
TEST(NearEmitters, WhereMuchGlowsNothingIsDivided) {
    scene::Scene scene = roomWithPlate(0.15);
    scene.materials[0].emission = vec3(1);
    Room room(scene, settingsFor(scene, 300, true)), alike(scene, settingsFor(scene, 300, false));
    ASSERT_TRUE(room.advance(Deadline::max()) && alike.advance(Deadline::max()));
    EXPECT_FALSE(NearEmitters(room.tracer(), room.sides()).divided({}, 1, 300));
    EXPECT_EQ(room.patches().size(), alike.patches().size());
}

// Where all patches are eight times as long, as in rooms that matter little, these are as well.
TEST(NearEmitters, InOtherRoomsPiecesAreLarger) {
    const scene::Scene scene = roomWithPlate(0.15);
    Room room(scene, settingsFor(scene, 600, true));
    ASSERT_TRUE(room.advance(Deadline::max()));
    const auto piecesWith = [&](int doublings) {
        FaceParts parts(room.sides().exchanging);
        for (std::size_t f = 0; f < parts.size(); ++f)
            parts[f] = {{room.sides().faces.all[f].polygon, doublings}};
        const auto divided = NearEmitters(room.tracer(), room.sides()).divided(parts, 1, 1000);
        std::size_t count = 0;
        for (const auto& ofFace : divided.value_or(parts))
            count += ofFace.size();
        return count;
    };
    EXPECT_GT(piecesWith(0), 3 * piecesWith(3));
    EXPECT_GE(piecesWith(1), piecesWith(2));
}

} // namespace
} // namespace shadowlab::radiosity
