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
    CachedMap& cached = maps_[oneEach ? static_cast<std::size_t>(light) : 0];
    if (cached.depth.side() != resolution || cached.depth.layers() != maps.layers() || cached.format != format) {
        cached = {}; // first, so that both are never there at once
        cached.depth = gl::DepthTextureArray(format, resolution, maps.layers(), "shadow map");
        cached.format = format;
        cached.drawnFor.resize(static_cast<std::size_t>(maps.layers()));
        if (exact) cached.exact.emplace(resolution, maps.layers(), format);
    }
    return cached;
}

} // namespace shadowlab::shadow_map
