// What rect lamps cover: the part of a ceiling that a lamp lies in, or hangs close before.
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
/// `originWorld`. Only lamps count that lie in its plane or close above (kCloseAbove in
/// contacts.h), and shine the way the patch faces.
double coveredByLamps(const Patch& patch, std::span<const scene::Light> lights, const dvec3& originWorld);

} // namespace shadowlab::radiosity
