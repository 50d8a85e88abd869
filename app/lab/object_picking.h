// Which object lies under the mouse.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::lab {

struct ObjectHit {
    std::size_t object = 0; ///< index into Scene::objects, of an object in pieces that of the first
    dvec3 positionWorld{0.0};
};

/// The first surface that the eye's ray through that pixel meets, counted from the picture's upper left corner; nothing where it
/// meets none. The surfaces of lights are looked through, and holes of alpha masks are not: a leaf is taken hold of at once.
/// `bounds` are those of the objects. Tries every triangle of each object whose box the ray meets: about a millisecond for 100,000.
std::optional<ObjectHit> objectAt(const scene::Scene& scene, const std::vector<scene::Bounds>& bounds,
                                  const scene::Camera& camera, ivec2 size, dvec2 pixel);

/// Is it what the others stand on, or in: a floor, a room? It spans more than half of the whole scene.
bool isBackdrop(const std::vector<scene::Bounds>& bounds, std::size_t object);

} // namespace shadowlab::lab
