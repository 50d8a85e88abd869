// Which side of each triangle a light is on: decided once per triangle and light, in double, and stored.
//
// Everything that depends on it reads the stored sign: the facing gate of visibility, and both the caps and the sides
// of a shadow volume. A volume is watertight because of that single decision, whatever it is for a triangle seen
// edge-on.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The light as a homogeneous point of the object's mesh space (w = 1, or 0 for a direction toward it).
dvec4 lightMesh(const Object& object, const Light& light);

/// One triangle, its corners counter-clockwise, and a homogeneous light in the same space: +1, -1 or 0 as below.
std::int8_t facingSign(const dvec3& a, const dvec3& b, const dvec3& c, const dvec4& light);

/// One sign per triangle of the object: +1 the light is on the counter-clockwise (front) side, -1 behind,
/// 0 in the plane of the triangle to within rounding (for a rect light see lamp_plane.h, too). The lecture's N.L > 0 is +1; 0 counts as facing away.
std::vector<std::int8_t> facingSigns(const Object& object, const Light& light);

/// The signs of all objects, one after the other.
std::vector<std::int8_t> facingSigns(const Scene& scene, const Light& light);

} // namespace shadowlab::scene
