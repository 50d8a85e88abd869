// Colours with a fixed meaning everywhere, chosen to survive colour blindness and a washed-out projector.
// Source of the qualitative set: Okabe and Ito, "Color Universal Design", 2008.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/foundation/math/types.h"

namespace shadowlab::look {

/// sRGB 0..255 to the linear light that pictures are computed in.
vec3 linearFromSrgb8(int r, int g, int b);

// Which side of a triangle faces the light (sign of N.L).
inline const vec3 kTowardLight = linearFromSrgb8(0xF0, 0xE4, 0x42);
inline const vec3 kAwayFromLight = linearFromSrgb8(0x56, 0xB4, 0xE9);

// Edges of a caster as the light sees it.
inline const vec3 kSilhouette = linearFromSrgb8(0xD5, 0x5E, 0x00);
inline const vec3 kBoundaryEdge = linearFromSrgb8(0x00, 0x9E, 0x73);
inline const vec3 kMultipleEdge = linearFromSrgb8(0xCC, 0x79, 0xA7);

// The comparison of a shadow map: equal depths, an occluder in between, nothing stored, not asked.
inline const vec3 kEqualDepth = linearFromSrgb8(0x00, 0x9E, 0x73);
inline const vec3 kOccluded = linearFromSrgb8(0xD5, 0x5E, 0x00);
inline const vec3 kNothingStored = linearFromSrgb8(0x56, 0xB4, 0xE9);
inline const vec3 kNotAsked = linearFromSrgb8(0x60, 0x60, 0x60);

/// A palette: evenly spaced stops, linear RGB.
using Palette = std::array<vec3, 9>;

/// Magnitudes: viridis (van der Walt and Smith, 2015), perceptually even, dark to bright.
const Palette& viridis();

/// Signed counts: blue through a neutral light grey at zero to red (after Brewer's RdBu).
const Palette& diverging();

/// The palette at 0..1, interpolated.
vec3 colorAt(const Palette& palette, double t);

} // namespace shadowlab::look
