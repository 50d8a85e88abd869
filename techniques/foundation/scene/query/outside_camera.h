// A place for a second camera that looks on from outside: at the things in the scene, the lights, and the first camera.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The box around what stands in the scene. Large flat things do not count: a floor reaches to the horizon, and the box
/// of a floor says nothing about what happens on it. Empty only if there are no objects, or nothing but emitters.
Bounds thingsBounds(const Scene& scene);

/// From where a directional light comes, as a place to draw its arrows at: before the things, on their way to the light.
struct ArrowPlace {
    dvec3 tipWorld{0.0}; ///< of the middle one
    double length = 1;   ///< metres
    double spread = 0.4; ///< metres, from the middle one to those around it
};
ArrowPlace arrowPlace(const Bounds& things, const Light& directional);

/// The second camera: beside, behind and above the eye, and so far away that the things, the eye and the lights near them
/// are in the picture, arrows of directional lights included. Of several such places, the one from which walls and roofs
/// hide least. `aspect` is width over height.
Camera outsideCameraFor(const Scene& scene, const Camera& eye, double aspect = 16.0 / 9.0);

/// That camera for a picture of another shape: one narrower than 16:9 sees as much to the sides, and more above and below.
Camera widenedFor(Camera outside, double aspect);

} // namespace shadowlab::scene
