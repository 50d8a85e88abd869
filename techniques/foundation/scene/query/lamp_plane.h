// The triangles that lie in the plane of a rect light.
//
// A lamp is often let into a ceiling: both are given at the same height. Such a face ends where the lamp begins, so it hides no part
// of the lamp, and the lamp does not light it. A mesh stores floats, so the face may be off the plane by their rounding: a ceiling at
// 548.8 lies at 548.79999. Within that rounding a triangle counts as in the plane, and no farther: a face one nanometre before a
// lamp in a room of metres hides it.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// For each triangle of the object 1 if it lies in the plane of the light, else 0. Empty if none does: of a light that is no rect
/// always.
std::vector<std::uint8_t> inLampPlane(const Object& object, const Light& light);

/// For each triangle of all objects, one after the other; empty if none lies in the plane.
std::vector<std::uint8_t> inLampPlane(const Scene& scene, const Light& light);

/// Sets the facing signs (facing.h) of the object's triangles in the plane of the light to 0.
void clearInLampPlane(const Object& object, const Light& light, std::span<std::int8_t> signs);

} // namespace shadowlab::scene
