// A scene made ready for form factors.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/radiosity/form_factors/visible_exchange.h"
#include "tests/support/scenes.h"

namespace shadowlab::testing {

struct Room {
    explicit Room(const scene::Scene& scene, double patchSize) {
        const trace::WorldTriangles world = trace::worldTriangles(scene);
        originWorld = world.originWorld;
        faces = radiosity::facesOf(scene, world);
        bvh = trace::buildBvh(world.triangles);
        patches = radiosity::cutIntoPatches(faces, patchSize);
        std::vector<std::uint8_t> casts;
        for (const std::uint32_t object : world.objects)
            casts.push_back(scene.objects[object].castsShadow || scene.objects[object].emitterOfLight >= 0 ? 1 : 0);
        occlusion.emplace(faces, bvh, casts);
    }
    Room(const Room&) = delete; // the occlusion points into it
    Room& operator=(const Room&) = delete;

    [[nodiscard]] radiosity::VisibleExchange exchange(std::size_t i, std::size_t j, double linesPerPatch) const {
        const auto& a = faces.all[patches[i].face].polygon;
        const auto& b = faces.all[patches[j].face].polygon;
        return radiosity::visibleExchange(patches[i], patches[j], *occlusion, occlusion->between(a, b), linesPerPatch);
    }
    dvec3 originWorld{0.0};
    radiosity::Faces faces;
    trace::Bvh bvh;
    std::vector<radiosity::Patch> patches;
    std::optional<radiosity::Occlusion> occlusion;
};

/// Six walls that face inward, from (0, 0, 0) to `size`.
inline scene::Scene emptyRoom(const dvec3& size) {
    scene::Scene scene;
    scene.materials.emplace_back();
    const auto wall = [&](const dvec2& extent, double aboutX, double aboutZ, const dvec3& middle) {
        dmat4 turn = glm::rotate(dmat4(1), glm::radians(aboutZ), dvec3(0, 0, 1));
        turn = glm::rotate(turn, glm::radians(aboutX), dvec3(1, 0, 0));
        addObject(scene, scene::makeQuad(extent), translation(middle) * turn);
    };
    wall({size.x, size.z}, 0, 0, {size.x / 2, 0, size.z / 2});
    wall({size.x, size.z}, 180, 0, {size.x / 2, size.y, size.z / 2});
    wall({size.x, size.y}, 90, 0, {size.x / 2, size.y / 2, 0});
    wall({size.x, size.y}, -90, 0, {size.x / 2, size.y / 2, size.z});
    wall({size.y, size.z}, 0, -90, {0, size.y / 2, size.z / 2});
    wall({size.y, size.z}, 0, 90, {size.x, size.y / 2, size.z / 2});
    return scene;
}

} // namespace shadowlab::testing
