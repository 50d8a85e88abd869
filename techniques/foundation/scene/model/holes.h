// Where the objects of a scene have holes: parts whose material has an alpha mask, and that an image can be laid on.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The mask that cuts holes into a part of the object's mesh; nullptr: the part is whole.
const AlphaMask* maskOfPart(const Scene& scene, const Object& object, std::size_t part);

/// Has any part of it holes?
bool hasHoles(const Scene& scene, const Object& object);

/// Does a point of a triangle of the object, given by the weights of its corners, lie in a hole?
bool isInHole(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric);

/// What to tell the user of a part of a mesh that stays whole although its material has a mask; empty: nothing.
std::string noteOnWholePart(const Material& material, const MeshPart& part);

} // namespace shadowlab::scene
