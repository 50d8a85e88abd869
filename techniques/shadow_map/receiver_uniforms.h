// What the shader that asks a shadow map has to know (shaders/shadow_map/lookup.glsl and the files it includes).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// Texture unit of the map; what else a pass needs comes after it.
constexpr int kMapUnit = gl::kFirstFreeUnit;

/// What shaders/shadow_map/distance.glsl and moment_depth.glsl ask.
void setDistanceUniforms(const gl::Program& program, const LightMaps& maps);

/// The program is in use; uniforms that it does not have are passed over.
void setReceiverUniforms(const gl::Program& program, const LightMaps& maps, const ShadowMapParams& params,
                         const FilterParams& filter);

/// The parameters of the filters, for shaders/shadow_map/filters/filter_*.glsl; likewise.
void setFilterUniforms(const gl::Program& program, const scene::Light& light, const FilterParams& filter,
                       const LightMaps& maps);

} // namespace shadowlab::shadow_map
