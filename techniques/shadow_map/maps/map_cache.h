// Maps that are kept from frame to frame: a layer is drawn again only when something that it depends on has changed.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/shadow_map/maps/depth_pass.h"

namespace shadowlab::shadow_map {

/// All that the depths of one layer depend on.
struct LayerCacheKey {
    std::uint64_t geometry = 0, transforms = 0, materials = 0; ///< materials: their holes
    dvec3 originWorld{0.0};
    dmat4 lightClipFromLightRelative{1.0};
    std::vector<std::size_t> casters;
    DepthRules rules;
    int shaderReloads = 0;
    friend bool operator==(const LayerCacheKey&, const LayerCacheKey&) = default;
};

/// What the exact map keeps beside the depths (exact/exact_pass.h).
struct ExactTextures {
    gl::IdTextureArray triangles; ///< which one is the first at each texel's centre, counted through all objects
    gl::DepthTextureArray edges;  ///< the nearest loose edge in each texel

    ExactTextures(int resolution, int layers, GLenum format)
        : triangles(resolution, layers, "triangles in the shadow map"),
          edges(format, resolution, layers, "edges in the shadow map") {
        edges.sample(gl::DepthSampling::depths);
    }
};

struct CachedMap {
    gl::DepthTextureArray depth;
    std::optional<ExactTextures> exact;                 ///< only of the exact map
    std::optional<gl::ColorTextureArray> moments;       ///< only where the filter asks for them
    FilterParams momentsFor;                            ///< what they were made for
    bool momentsAreCurrent = false;                     ///< made from these depths
    GLenum format = GL_NONE;                            ///< of the depths
    std::vector<std::optional<LayerCacheKey>> drawnFor; ///< per layer; none: not drawn, or not to be relied on
};

class MapCache {
public:
    /// The map of one light of several, of that size and format. Every light keeps its own while `allTexels`, of all of them
    /// together, are few enough for the memory; else they share one, and it is drawn anew for each. `exact`: with the textures of
    /// the exact map; always the same for one cache.
    CachedMap& of(int light, std::size_t lights, double allTexels, const LightMaps& maps, int resolution, GLenum format,
                  bool exact);

private:
    std::vector<CachedMap> maps_;
};

} // namespace shadowlab::shadow_map
