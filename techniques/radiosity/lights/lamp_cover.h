// What lamps cover: the part of a ceiling that a rect lies in, or hangs close before, and of a wall into which a ball is sunk the circle within it; and how much light would meet lamps on its way.
//
// Lamps are no patches, so that they may move without a new room. But what a lamp covers reflects nothing into the room, for it is the
// lamp that is seen there, and lamps reflect nothing. So the reflectance of a patch is that of the part of it that is not covered.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

/// The share of the patch that lamps cover, 0..1; where they overlap, at most all of it. Patches are in centred space, whose origin lies at
/// `originWorld`. Rects count that lie in its plane or close above (kCloseAbove in
/// contacts.h) and shine the way the patch faces, and spheres that cut its plane.
double coveredByLamps(const Patch& patch, std::span<const scene::Light> lights, const dvec3& originWorld);

/// Of all light that the patches send (their radiosities, W/m^2), the share that meets a lamp with an area, 0..1, if nothing else is in its
/// way. By the form factors from the centres of patches, so that patches must not be large beside their
/// distance to a lamp.
double caughtByLamps(std::span<const Patch> patches, std::span<const dvec3> radiosity, std::span<const scene::Light> lights,
                     const dvec3& originWorld);

} // namespace shadowlab::radiosity
