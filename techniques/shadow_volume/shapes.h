// What there is of the shadow volumes in the scene, for a camera that looks on from outside.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/shadow_volume/casters.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_volume {

/// Silhouette edges, sides and, `withCaps`, the caps of the volumes of these casters, cut off a little beyond the scene; of
/// closed meshes only the lit half, as the lecture draws it. And the near-clip pyramid.
std::vector<SceneShape> volumeShapes(const scene::Scene& scene, const View& view, int light,
                                     std::span<const CasterVolume* const> casters, bool withCaps);

/// The near rectangle of the view joined to the light, as lines: what stands in it casts its shadow on the near plane, and
/// there depth pass starts counting from a wrong number. Everitt and Kilgard 2002; Hornus, Hoberock, Lefebvre and Hart,
/// "ZP+: Correct Z-pass Stencil Shadows", 2005.
SceneShape nearClipPyramid(const scene::Scene& scene, const View& view, int light);

} // namespace shadowlab::shadow_volume
