// What the filters' shaders have to know (shaders/shadow_map/filter_*.glsl).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/scene/light.h"
#include "techniques/shadow_map/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// Is the light large enough for a penumbra: has it an area, or was it given one?
bool hasPenumbra(const scene::Light& light, const FilterParams& params);

/// How the filter's shader reads the depths of a map.
gl::DepthSampling depthSampling(const FilterParams& filter, BiasParams::Mode bias);

/// Does the bias compare all texels of a kernel with one depth (shaders/shadow_map/bias_*.glsl)?
bool comparesWithOneDepth(BiasParams::Mode mode);

/// The program is in use; uniforms that it does not have are passed over.
void setFilterUniforms(const gl::Program& program, const scene::Light& light, const FilterParams& filter,
                       const LightMaps& maps);

} // namespace shadowlab::shadow_map
