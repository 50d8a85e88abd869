// One point of a receiver plane, and all triangles on the line from the light through it: those that shadow it, and those
// that must not.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/planar/casters.h"
#include "techniques/planar/receivers/receivers.h"
#include "techniques/probed/plane_probe.h"
#include "techniques/technique.h"

namespace shadowlab::planar {

/// The triangles of all casters that the line through the light and the point meets, whichever side of light and plane they are
/// on. `lightWorld` is homogeneous; it must not lie in the plane.
PlaneProbe probePlane(const scene::Scene& scene, const Casters& casters, const ChosenReceiver& receiver,
                      const gl::EyeMatrices& eye, const dvec4& lightWorld, const dvec3& pointWorld);

} // namespace shadowlab::planar
