// The biases of the shadow map: what keeps a surface from shadowing itself, where a texel holds one depth for a piece of it.
// One table, of which each entry is all that the program has to know about one bias.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/params/param.h"

namespace shadowlab::shadow_map {

/// A bias, by its place in the table.
enum class BiasMode : int {};
/// Throws Error (bug) where there is none of that name.
BiasMode biasNamed(std::string_view name);

struct BiasParams {
    BiasMode mode = biasNamed("receiver-plane");
    double constantTexels = 1.5;
    double slope = 1.0;
    double normalOffset = 1.0;
    double rounding = 1.0;
    enum class Unit { texels, metres } unit = Unit::texels;
    friend bool operator==(const BiasParams&, const BiasParams&) = default;
};

class DepthComparison; // compared_depth.h
struct ComparedPlace;

struct BiasInfo {
    std::string_view name;                  ///< value of the parameter `bias-mode`
    std::string_view what;                  ///< that value in words, for the panel and tables
    std::string_view shader;                ///< file below shaders/ that defines biasedClip() and depthToCompare()
    std::array<std::string_view, 4> params; ///< names of the parameters that it reads
    /// All texels of a kernel are compared with one depth: no slope of the receiver is followed.
    bool comparesWithOneDepth = true;
    /// The depth is that of the receiver's plane at the centre of each texel (COMPARES_AT_CENTRES in the shader).
    bool comparesAtCentres = false;
    /// The map stores the middle between the first surface and the second.
    bool isDualDepth = false;
    /// glPolygonOffset's factor while the map is drawn, for a kernel of that radius in texels; none: 0.
    double (*slopeFactor)(const BiasParams&, double radius) = nullptr;
    /// The same as the shader's biasedClip(), in double; none: the place stays what it is.
    dvec4 (*biasedClip)(const DepthComparison&, const dvec4& clip, const dvec3& pointLightRelative,
                        const dvec3& normal) = nullptr;
    /// What the shader's depthToCompare() adds to the point's own depth; none: nothing.
    double (*depthOffset)(const DepthComparison&, const ComparedPlace&, const dvec2& offsetUv) = nullptr;

    [[nodiscard]] bool reads(std::string_view param) const;
};

/// All biases, in the order of the parameter's choices.
std::span<const BiasInfo> biases();
const BiasInfo& biasInfo(BiasMode mode);

/// The descriptions refer to the fields of `params`. Each has an effect only with the biases whose entries name it.
params::ParamList describe(BiasParams& params);

} // namespace shadowlab::shadow_map
