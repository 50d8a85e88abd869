// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/maps/map_drawer.h"

#include <algorithm>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"

namespace shadowlab::shadow_map {

LightShadowMap MapDrawer::updateMap(Frame& frame, int light, const DrawLayer& drawLayer) {
    const scene::Scene& scene = frame.scene();
    const LightMaps& maps = fitter_.fitted(light);
    const MapQuery query = fitter_.query(scene, light);
    frame.count("lights-with-map", maps.layers() > 0 ? 1 : 0, 1, "lights");
    const double allCasters = static_cast<double>(scene::allCasters(scene).size());
    if (maps.layers() == 0) {
        frame.count("casters", 0, allCasters, "objects");
        return {.maps = maps, .query = query};
    }
    const double layerTexels = static_cast<double>(params_.resolution) * params_.resolution;
    double allTexels = 0;
    for (const LightMaps& fitted : fitter_.fitted())
        allTexels += layerTexels * fitted.layers();
    const GLenum format = params_.glDepthFormat();
    CachedMap& cached =
        cache_.of(light, fitter_.fitted().size(), allTexels, maps, params_.resolution, format, drawLayer != nullptr);
    cached.depth.clampToEdge(params_.border == ShadowMapParams::Border::edge);

    std::vector<bool> drawn(scene.objects.size(), false); // in any layer
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const LayerCacheKey origin{scene.revisions.geometry,
                                   scene.revisions.transforms,
                                   scene.revisions.materials,
                                   maps.originWorld,
                                   maps.lightClipFromLightRelative(layer),
                                   fitter_.castersOf(scene, maps, query, layer),
                                   depthRules(params_, query.filter),
                                   gl::shaderReloads()};
        std::optional<LayerCacheKey>& drawnFor = cached.drawnFor[static_cast<std::size_t>(layer)];
        const bool redraw = drawnFor != origin;
        if (redraw && drawLayer) {
            drawLayer(layer, origin.casters, cached);
        } else if (redraw) {
            depthPass_.draw(frame, maps, layer, origin.casters, cached.depth, format, origin.rules);
        }
        if (redraw) cached.momentsAreCurrent = false;
        drawnFor = origin;
        for (const std::size_t caster : origin.casters)
            drawn[caster] = true;
        frame.count("maps-redrawn", redraw ? 1 : 0, 1, "maps");
        frame.count("caster-draws", static_cast<double>(origin.casters.size()), allCasters, "objects, each per map");
    }
    frame.count("casters", static_cast<double>(std::ranges::count(drawn, true)), allCasters, "objects");
    frame.count("map-texels", layerTexels * maps.layers(), 0, "texels");
    if (!query.filter.usesMoments()) cached.moments.reset();
    return {.maps = maps,
            .query = query,
            .depth = &cached.depth,
            .exact = cached.exact ? &*cached.exact : nullptr,
            .cached = &cached};
}

void MapDrawer::updateMoments(Frame& frame, LightShadowMap& map) {
    CachedMap& cached = *map.cached;
    const FilterParams wanted = momentParams(params_.filter);
    const bool other = !cached.moments || cached.momentsFor != wanted, make = other || !cached.momentsAreCurrent;
    const int layers = map.maps.layers();
    frame.count("moments-made", make ? layers : 0, layers, "maps");
    map.moments = cached.moments ? &*cached.moments : nullptr;
    if (!make) return;
    if (other) {
        cached.moments.reset(); // first, so that both are never there at once
        cached.moments = emptyMoments(params_.filter, params_.resolution, layers);
    }
    momentMaker_.make(cached.depth, map.maps, params_.filter, *cached.moments);
    cached.momentsFor = wanted;
    cached.momentsAreCurrent = true;
    map.moments = &*cached.moments;
}

LightShadowMap MapDrawer::drawAnew(const Frame& frame, const MapQuery& query, const LightMaps& maps, OwnMap& own) {
    if (maps.layers() == 0) return {.maps = maps, .query = query};
    const GLenum format = params_.glDepthFormat();
    if (own.depth.side() != params_.resolution || own.depth.layers() != maps.layers() || own.format != format) {
        own.depth = gl::DepthTextureArray(format, params_.resolution, maps.layers(), "shadow map of one point");
        own.format = format;
    }
    own.depth.clampToEdge(params_.border == ShadowMapParams::Border::edge);
    for (int layer = 0; layer < maps.layers(); ++layer) {
        gl::setBaselineState();
        depthPass_.draw(frame, maps, layer, fitter_.castersOf(frame.scene(), maps, query, layer), own.depth, format,
                        depthRules(params_, query.filter));
    }
    if (query.filter.usesMoments()) {
        own.moments = emptyMoments(query.filter, params_.resolution, maps.layers());
        momentMaker_.make(own.depth, maps, query.filter, *own.moments);
    }
    return {.maps = maps,
            .query = query,
            .depth = &own.depth,
            .moments = query.filter.usesMoments() ? &*own.moments : nullptr};
}

} // namespace shadowlab::shadow_map
