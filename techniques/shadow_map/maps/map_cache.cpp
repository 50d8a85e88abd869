// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/maps/map_cache.h"

namespace shadowlab::shadow_map {

namespace {

// A quarter of a gigabyte, at four bytes a texel.
constexpr double kMostKeptTexels = 64.0 * 1024 * 1024;

} // namespace

CachedMap& MapCache::of(int light, std::size_t lights, double allTexels, const LightMaps& maps, int resolution,
                        GLenum format, bool exact) {
    const bool oneEach = allTexels <= kMostKeptTexels;
    maps_.resize(oneEach ? lights : 1);
    CachedMap& kept = maps_[oneEach ? static_cast<std::size_t>(light) : 0];
    if (kept.depth.side() != resolution || kept.depth.layers() != maps.layers() || kept.format != format) {
        kept = {}; // first, so that both are never there at once
        kept.depth = gl::DepthTextureArray(format, resolution, maps.layers(), "shadow map");
        kept.format = format;
        kept.drawnFor.resize(static_cast<std::size_t>(maps.layers()));
    }
    if (exact != kept.exact.has_value()) {
        kept.exact.reset();
        if (exact) kept.exact.emplace(resolution, maps.layers(), format);
        for (std::optional<LayerCacheKey>& origin : kept.drawnFor)
            origin.reset();
    }
    return kept;
}

} // namespace shadowlab::shadow_map
