// The depth that a point is compared with the map by, bias included: what lookup.glsl, bias_*.glsl and reference_depth.glsl compute, in double.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/params.h"

namespace shadowlab::shadow_map {

/// Points are moved toward the light by this share of their distance (for a directional light: of the map's depth)
/// before the comparison. It covers the rounding of interpolated float positions, about 2^-21 here, twenty times over,
/// and is a thousandth of a texel at most.
constexpr double kRoundingShare = 1e-5;

/// A point's place in one map: MapPlace of lookup.glsl.
struct ComparedPlace {
    dvec2 uv{0.0};
    double depth = 0; ///< moved toward the light, where the bias does that
    dvec2 slope{0.0}; ///< dz/du, dz/dv of the point's plane
    dvec4 clip{0.0};  ///< the same place before the division
    bool isBehind = false;
};

/// One layer, and what the bias depends on.
class DepthComparison {
public:
    /// `minReferenceDepth` is of the object that the points are on (light_maps.h).
    DepthComparison(const LightMaps& maps, int layer, const ShadowMapParams& params, const FilterParams& filter,
                    double minReferenceDepth);

    /// `cornersLightRelative` span the plane that the point lies on.
    [[nodiscard]] ComparedPlace placeOf(const dvec3& pointLightRelative,
                                        const std::array<dvec3, 3>& cornersLightRelative) const;
    /// What a comparison at `offsetUv` from the place compares with the map.
    [[nodiscard]] double referenceDepth(const ComparedPlace& place, const dvec2& offsetUv) const;
    /// Across a texel where the point is, at right angles to the light, in the direction in which it is longest.
    [[nodiscard]] double texelMetres(const dvec4& lightClip) const;
    [[nodiscard]] const dmat4& lightClipFromLightRelative() const { return lightClip_; }

    /// Unit vector from the point to the light.
    [[nodiscard]] dvec3 towardLight(const dvec3& pointLightRelative) const;
    [[nodiscard]] const ShadowMapParams& params() const { return params_; }
    /// How far beside the point's place a kernel compares, in texels.
    [[nodiscard]] double kernelTexels() const { return kernelTexels_; }

private:
    const LightMaps& maps_;
    ShadowMapParams params_;
    double kernelTexels_, minReferenceDepth_;
    dmat4 lightClip_;
};

} // namespace shadowlab::shadow_map
