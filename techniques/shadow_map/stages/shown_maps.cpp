// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/shown_maps.h"

#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/maps/sheet.h"

namespace shadowlab::shadow_map {

std::optional<dvec2> ShownMaps::share(int light, const dvec3& pointWorld, const View& view) const {
    const auto found = kept_.find(light);
    if (found == kept_.end() || found->second.eye != view.camera || found->second.viewSize != view.size) return {};
    const LightMaps& maps = found->second.maps;
    const dvec3 pointLightRelative = pointWorld - maps.originWorld;
    const double eyeDepth = -transformPoint(scene::viewFromWorld(view.camera), pointWorld).z;
    const std::optional<int> layer = layerOf(maps, pointLightRelative, eyeDepth);
    if (!layer) return {};
    const dvec4 clip = maps.lightClipFromLightRelative(*layer) * dvec4(pointLightRelative, 1.0);
    if (clip.w <= 0) return {};
    const dvec2 uv = 0.5 * dvec2(clip) / clip.w + 0.5;
    if (glm::any(glm::lessThan(uv, dvec2(0.0))) || glm::any(glm::greaterThan(uv, dvec2(1.0)))) return {};
    return Sheet(maps, view.size).shareOf(*layer, uv);
}

void ShownMaps::addPlace(Probe& probe, std::string_view stage, int light, const View& view) const {
    MapProbe* const map = probe.find<MapProbe>();
    if (!map || probe.geometry.empty()) return;
    const dvec3 pointWorld = probe.geometry.front().toWorld; // where the eye's ray ends
    if (const auto place = share(light, pointWorld, view)) map->inPictures.push_back({std::string(stage), *place});
}

} // namespace shadowlab::shadow_map
