// What moves by itself while the window plays: the lights around the scene, the camera, objects along their velocities.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::lab {

struct Animation {
    bool playing = false;
    bool lights = true, camera = false, objects = true; ///< what takes part
    double speed = 1;                                   ///< times kTurnDegreesPerSecond, and of the objects' own speed
    double seconds = 0;                                 ///< since it began, at speed 1
};

constexpr double kTurnDegreesPerSecond = 20; ///< slow enough to follow a shadow with the eye
constexpr double kSlowest = 1.0 / 16, kFastest = 16;

/// The scene after so many seconds: a function of the scene at rest, so that nothing drifts. Objects go to and fro.
scene::Snapshot animated(const scene::Snapshot& atRest, const Animation& animation);

} // namespace shadowlab::lab
