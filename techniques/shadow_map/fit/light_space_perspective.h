// Light space perspective shadow maps: the map is seen through a perspective of its own, at right angles to the light, so
// that texels near the eye get smaller and far ones larger.
//
// Wimmer, Scherzer and Purgathofer, "Light Space Perspective Shadow Maps", EGSR 2004. How strong the perspective is follows
// from their n_opt = (z_n + sqrt(z_n z_f)) / sin(gamma), gamma the angle between light and view: with the light from ahead
// or behind it vanishes, and the map is an ordinary one. Kept to directional lights here, and to the box that casters and
// receivers share in place of the paper's convex hull.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/fit/fit.h"

namespace shadowlab::shadow_map {

/// The light's camera, turned about its axis so that +y is where the eye looks.
dmat4 lookAlongForWarp(const dvec3& forward, const scene::Camera& camera);

/// Clip from view of a light's camera made by lookAlongForWarp, of that box; `share` as guardShare.
dmat4 warpedProjection(const Box& box, const scene::Light& light, const FitEye& eye, double share);

} // namespace shadowlab::shadow_map
