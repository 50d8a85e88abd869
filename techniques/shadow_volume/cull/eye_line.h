// Which volumes is the eye in? The casters on the line from the eye to the light decide it.
//
// The eye is in a caster's volume as many times as the line to the light crosses triangles of its top cap. Depth pass has
// to start its count with that number: the initial count of Crow 1977 and Bergeron 1986.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/cull/volume_in_view.h"

namespace shadowlab::shadow_volume {

/// False when the line from the eye to the light certainly passes by the box: then the eye is in no volume of what is
/// inside. The line ends at a point light, and never for a directional one (`lightWorld` is homogeneous).
bool eyeLineMayTouch(const scene::Bounds& box, const dvec3& eyeWorld, const dvec4& lightWorld);

/// True if the caster has holes. Depth pass draws no top cap, because a caster hides what lies behind its own cap. Through
/// a hole the line of sight enters or leaves the volume without crossing a face that is drawn.
bool eyeMaySeeThrough(const scene::Scene& scene, const CasterVolume& caster);

/// How many triangles of the caster's top cap the line crosses; 0 from beyond the plane where its volume ends. A line through an edge
/// or a corner is moved aside by an infinitesimal amount, the same for all triangles (simulation of simplicity,
/// Edelsbrunner and Mücke 1990).
int eyeCount(const scene::Scene& scene, const CasterVolume& caster, const VolumeEnd& end, const scene::Light& light,
             const dvec3& eyeWorld);

/// True if the line passes a silhouette edge so closely that the rasteriser and eyeCount() may disagree on the side.
/// Conservative: also true near the extension of an edge.
bool eyeLineGrazes(const scene::Scene& scene, const CasterVolume& caster, const scene::Light& light,
                   const dvec3& eyeWorld);

} // namespace shadowlab::shadow_volume
