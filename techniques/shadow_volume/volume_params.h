// The parameters that all techniques with shadow volumes have.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/params/param.h"
#include "techniques/shadow_volume/count/face_counter.h"
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::shadow_volume {

struct VolumeParams {
    bool twoSided = true;
    bool cull = true;
    Construction construction = Construction::general;
    enum class End { receivers, infinity, distance } end = End::receivers;
    double extrusion =
        2; ///< metres; half of what most things in the built-in scenes stand above what they shadow, or more
    enum class ExtrudeOn { vertexShader, cpu } extrudeOn = ExtrudeOn::vertexShader;
    enum class Counter { automatic, stencil, floats } counter = Counter::automatic;
    StencilRule stencil;
    bool repair = false;
    friend bool operator==(const VolumeParams&, const VolumeParams&) = default;
};

params::ParamList describe(VolumeParams& params);

} // namespace shadowlab::shadow_volume
