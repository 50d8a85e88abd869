// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/stages/frusta.h"

#include "techniques/foundation/base/look.h"

namespace shadowlab::shadow_map {

std::array<dvec3, 8> frustumCornersWorld(const LightMaps& maps, int layer) {
    static constexpr double around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const dmat4 lightRelativeFromLightClip = glm::inverse(maps.lightClipFromLightRelative(layer));
    std::array<dvec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec4 corner =
            lightRelativeFromLightClip * dvec4(around[i % 4][0], around[i % 4][1], i < 4 ? -1.0 : 1.0, 1.0);
        corners[i] = maps.originWorld + dvec3(corner) / corner.w;
    }
    return corners;
}

namespace {

void addFrustum(const LightMaps& maps, int layer, SceneShape& edges, SceneShape& nearPlanes) {
    const std::array<dvec3, 8> c = frustumCornersWorld(maps, layer);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const dvec3& start = maps.parallel ? c[i] : maps.originWorld;
        edges.pointsWorld.insert(edges.pointsWorld.end(), {c[i], c[next], c[4 + i], c[4 + next], start, c[4 + i]});
    }
    nearPlanes.pointsWorld.insert(nearPlanes.pointsWorld.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
}

/// Each cascade in its own colour, as in the stage `cascades`; `inOneColor`: all in that of a shadow map's view.
std::vector<SceneShape> cascadeShapes(const LightMaps& maps, bool inOneColor) {
    std::vector<SceneShape> shapes;
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const vec3& color = inOneColor ? look::kLightFrustum : look::kLayers[static_cast<std::size_t>(layer)];
        SceneShape edges{"cascade " + std::to_string(layer + 1), color, SceneShape::Kind::lines, {}};
        SceneShape nearPlane{edges.label, color, SceneShape::Kind::faces, {}};
        addFrustum(maps, layer, edges, nearPlane);
        shapes.push_back(std::move(nearPlane));
        shapes.push_back(std::move(edges));
    }
    return shapes;
}

} // namespace

std::vector<SceneShape> frustumShapes(const LightMaps& maps, bool cascadesInOneColor) {
    if (maps.layout == Layout::cascades) return cascadeShapes(maps, cascadesInOneColor);
    const bool isOne = maps.layers() == 1;
    SceneShape edges{isOne ? "view of the shadow map" : "views of the six shadow maps",
                     look::kLightFrustum,
                     SceneShape::Kind::lines,
                     {}};
    SceneShape nearPlanes{isOne ? "near plane of the map" : "near planes of the maps",
                          look::kLightFrustum,
                          SceneShape::Kind::faces,
                          {}};
    for (int layer = 0; layer < maps.layers(); ++layer)
        addFrustum(maps, layer, edges, nearPlanes);
    if (maps.layers() == 0) return {};
    return {nearPlanes, edges};
}

} // namespace shadowlab::shadow_map
