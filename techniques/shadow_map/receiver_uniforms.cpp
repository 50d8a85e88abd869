// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/receiver_uniforms.h"

#include "techniques/shadow_map/bias/compared_depth.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/filters/moment_maps.h"

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
void setRoundingBias(const gl::Program& program, const LightMaps& maps, double share) {
    const dvec4 light = maps.parallel ? dvec4((maps.farthest - maps.nearest) * maps.towardLight, 0) : dvec4(0, 0, 0, 1);
    std::vector<vec4> roundingBiasClip;
    for (int layer = 0; layer < maps.layers(); ++layer)
        roundingBiasClip.emplace_back(share * (maps.lightClipFromLightRelative(layer) * light));
    program.set("roundingBiasScale", static_cast<float>(maps.parallel ? 1 : 1 - share));
    program.set("roundingBiasClip", std::span<const vec4>(roundingBiasClip));
}

void setBias(const gl::Program& program, const LightMaps& maps, const ShadowMapParams& params,
             const FilterParams& filter) {
    const BiasParams& bias = params.bias;
    setRoundingBias(program, maps, biasInfo(bias.mode).reads("rounding-bias") ? bias.rounding * kRoundingShare : 0);
    const bool metres = bias.unit == BiasParams::Unit::metres;
    program.set("constantTexels", static_cast<float>(metres ? 0 : bias.constantTexels));
    program.set("constantMetres", static_cast<float>(metres ? bias.constantTexels : 0));
    program.set("normalOffset", static_cast<float>(bias.normalOffset));
    program.set("kernelTexels", static_cast<float>(filter.comparedRadius() + 0.5));
    program.set("halfTexel", static_cast<float>(bias.slope * 0.5 / params.resolution));
}

/// What filter_pcss.glsl asks of light and map.
void setLightShape(const gl::Program& program, const scene::Light& light, const LightMaps& maps,
                   const FilterParams& params) {
    const bool isRect = light.type == scene::LightType::rect;
    const double radius = isRect ? 0.0 : lightReach(light, params);
    program.set("lightHalfU", vec3(isRect ? 0.5 * light.edgeUWorld : dvec3(0.0)));
    program.set("lightHalfV", vec3(isRect ? 0.5 * light.edgeVWorld : dvec3(0.0)));
    program.set("lightRadius", static_cast<float>(radius));
    program.set("lightAxis", vec3(isRect ? scene::rectNormalWorld(light) : -maps.towardLight));
    program.set("nearestBlocker", static_cast<float>(maps.nearest));
    std::vector<mat4> lightRelativeFromLightClip;
    for (int layer = 0; layer < maps.layers(); ++layer)
        lightRelativeFromLightClip.emplace_back(glm::inverse(maps.lightClipFromLightRelative(layer)));
    program.set("lightRelativeFromLightClip", std::span<const mat4>(lightRelativeFromLightClip));
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

void setFilterUniforms(const gl::Program& program, const scene::Light& light, const FilterParams& filter,
                       const LightMaps& maps) {
    const auto set = [&](const char* name, double value) { program.set(name, static_cast<float>(value)); };
    program.set("pcfRadius", filter.pcfRadius);
    set("discRadius", filter.discRadius);
    program.set("samples", filter.samples);
    program.set("noise", static_cast<int>(filter.noise));
    program.set("blockerSamples", filter.blockerSamples);
    set("widest", filter.widest);
    setLightShape(program, light, maps, filter);

    const Exponents used = exponents(filter);
    set("leastDeviation", 2 * filter.leastDeviation); // of depths from -1 to 1, which are two apart
    set("bleedReduction", filter.bleedReduction);
    set("esmExponent", used.esm);
    program.set("logarithms", averagesLogarithms(filter) ? 1 : 0);
    program.set("evsmExponents", vec2(used.evsm));
    program.set("evsmMoments", filter.evsmMoments == FilterParams::EvsmMoments::two ? 2 : 4);
    set("msmBias", msmBias(filter));
}

} // namespace shadowlab::shadow_map
