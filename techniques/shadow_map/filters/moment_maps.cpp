// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/filters/moment_maps.h"

#include <algorithm>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/filters/moment_filters.h"
#include "techniques/shadow_map/receiver_uniforms.h"

namespace shadowlab::shadow_map {

namespace {

/// The largest number that a moment's format holds, as an exponent of e: ln(3.4e38), ln(65504).
double largestExponent(const FilterParams& params) {
    return params.momentFormat == FilterParams::MomentFormat::float32 ? 88.7228 : 11.0899;
}

// Of the largest exponent: sums of as many numbers as a kernel has must be finite as well (ln(63 * 63) = 8.3, and a map's
// range is a thousandth wider than what is in it).
double usableExponent(const FilterParams& params) {
    const double kernel = std::log(std::pow(2.0 * params.blurRadius + 1, 2));
    return 0.995 * (largestExponent(params) - kernel);
}

GLenum formatOf(const FilterParams& params) {
    const bool wide = params.momentFormat == FilterParams::MomentFormat::float32;
    switch (filterInfo(params.kind).moments->count(params)) {
    case 1: return wide ? GL_R32F : GL_R16F;
    case 2: return wide ? GL_RG32F : GL_RG16F;
    default: return wide ? GL_RGBA32F : GL_RGBA16F;
    }
}

} // namespace

Exponents exponents(const FilterParams& params) {
    Exponents result{params.esmExponent, {params.evsmExponent, params.evsmNegative}};
    if (!params.exponentLimit) return result;
    const double most = usableExponent(params);
    if (!averagesLogarithms(params)) result.esm = std::min(result.esm, most);
    result.evsm = glm::min(result.evsm, dvec2(0.5 * most)); // they are squared
    return result;
}

// Along a row 2 r + 1 numbers are added and the sum is divided, which may lose as much as five sums do: 2 r + 6 roundings.
double msmBias(const FilterParams& params) { return std::min(0.5, params.msmBias * (2 * params.blurRadius + 6) / 8); }

bool averagesLogarithms(const FilterParams& params) {
    return filterInfo(params.kind).reads("esm-logarithms") && params.esmLogarithms;
}

FilterParams momentParams(const FilterParams& params) {
    FilterParams result;
    result.kind = params.kind;
    result.blurRadius = params.blurRadius;
    result.mipmaps = params.mipmaps;
    result.momentFormat = params.momentFormat;
    result.esmExponent = params.esmExponent;
    result.esmLogarithms = params.esmLogarithms;
    result.evsmMoments = params.evsmMoments;
    result.evsmExponent = params.evsmExponent;
    result.evsmNegative = params.evsmNegative;
    result.exponentLimit = params.exponentLimit;
    return result;
}

gl::ColorTextureArray emptyMoments(const FilterParams& params, int resolution, int layers) {
    const bool mipmaps = params.mipmaps && !averagesLogarithms(params);
    return {formatOf(params), resolution, layers, mipmaps, "moments of the shadow map"};
}

vec2 momentDepthRange(const LightMaps& maps) { return {dvec2(maps.nearest, maps.farthest)}; }

const MomentMaker::Programs& MomentMaker::programsFor(const FilterParams& params) {
    const std::pair choice(params.kind, averagesLogarithms(params));
    if (const auto known = programs_.find(choice); known != programs_.end()) return known->second;
    const gl::Substitution average{"shadow_map/moments/average_values.glsl", choice.second
                                                                         ? "shadow_map/moments/average_logarithms.glsl"
                                                                         : "shadow_map/moments/average_values.glsl"};
    const gl::Substitution moments{"shadow_map/moments/moments_of_vsm.glsl",
                                   std::string(filterInfo(params.kind).moments->shader)};
    return programs_
        .emplace(choice,
                 Programs{gl::Program("fullscreen.vert", "shadow_map/moments/make_moments.frag", {}, {average, moments}),
                          gl::Program("fullscreen.vert", "shadow_map/moments/average_column.frag", {}, {average})})
        .first->second;
}

void MomentMaker::make(const gl::DepthTextureArray& depth, const LightMaps& maps, const FilterParams& params,
                       const gl::ColorTextureArray& moments) {
    const Programs& programs = programsFor(params);
    const Exponents used = exponents(params);
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    depth.sample(gl::DepthSampling::depths);
    const ivec2 size(moments.side());
    if (averagedRows_.size() != size || averagedRows_.internalFormat() != moments.internalFormat()) {
        averagedRows_ = {}; // first, so that both are never there at once
        averagedRows_ = gl::Texture2D(moments.internalFormat(), size, "averaged rows");
    }
    const gl::Framebuffer rowsTarget(&averagedRows_, nullptr, "averaged rows");
    const gl::Program &rows = programs.rows, &columns = programs.columns;
    for (int layer = 0; layer < moments.layers(); ++layer) {
        rowsTarget.bind();
        rows.use();
        depth.bind(kMapUnit);
        rows.set("shadowMap", kMapUnit);
        rows.set("layer", layer);
        rows.set("blurRadius", params.blurRadius);
        rows.set("logarithms", averagesLogarithms(params) ? 1 : 0);
        rows.set("esmExponent", static_cast<float>(used.esm));
        rows.set("evsmExponents", vec2(used.evsm));
        setDistanceUniforms(rows, maps);
        gl::drawFullscreenTriangle();

        const gl::Framebuffer target(moments, layer, "moments");
        target.bind();
        columns.use();
        averagedRows_.bind(kMapUnit);
        columns.set("averagedRows", kMapUnit);
        columns.set("blurRadius", params.blurRadius);
        gl::drawFullscreenTriangle();
    }
    moments.bind(kMapUnit);
    moments.makeMipmaps();
}

} // namespace shadowlab::shadow_map
