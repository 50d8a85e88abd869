// What there is to say about one pixel and a light that has an area.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/probe.h"
#include "techniques/ray_tracing/tree/surfaces.h"

namespace shadowlab::ray_tracing {

/// How much of the light's area the point sees, whether that is umbra, penumbra or full light, and what it receives: in closed
/// form, however the picture finds it. The light must have an area.
void describeArea(const Surfaces& surfaces, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                  Probe& probe);

} // namespace shadowlab::ray_tracing
