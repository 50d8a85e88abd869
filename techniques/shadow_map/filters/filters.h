// The filters of the shadow map: one table, of which each entry is all that the program has to know about one filter.
//
// To add a filter, write its GLSL file and one entry in filters.cpp (docs/shadow-map-filters.md, "Add a filter of your own").
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "techniques/foundation/gl/texture.h"
#include "techniques/foundation/scene/model/light.h"
#include "techniques/shadow_map/filters/filter_params.h"

namespace shadowlab::shadow_map {

struct ComparedPoint; // probe/map_probe.h
struct FilterAnswer;
struct MomentFilter; // moment_filters.h

/// Which texels of the map a filter reads, as the stage `kernel` draws them.
enum class KernelForm {
    texels,     ///< a square of whole texels around the one that the point is in
    fourTexels, ///< the four whose centres are around the point
    square,     ///< a square around the point itself
    disc,       ///< a disc around the point itself
    penumbra,   ///< the light's own shape, as wide as the penumbra
};

struct FilterInfo {
    std::string_view name;                        ///< value of the parameter `filter`
    std::string_view what;                        ///< that value in words, for the panel and tables
    std::string_view shader;                      ///< file below shaders/ that defines filteredVisibility(MapPlace)
    std::array<std::string_view, 2> anchors = {}; ///< of the lines in it that the step `light` shows (source_text.h)
    std::array<std::string_view, 12> params = {}; ///< names of the parameters that it reads
    KernelForm kernel = KernelForm::texels;
    /// How far from the point's own texel it reads, in texels.
    double (*radiusTexels)(const FilterParams&) = [](const FilterParams&) { return 0.0; };
    /// How the shader reads the map: compared one texel at a time, compared and interpolated, or as plain depths.
    gl::DepthSampling sampling = gl::DepthSampling::compareNearest;
    /// With a bias that compares all texels with one depth, it reads four texels in one interpolated lookup (ONE_DEPTH in the shader).
    bool interpolatesOneDepth = false;
    /// It looks for what blocks the light, and so has a penumbra where the light has an area.
    bool searchesBlockers = false;
    /// It reads averaged moments instead of depths; none: it compares depths.
    const MomentFilter* moments = nullptr;
    /// The same as the shader computes, for one point, in double; none: a probe says that it cannot tell.
    FilterAnswer (*answer)(const ComparedPoint&) = nullptr;

    [[nodiscard]] bool reads(std::string_view param) const;
};

/// All filters, in the order of the parameter's choices.
std::span<const FilterInfo> filters();
const FilterInfo& filterInfo(FilterKind kind);

/// How the chosen filter's shader reads the depths of a map; `oneDepth`: the bias compares all texels with the same depth.
gl::DepthSampling depthSampling(const FilterParams& params, bool oneDepth);

/// Metres from the light's middle to its border: of its own area or, where it has none, as `light-radius` says; of a directional light
/// at a distance of 1 m. 0: it has no penumbra.
double lightReach(const scene::Light& light, const FilterParams& params);

} // namespace shadowlab::shadow_map
