// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/filter_uniforms.h"

#include "techniques/shadow_map/filters/moment_maps.h"

namespace shadowlab::shadow_map {

namespace {

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

double lightReach(const scene::Light& light, const FilterParams& params) {
    if (light.type == scene::LightType::rect)
        return 0.5 * glm::length(light.edgeUWorld) + 0.5 * glm::length(light.edgeVWorld);
    return light.type == scene::LightType::sphere ? light.radius : params.lightRadius;
}

bool comparesWithOneDepth(BiasParams::Mode mode) {
    return mode != BiasParams::Mode::receiverPlane && mode != BiasParams::Mode::adaptive;
}

gl::DepthSampling depthSampling(const FilterParams& filter, BiasParams::Mode bias) {
    using enum FilterParams::Kind;
    if (filter.kind == pcss) return gl::DepthSampling::depths;
    const bool four = filter.kind == hw2x2 || (filter.kind == pcf && comparesWithOneDepth(bias));
    return four ? gl::DepthSampling::compareLinear : gl::DepthSampling::compareNearest;
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
