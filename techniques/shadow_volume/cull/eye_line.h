// The line from the eye to the light: which volumes the eye is in, decided by what stands on it.
//
// The eye is in a caster's volume as often as the line to the light crosses triangles of its cap. A walk that starts at the
// eye has to start with that number. Crow 1977 and Bergeron 1986 speak of such an initial count.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/cull/volume_in_view.h"

namespace shadowlab::shadow_volume {

/// False when the line from the eye to the light certainly passes by the box: then the eye is in no volume of what is
/// inside. The line ends at a point light, and never for a directional one (`lightWorld` is homogeneous).
bool eyeLineMayTouch(const scene::Bounds& box, const dvec3& eyeWorld, const dvec4& lightWorld);

/// Does the eye see through holes of the caster? Depth pass takes it that whoever looks along the cap of a volume sees the
/// caster there, and so draws no cap: through a hole the eye enters the volume, or leaves it, unseen.
bool eyeMaySeeThrough(const scene::Scene& scene, const CasterVolume& caster);

/// How many triangles of the caster's top cap the line crosses; 0 from beyond the plane where its volume ends. A line through an edge
/// or a corner is moved aside by an infinitesimal amount, the same for all triangles (simulation of simplicity,
/// Edelsbrunner and Mücke 1990).
int eyeCount(const scene::Scene& scene, const CasterVolume& caster, const VolumeEnd& end, const scene::Light& light,
             const dvec3& eyeWorld);

/// Does the line pass a silhouette edge so closely that the rasteriser and eyeCount() may disagree on which side? Also true of
/// some edges that the line does not come near, but whose extension it does.
bool eyeLineGrazes(const scene::Scene& scene, const CasterVolume& caster, const scene::Light& light,
                   const dvec3& eyeWorld);

} // namespace shadowlab::shadow_volume
