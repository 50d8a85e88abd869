// SPDX-License-Identifier: MIT
#include "app/lab/animation.h"

#include <cmath>

#include "app/film/orbit.h"
#include "techniques/foundation/scene/model/edit_scene.h"

namespace shadowlab::lab {

namespace {

/// Out for two seconds and back for two: a thing that flew on would leave the picture for good.
double toAndFro(double seconds) {
    constexpr double kOneWay = 2;
    const double phase = std::fmod(seconds, 2 * kOneWay);
    return phase < kOneWay ? phase : 2 * kOneWay - phase;
}

} // namespace

scene::Snapshot animated(const scene::Snapshot& atRest, const Animation& animation) {
    scene::Snapshot snapshot = atRest;
    if (animation.objects) snapshot = scene::atTime(snapshot, toAndFro(animation.seconds));
    if (animation.lights && animation.seconds != 0)
        snapshot = film::withLightsTurned(snapshot, kTurnDegreesPerSecond * animation.seconds);
    return snapshot;
}

} // namespace shadowlab::lab
