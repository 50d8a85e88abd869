// Edits of an immutable scene: each returns a new snapshot that shares all unchanged parts with the old one.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// One object moved, in metres, with all its pieces. Only the revision of the transforms is new. The surface of a light stays
/// with its light: move that (withLights).
Snapshot withObjectMovedBy(const Snapshot& snapshot, std::size_t object, const dvec3& byWorld);

/// Every object that has a velocity, so many seconds on its way from where it is in `atRest`. The same snapshot when
/// nothing moves.
Snapshot atTime(const Snapshot& atRest, double seconds);

/// The scene as that camera of its own sees it.
Snapshot seenFrom(const Snapshot& snapshot, const Viewpoint& viewpoint);

} // namespace shadowlab::scene
