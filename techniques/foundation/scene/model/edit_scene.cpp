// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/edit_scene.h"

#include <algorithm>

#include "techniques/foundation/scene/model/object_pieces.h"

namespace shadowlab::scene {

namespace {

/// The matrix is computed from the source, so that a scene that is written and read again is the same to the last bit.
void move(Object& object, const dvec3& byWorld) {
    object.source.translateWorld += byWorld;
    if (object.source.objectFromNode == dmat4(1.0))
        object.worldFromObject[3] = dvec4(object.source.translateWorld, 1.0);
    else
        object.worldFromObject = worldFromObjectOf(object.source);
}

} // namespace

Snapshot withObjectMovedBy(const Snapshot& snapshot, std::size_t object, const dvec3& byWorld) {
    if (object >= snapshot->objects.size() || snapshot->objects[object].emitterOfLight >= 0) return snapshot;
    auto moved = std::make_shared<Scene>(*snapshot);
    for (auto [piece, end] = piecesOf(*moved, object); piece < end; ++piece)
        move(moved->objects[piece], byWorld);
    moved->revisions.transforms = newRevision();
    return moved;
}

Snapshot atTime(const Snapshot& atRest, double seconds) {
    const bool anyMoves =
        std::ranges::any_of(atRest->objects, [](const Object& object) { return object.velocityWorld != dvec3(0.0); });
    if (seconds == 0 || !anyMoves) return atRest;
    auto moved = std::make_shared<Scene>(*atRest);
    for (Object& object : moved->objects)
        if (object.velocityWorld != dvec3(0.0)) move(object, object.velocityWorld * seconds);
    moved->revisions.transforms = newRevision();
    return moved;
}

Snapshot seenFrom(const Snapshot& snapshot, const Viewpoint& viewpoint) {
    const auto scene = std::make_shared<Scene>(*snapshot);
    scene->camera = viewpoint.camera;
    return scene;
}

} // namespace shadowlab::scene
