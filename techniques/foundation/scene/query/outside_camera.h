// A position for a second camera, outside, that shows the objects of the scene, the lights, and the first camera.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The box around the objects in the scene without large flat ones: a floor may reach to the horizon, and its box says
/// nothing about the objects on it. Empty only if there are no objects, or nothing but emitters.
Bounds thingsBounds(const Scene& scene);

/// Where to draw the arrows of a directional light: between the objects and the light.
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
