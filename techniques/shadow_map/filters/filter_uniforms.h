// What the filters' shaders have to know (shaders/shadow_map/filter_*.glsl).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/scene/model/light.h"
#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// Metres from the light's middle to its border, of a directional light at a distance of 1 m: by its own area, or as it was
/// given one. 0: it has no penumbra.
double lightReach(const scene::Light& light, const FilterParams& params);

/// How the filter's shader reads the depths of a map.
gl::DepthSampling depthSampling(const FilterParams& filter, BiasParams::Mode bias);

/// Does the bias compare all texels of a kernel with one depth (shaders/shadow_map/bias_*.glsl)?
bool comparesWithOneDepth(BiasParams::Mode mode);

/// The program is in use; uniforms that it does not have are passed over.
void setFilterUniforms(const gl::Program& program, const scene::Light& light, const FilterParams& filter,
                       const LightMaps& maps);

} // namespace shadowlab::shadow_map
