// Directions of the eye's and the light's cameras, in the scene and in the plane of a drawing.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/probe.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::figures {

/// The axes of the camera that a shadow map is drawn with, unit vectors: z_L, x_L, y_L.
struct MapAxes {
    dvec3 depthWorld{0, 0, -1}, acrossWorld{1, 0, 0}, upWorld{0, 1, 0};
};
MapAxes axesOf(const MapProbe& map);

/// The two directions in the section (unit) between which the section lies in the picture of the eye's camera. `size`: of the
/// picture, in pixels; `eye`: the eye in the section, whose origin is the point that the pixel shows.
std::array<dvec2, 2> viewWedge(const scene::Camera& camera, ivec2 size, const LightSection& section, dvec2 eye);

} // namespace shadowlab::figures
