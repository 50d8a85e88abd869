// What the shader that asks a shadow map has to know (shaders/shadow_map/lookup.glsl and the files it includes).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/shadow_map/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// The program is in use; uniforms that it does not have are passed over.
void setReceiverUniforms(const gl::Program& program, const LightMaps& maps, const ShadowMapParams& params);

} // namespace shadowlab::shadow_map
