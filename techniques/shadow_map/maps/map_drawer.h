// The depth maps themselves: drawn into textures that are kept until what they were drawn from changes, and the moments of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "techniques/shadow_map/filters/moment_maps.h"
#include "techniques/shadow_map/fit/map_fitter.h"
#include "techniques/shadow_map/maps/map_cache.h"

namespace shadowlab::shadow_map {

/// One light's map: its cameras, what it is for, and its textures.
struct LightShadowMap {
    LightMaps maps;
    MapQuery query;
    const gl::DepthTextureArray* depth = nullptr;   ///< none: nothing in view can be in this light's shadow
    const ExactTextures* exact = nullptr;           ///< only of the exact map
    CachedMap* cached = nullptr;                    ///< where it is kept, if it is
    const gl::ColorTextureArray* moments = nullptr; ///< of the depths, where the filter reads them
    const gl::Texture2D* decided = nullptr;         ///< visibility of every pixel, where it is known already
};

class MapDrawer {
public:
    MapDrawer(const ShadowMapParams& params, const MapFitter& fitter) : params_(params), fitter_(fitter) {}

    /// Draws one layer of a cached map.
    using DrawLayer = std::function<void(int layer, std::span<const std::size_t> casters, CachedMap& map)>;

    /// Draws those layers of a light's fitted maps that are not what they should be. `drawLayer`: none for plain depths; with
    /// it the map has the textures of the exact map beside them.
    LightShadowMap updateMap(Frame& frame, int light, const DrawLayer& drawLayer = {});
    /// Makes the moments of a light's map if its depths, or the filter's parameters, changed.
    void updateMoments(Frame& frame, LightShadowMap& map);

    /// A map beside those that are kept.
    struct OwnMap {
        gl::DepthTextureArray depth;
        GLenum format = GL_NONE;
        std::optional<gl::ColorTextureArray> moments;
    };
    /// Draws the map into textures of its own, with moments where the filter reads them.
    LightShadowMap drawAnew(const Frame& frame, const MapQuery& query, const LightMaps& maps, OwnMap& own);

    [[nodiscard]] const DepthPass& depthPass() const { return depthPass_; }

private:
    const ShadowMapParams& params_;
    const MapFitter& fitter_;
    MapCache cache_;
    DepthPass depthPass_;
    MomentMaker momentMaker_;
};

} // namespace shadowlab::shadow_map
