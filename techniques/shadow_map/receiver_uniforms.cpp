// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/receiver_uniforms.h"

#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/probe/compared_depth.h"

namespace shadowlab::shadow_map {

namespace {

void setProjection(const gl::Program& program, const LightMaps& maps) {
    std::vector<mat4> lightClipFromLightRelative;
    for (int layer = 0; layer < maps.layers(); ++layer)
        lightClipFromLightRelative.emplace_back(maps.lightClipFromLightRelative(layer));
    program.set("lightClipFromLightRelative", std::span<const mat4>(lightClipFromLightRelative));
    program.set("towardLightRelative", vec3(maps.towardLight));
    program.set("lightOriginWorld", vec3(maps.originWorld));
    if (maps.layout != Layout::cascades) return;
    vec4 ends(0), fades(0);
    for (int i = 0; i < maps.layers(); ++i) {
        ends[i] = static_cast<float>(maps.cascadeEnds[static_cast<std::size_t>(i)]);
        fades[i] = static_cast<float>(maps.fadeStarts[static_cast<std::size_t>(i)]);
    }
    program.set("cascades", maps.layers());
    program.set("cascadeEnds", ends);
    program.set("fadeStarts", fades);
}

/// A point p at the light's side of rounding: p + share (light - p), or p + share * depth of the map * toward the sun. Both are
/// a factor and a summand, in clip space as anywhere.
void setPull(const gl::Program& program, const LightMaps& maps, double share) {
    const dvec4 light = maps.parallel ? dvec4((maps.farthest - maps.nearest) * maps.towardLight, 0) : dvec4(0, 0, 0, 1);
    std::vector<vec4> pullClip;
    for (int layer = 0; layer < maps.layers(); ++layer)
        pullClip.emplace_back(share * (maps.lightClipFromLightRelative(layer) * light));
    program.set("pullScale", static_cast<float>(maps.parallel ? 1 : 1 - share));
    program.set("pullClip", std::span<const vec4>(pullClip));
}

void setBias(const gl::Program& program, const LightMaps& maps, const ShadowMapParams& params,
             const FilterParams& filter) {
    const BiasParams& bias = params.bias;
    setPull(program, maps, bias.mode == BiasParams::Mode::none ? 0 : bias.rounding * kRoundingShare);
    const bool metres = bias.unit == BiasParams::Unit::metres;
    program.set("constantTexels", static_cast<float>(metres ? 0 : bias.constantTexels));
    program.set("constantMetres", static_cast<float>(metres ? bias.constantTexels : 0));
    program.set("normalOffset", static_cast<float>(bias.normalOffset));
    program.set("kernelTexels", static_cast<float>(filter.comparedRadius() + 0.5));
    program.set("halfTexel", static_cast<float>(bias.slope * 0.5 / params.resolution));
}

} // namespace

void setDistanceUniforms(const gl::Program& program, const LightMaps& maps) {
    std::vector<mat4> lightViewFromLightClip;
    for (int layer = 0; layer < maps.layers(); ++layer)
        lightViewFromLightClip.emplace_back(maps.lightViewFromLightClip(layer));
    program.set("lightViewFromLightClip", std::span<const mat4>(lightViewFromLightClip));
    program.set("distanceStart", static_cast<float>(maps.parallel ? maps.nearest : 0.0));
    program.set("depthRange", momentDepthRange(maps));
}

void setReceiverUniforms(const gl::Program& program, const LightMaps& maps, const ShadowMapParams& params,
                         const FilterParams& filter) {
    setProjection(program, maps);
    setDistanceUniforms(program, maps);
    setBias(program, maps, params, filter);
    program.set("resolution", static_cast<float>(params.resolution));
    program.set("rejectBehind", params.rejectBehind ? 1 : 0);
}

} // namespace shadowlab::shadow_map
