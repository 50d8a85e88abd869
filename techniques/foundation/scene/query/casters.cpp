// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/casters.h"

#include <algorithm>
#include <optional>

namespace shadowlab::scene {

namespace {

// In practice no larger mesh lies in one plane, and testing every vertex would cost more than it saves.
constexpr std::size_t kFlatTriangles = 512;

// An object that rests on a floor may reach below it by rounding: up to a billionth of the scene's size counts as resting.
constexpr double kResting = 1e-9;

/// The plane dot(normal, p) + distance = 0 that all vertices of the object lie on, if there is one.
std::optional<dvec4> commonPlaneWorld(const Object& object) {
    if (object.mesh->triangles.empty() || object.mesh->triangles.size() > kFlatTriangles) return std::nullopt;
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    const auto world = [&](std::uint32_t v) {
        return transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[v]));
    };
    const uvec3 first = object.mesh->triangles.front();
    const dvec3 a = world(first.x);
    const dvec3 normal = glm::normalize(glm::cross(world(first.y) - a, world(first.z) - a));
    for (std::uint32_t v = 0; v < object.mesh->positionsMesh.size(); ++v) {
        const dvec3 offset = world(v) - a;
        if (std::abs(glm::dot(normal, offset)) > kResting * glm::length(offset)) return std::nullopt;
    }
    return dvec4(normal, -glm::dot(normal, a));
}

} // namespace

std::vector<std::size_t> allCasters(const Scene& scene) {
    std::vector<std::size_t> casters;
    for (std::size_t o = 0; o < scene.objects.size(); ++o)
        if (scene.objects[o].castsShadow) casters.push_back(o);
    return casters;
}

std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light) {
    return usefulCasters(scene, light, objectBounds(scene));
}

std::vector<std::size_t> usefulCasters(const Scene& scene, const Light& light, std::span<const Bounds> bounds) {
    Bounds all;
    for (const Bounds& box : bounds)
        all.include(box);
    const double slack = kResting * (all.isEmpty() ? 1.0 : glm::length(all.upperWorld - all.lowerWorld));
    const dvec4 lightWorld = homogeneousPositionWorld(light);

    std::vector<std::size_t> useful;
    for (const std::size_t o : allCasters(scene)) {
        bool nothingBehind = false;
        if (const std::optional<dvec4> plane = commonPlaneWorld(scene.objects[o])) {
            const double lightSide = glm::dot(*plane, lightWorld) >= 0 ? 1.0 : -1.0;
            nothingBehind = std::ranges::all_of(bounds, [&](const Bounds& box) {
                for (int i = 0; i < 8; ++i)
                    if (lightSide * glm::dot(*plane, dvec4(box.corner(i), 1.0)) < -slack) return false;
                return true;
            });
        }
        if (!nothingBehind) useful.push_back(o);
    }
    return useful;
}

} // namespace shadowlab::scene
