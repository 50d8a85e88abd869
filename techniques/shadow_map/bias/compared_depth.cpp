// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/bias/compared_depth.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow_map {

DepthComparison::DepthComparison(const LightMaps& maps, int layer, const ShadowMapParams& params,
                                 const FilterParams& filter, double minReferenceDepth)
    : maps_(maps), params_(params), kernelTexels_(filter.comparedRadius() + 0.5), minReferenceDepth_(minReferenceDepth),
      lightClip_(maps.lightClipFromLightRelative(layer)) {}

double DepthComparison::texelMetres(const dvec4& clip) const {
    const dmat4 rows = glm::transpose(lightClip_);
    const dvec3 alongU = (dvec3(rows[0]) * clip.w - dvec3(rows[3]) * clip.x) / (clip.w * clip.w);
    const dvec3 alongV = (dvec3(rows[1]) * clip.w - dvec3(rows[3]) * clip.y) / (clip.w * clip.w);
    const double u = glm::dot(alongU, alongU), v = glm::dot(alongV, alongV), mixed = glm::dot(alongU, alongV);
    const double least = std::sqrt(std::max(0.5 * (u + v) - glm::length(dvec2(0.5 * (u - v), mixed)), 1e-6 * (u + v)));
    return 2.0 / (params_.resolution * least);
}

dvec3 DepthComparison::towardLight(const dvec3& pointLightRelative) const {
    return maps_.parallel ? maps_.towardLight : -glm::normalize(pointLightRelative);
}

ComparedPlace DepthComparison::placeOf(const dvec3& point, const std::array<dvec3, 3>& corners) const {
    const dvec4 clip = lightClip_ * dvec4(point, 1.0);
    const dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    const BiasInfo& bias = biasInfo(params_.bias.mode);
    const double share = bias.reads("rounding-bias") ? params_.bias.rounding * kRoundingShare : 0;
    const dvec4 light =
        maps_.parallel ? dvec4((maps_.farthest - maps_.nearest) * maps_.towardLight, 0) : dvec4(0, 0, 0, 1);
    const dvec4 stepped = bias.biasedClip ? bias.biasedClip(*this, clip, point, normal) : clip;
    const dvec4 biased = stepped * (maps_.parallel ? 1.0 : 1.0 - share) + share * (lightClip_ * light);
    ComparedPlace place;
    place.isBehind = biased.w <= 0;
    place.clip = biased;
    const dvec3 uvz = dvec3(biased) / biased.w * 0.5 + 0.5;
    place.uv = dvec2(uvz);
    place.depth = uvz.z;
    // The plane in the light's clip space: z = A x + B y + C w at its corners, so dz/du = A and dz/dv = B.
    std::array<dvec4, 3> c{};
    for (std::size_t i = 0; i < 3; ++i)
        c[i] = lightClip_ * dvec4(corners[i], 1.0);
    const dmat3 rows = glm::transpose(
        dmat3(dvec3(c[0].x, c[0].y, c[0].w), dvec3(c[1].x, c[1].y, c[1].w), dvec3(c[2].x, c[2].y, c[2].w)));
    const dvec3 slopes = glm::inverse(rows) * dvec3(c[0].z, c[1].z, c[2].z);
    constexpr double kSteepest = 1e4; // as in lookup.glsl
    if (std::isfinite(slopes.x + slopes.y))
        place.slope = glm::clamp(dvec2(slopes), dvec2(-kSteepest), dvec2(kSteepest));
    return place;
}

double DepthComparison::referenceDepth(const ComparedPlace& place, const dvec2& offsetUv) const {
    const BiasInfo& bias = biasInfo(params_.bias.mode);
    const double depth = place.depth + (bias.depthOffset ? bias.depthOffset(*this, place, offsetUv) : 0.0);
    return std::clamp(depth, minReferenceDepth_, 1.0);
}

} // namespace shadowlab::shadow_map
