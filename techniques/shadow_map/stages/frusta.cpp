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

/// Each cascade in its own colour, as in the stage `cascades`.
std::vector<SceneShape> cascadeShapes(const LightMaps& maps) {
    std::vector<SceneShape> shapes;
    for (int layer = 0; layer < maps.layers(); ++layer) {
        const vec3& color = look::kLayers[static_cast<std::size_t>(layer)];
        SceneShape edges{"cascade " + std::to_string(layer + 1), color, SceneShape::Kind::lines, {}};
        SceneShape nearPlane{edges.label, color, SceneShape::Kind::faces, {}};
        addFrustum(maps, layer, edges, nearPlane);
        shapes.push_back(std::move(nearPlane));
        shapes.push_back(std::move(edges));
    }
    return shapes;
}

} // namespace

std::vector<SceneShape> frustumShapes(const LightMaps& maps) {
    if (maps.layout == Layout::cascades) return cascadeShapes(maps);
    const std::string label = maps.layers() == 1 ? "what the shadow map sees" : "what the six shadow maps see";
    SceneShape edges{label + (maps.layers() == 1 ? ", its near plane filled" : ""),
                     look::kLightFrustum,
                     SceneShape::Kind::lines,
                     {}};
    SceneShape nearPlanes{edges.label, look::kLightFrustum, SceneShape::Kind::faces, {}};
    for (int layer = 0; layer < maps.layers(); ++layer)
        addFrustum(maps, layer, edges, nearPlanes);
    if (maps.layers() == 0) return {};
    return {nearPlanes, edges};
}

} // namespace shadowlab::shadow_map
