// SPDX-License-Identifier: MIT
#include "app/lab/handles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/edit_scene.h"

namespace shadowlab::lab {

std::vector<Handle> handles(const scene::Scene& scene, const std::vector<scene::Bounds>& bounds,
                            const scene::Camera& camera) {
    std::vector<Handle> handles;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const scene::Light& light = scene.lights[i];
        const bool directional = light.type == scene::LightType::directional;
        const double reach = glm::length(camera.targetWorld - camera.positionWorld);
        const dvec3 positionWorld =
            directional ? camera.targetWorld - reach * light.directionWorld : light.positionWorld;
        handles.push_back({{Selection::Kind::light, static_cast<int>(i)}, positionWorld, light.name});
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].emitterOfLight >= 0 || scene.objects[i].isFurtherPiece || bounds[i].isEmpty()) continue;
        handles.push_back({{Selection::Kind::object, static_cast<int>(i)},
                           0.5 * (bounds[i].lowerWorld + bounds[i].upperWorld),
                           scene.objects[i].name});
    }
    return handles;
}

scene::Snapshot withMoved(const scene::Snapshot& snapshot, const Selection& what, const dvec3& byWorld,
                          const scene::Camera& camera) {
    const auto index = static_cast<std::size_t>(what.index);
    if (what.kind == Selection::Kind::object && index < snapshot->objects.size())
        return scene::withObjectMovedBy(snapshot, index, byWorld);
    if (what.kind != Selection::Kind::light || index >= snapshot->lights.size()) return snapshot;
    std::vector<scene::Light> lights = snapshot->lights;
    scene::Light& light = lights[index];
    if (light.type == scene::LightType::directional) {
        const double reach = glm::length(camera.targetWorld - camera.positionWorld);
        const dvec3 toLightWorld = -reach * light.directionWorld + byWorld;
        if (glm::length(toLightWorld) < 1e-3 * reach)
            return snapshot; // at the target itself it would have no direction
        light.directionWorld = -glm::normalize(toLightWorld);
    } else {
        light.positionWorld += byWorld;
    }
    return scene::withLights(snapshot, std::move(lights));
}

PictureProjection::PictureProjection(const scene::Camera& camera, const dvec2& size)
    : clipFromWorld_(scene::clipFromView(camera, size.x / std::max(1.0, size.y)) * scene::viewFromWorld(camera)), size_(size),
      near_(camera.near) {}

std::optional<dvec2> PictureProjection::pixel(const dvec3& positionWorld) const {
    const dvec4 clip = clipFromWorld_ * dvec4(positionWorld, 1.0);
    if (clip.w <= near_) return {};
    return dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * size_;
}

std::optional<dvec2> pixelOf(const scene::Camera& camera, ivec2 size, const dvec3& positionWorld) {
    return PictureProjection(camera, size).pixel(positionWorld);
}

std::optional<EdgeMark> edgeMarkOf(const scene::Camera& camera, ivec2 size, double margin, const dvec3& positionWorld) {
    const dvec2 extent(size);
    const std::optional<dvec2> pixel = pixelOf(camera, size, positionWorld);
    if (pixel && glm::all(glm::greaterThanEqual(*pixel, dvec2(0.0))) && glm::all(glm::lessThanEqual(*pixel, extent)))
        return {};
    // Also for what lies behind the eye: turning the camera that way brings it into view.
    const dvec3 positionView = transformPoint(scene::viewFromWorld(camera), positionWorld);
    const dvec2 across(positionView.x, -positionView.y);
    const dvec2 outward = glm::length(across) > 0 ? glm::normalize(across) : dvec2(0, 1);
    const dvec2 half = glm::max(0.5 * extent - margin, dvec2(0.0));
    double reach = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis)
        if (outward[axis] != 0) reach = std::min(reach, half[axis] / std::abs(outward[axis]));
    return EdgeMark{0.5 * extent + reach * outward, outward};
}

} // namespace shadowlab::lab
