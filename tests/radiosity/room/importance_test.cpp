// What matters to the picture is cut finely, all else coarsely.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/importance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/radiosity/room/room.h"
#include "tests/radiosity/room_row.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr std::size_t kBudget = 300;
constexpr ivec2 kSize(160, 90);

/// Of a row of rooms; patches that stand in each of them.
std::vector<std::size_t> patchesOfRooms(int rooms, const std::optional<Eye>& eye) {
    const scene::Scene scene = roomRow(rooms);
    Room room(scene, {kBudget, true, std::vector<bool>(scene.objects.size(), false)}, eye);
    EXPECT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_LE(room.patches().size(), kBudget);
    std::vector<std::size_t> counts(static_cast<std::size_t>(rooms), 0);
    for (const Patch& patch : room.patches())
        ++counts[room.faceOf(patch).object / 6]; // six walls each
    return counts;
}

TEST(Importance, OtherRoomsAreCutCoarsely) {
    for (const std::size_t count : patchesOfRooms(3, std::nullopt))
        EXPECT_NEAR(static_cast<double>(count), 64, 6) << "alike, but for rounding where edges are as long as the size";
    for (const std::size_t own : {0u, 1u, 2u}) {
        const std::vector<std::size_t> counts = patchesOfRooms(3, Eye{inRoom(static_cast<int>(own)), kSize});
        for (std::size_t i = 0; i < counts.size(); ++i)
            if (i == own)
                EXPECT_GE(counts[i], kBudget * 2 / 3) << i << ": sizes go in steps, and all walls of a room take one together";
            else
                EXPECT_LE(counts[i], 12u) << i << ": one patch or two for each wall";
    }
}

// A room of its own is cut as if there were no eye, wherever that stands and looks.
TEST(Importance, OneRoomIsCutEvenly) {
    const scene::Scene scene = roomRow(1);
    for (const dvec3& target : {dvec3(0, 1, 0), dvec3(3, 0.2, 0.2), dvec3(1.5, 2, 2)}) {
        scene::Camera camera = inRoom(0);
        camera.targetWorld = target;
        Room room(scene, {kBudget, true, std::vector<bool>(6, false)}, Eye{camera, kSize});
        ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
        EXPECT_TRUE(room.importance().parts().empty());
        EXPECT_TRUE(room.importance().cutsLike(Importance()));
    }
}

/// One floor, the last object, runs through three rooms.
scene::Scene roomsOnOneFloor() {
    scene::Scene scene = roomRow(3);
    std::erase_if(scene.objects, [](const scene::Object& object) { return object.name == "floor"; });
    addObject(scene, scene::makeQuad({kRoomStep * 3, kRoomDepth}), translation({1.5 * kRoomStep, 0, 0.5 * kRoomDepth}));
    return scene;
}

TEST(Importance, AFaceIsDividedWherePartsOfItMatterDifferently) {
    const scene::Scene scene = roomsOnOneFloor();
    Room room(scene, {kBudget, true, std::vector<bool>(scene.objects.size(), false)}, Eye{inRoom(0), kSize});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    double near = 0, far = 0; // areas of the largest patches
    for (const Patch& patch : room.patches()) {
        if (room.faceOf(patch).object + 1 != scene.objects.size()) continue;
        const double x = room.world().originWorld.x + patch.centre.x;
        if (x < 0.6 * kRoomStep) near = std::max(near, patch.area);
        if (x > 2 * kRoomStep) far = std::max(far, patch.area);
    }
    EXPECT_GT(near, 0);
    EXPECT_GT(far, 8 * near);
}

// A budget that the whole faces just fit is kept, and not used up by parts of them.
TEST(Importance, PartsOfFacesNeverExceedTheBudget) {
    const scene::Scene scene = roomsOnOneFloor();
    const std::vector<bool> noLights(scene.objects.size(), false);
    Room coarsest(scene, {1, true, noLights});
    ASSERT_TRUE(coarsest.advance(std::chrono::steady_clock::time_point::max()));
    const std::size_t least = coarsest.patches().size();
    bool isEverUsed = false;
    for (std::size_t budget = least; budget < 3 * least; ++budget) {
        Room room(scene, {budget, true, noLights}, Eye{inRoom(0), kSize});
        ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
        EXPECT_LE(room.patches().size(), budget);
        EXPECT_TRUE(room.importance().cutsLike(room.importanceTo(Eye{inRoom(0), kSize}))) << "so it is not cut anew for ever";
        EXPECT_TRUE(budget > least || !room.usesImportance()) << "the case is too easy";
        isEverUsed = isEverUsed || room.usesImportance();
    }
    EXPECT_TRUE(isEverUsed);
}

TEST(Importance, ItIsAlwaysTheSameForTheSameEye) {
    const scene::Scene scene = roomRow(3);
    Room room(scene, {kBudget, true, std::vector<bool>(scene.objects.size(), false)}, Eye{inRoom(1), kSize});
    ASSERT_TRUE(room.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_TRUE(room.importance().cutsLike(room.importanceTo(Eye{inRoom(1), kSize})));
    EXPECT_FALSE(room.importance().cutsLike(room.importanceTo(Eye{inRoom(2), kSize})));
    EXPECT_FALSE(room.importance().cutsLike(room.importanceTo(std::nullopt)));
    scene::Camera away = inRoom(1);
    away.positionWorld = away.targetWorld + dvec3(0, 1000, 0);
    away.targetWorld = away.positionWorld + dvec3(0, 1000, 0);
    EXPECT_TRUE(room.importanceTo(Eye{away, kSize}).parts().empty()) << "it sees nothing";
}

} // namespace
} // namespace shadowlab::radiosity
