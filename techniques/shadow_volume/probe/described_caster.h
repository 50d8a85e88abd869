// What a probe tells of the volume of one caster: for texts and drawings.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/shadow_probe.h"
#include "techniques/shadow_volume/probe/shapes.h"

namespace shadowlab::shadow_volume {

/// The volume as stages show it (of a closed mesh the lit half), and `end` as it is drawn. Whose it is stays to be said.
VolumeProbe::Caster describedCaster(const scene::Scene& scene, const scene::Light& light, const CasterVolume& caster,
                                    const ShownVolume& shown, const VolumeEnd& end);

/// "ball: 112 of 224 triangles face the light, 32 outline edges, extruded by 2 m"
std::string casterText(const scene::Scene& scene, const VolumeProbe::Caster& caster);

} // namespace shadowlab::shadow_volume
