// Closed rooms in a row, of which the eye is in one: what the others hold does not matter to its picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <utility>

#include "tests/radiosity/scene_room.h"

namespace shadowlab::testing {

// Each room is 3 m wide, and a metre lies between it and the next.
constexpr double kRoomStep = 4, kRoomDepth = 4;

inline dvec3 placeOfRoom(int room) { return {kRoomStep * room, 0, 0}; }

/// Rooms of 3 x 2 x 4 m, of six walls each, without lights.
inline scene::Scene roomRow(int rooms) {
    scene::Scene row = emptyRoom({3, 2, kRoomDepth});
    for (scene::Object& wall : row.objects)
        if (wall.worldFromObject[3].y == 0) wall.name = "floor";
    const std::vector<scene::Object> walls = row.objects;
    for (int i = 1; i < rooms; ++i)
        for (scene::Object wall : walls) {
            wall.worldFromObject = translation(placeOfRoom(i)) * wall.worldFromObject;
            row.objects.push_back(std::move(wall));
        }
    return row;
}

/// It looks along the floor into a corner.
inline scene::Camera inRoom(int room) {
    scene::Camera camera;
    camera.positionWorld = placeOfRoom(room) + dvec3(2.2, 1.5, 3.6);
    camera.targetWorld = placeOfRoom(room) + dvec3(1, 0.7, 0.5);
    camera.fovYDegrees = 60;
    return camera;
}

} // namespace shadowlab::testing
