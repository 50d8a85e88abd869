// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/edit_scene.h"

#include <algorithm>

namespace shadowlab::scene {

Snapshot withObjectMovedBy(const Snapshot& snapshot, std::size_t object, const dvec3& byWorld) {
    if (object >= snapshot->objects.size() || snapshot->objects[object].emitterOfLight >= 0) return snapshot;
    auto moved = std::make_shared<Scene>(*snapshot);
    moved->objects[object].worldFromObject[3] += dvec4(byWorld, 0.0);
    moved->revisions.transforms = newRevision();
    return moved;
}

Snapshot atTime(const Snapshot& atRest, double seconds) {
    const bool anyMoves =
        std::ranges::any_of(atRest->objects, [](const Object& object) { return object.velocityWorld != dvec3(0.0); });
    if (seconds == 0 || !anyMoves) return atRest;
    auto moved = std::make_shared<Scene>(*atRest);
    for (Object& object : moved->objects)
        object.worldFromObject[3] += dvec4(object.velocityWorld * seconds, 0.0);
    moved->revisions.transforms = newRevision();
    return moved;
}

} // namespace shadowlab::scene
