// Colours with a fixed meaning everywhere, chosen to survive colour blindness and a washed-out projector.
// Source of the qualitative set: Okabe and Ito, "Color Universal Design", 2008.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/foundation/math/types.h"

namespace shadowlab::look {

/// sRGB 0..255 to the linear light that pictures are computed in.
vec3 linearFromSrgb8(int r, int g, int b);

// Which side of a triangle faces the light (sign of N.L). Turned away it has the same colour where the truth is shown (kTurnedAway).
inline const vec3 kTowardLight = linearFromSrgb8(0xF0, 0xE4, 0x42);
inline const vec3 kAwayFromLight = linearFromSrgb8(0x56, 0x6B, 0x8C);

// Edges of a caster as the light sees it.
inline const vec3 kSilhouette = linearFromSrgb8(0xD5, 0x5E, 0x00);
inline const vec3 kBoundaryEdge = linearFromSrgb8(0x8A, 0x63, 0xFF);
inline const vec3 kMultipleEdge = linearFromSrgb8(0xCC, 0x79, 0xA7);
inline const vec3 kInconsistentEdge = linearFromSrgb8(0xF0, 0xE4, 0x42);

// The parts of a shadow volume. No two are alike, and none is like the edges, the eye or the light: all of them are seen in one
// picture.
inline const vec3 kTopCap = linearFromSrgb8(0x00, 0x9E, 0x73);
inline const vec3 kVolumeSide = linearFromSrgb8(0xCC, 0x79, 0xA7);
inline const vec3 kBottomCap = linearFromSrgb8(0x56, 0xB4, 0xE9);
inline const vec3 kNearClipPyramid = linearFromSrgb8(0xE6, 0x9F, 0x00);

// The method that counts a caster's volume.
inline const vec3 kDepthPass = linearFromSrgb8(0x90, 0xF0, 0xA8);
inline const vec3 kDepthFail = linearFromSrgb8(0x00, 0x72, 0xB2);

/// Half the width of a line in pixels, so that it is visible from the last row of a lecture hall: the width is about 1/240
/// of the picture's height.
int lineRadius(int height);

// A dark rim on either side of a line: it stands out from a white floor as from a black background.
inline const vec3 kLineRim = linearFromSrgb8(0x0A, 0x0A, 0x0C);
constexpr float kLineRimAlpha = 0.75f;

// The comparison of a shadow map: equal depths, an occluder in between, nothing stored, not asked.
inline const vec3 kEqualDepth = linearFromSrgb8(0x00, 0x9E, 0x73);
inline const vec3 kOccluded = linearFromSrgb8(0xD5, 0x5E, 0x00);
inline const vec3 kPartlySeen = linearFromSrgb8(0xF0, 0xE4, 0x42); ///< of a light with an area
inline const vec3 kNothingStored = linearFromSrgb8(0x56, 0xB4, 0xE9);
inline const vec3 kNotAsked = linearFromSrgb8(0x60, 0x60, 0x60);

// What a second camera, outside, shows of the first camera and of the lights: the eye with its view and its rays; the chosen
// light, the other lights; the cameras of a shadow map. White is the eye's: every other colour is then left for what a
// technique has in the scene.
inline const vec3 kEye = linearFromSrgb8(0xF2, 0xF2, 0xF2);
inline const vec3 kEyeRay = kEye;
inline const vec3 kChosenLight = linearFromSrgb8(0xF0, 0xE4, 0x42);
inline const vec3 kOtherLight = linearFromSrgb8(0xB0, 0xB0, 0xB0);
inline const vec3 kReflectionRay = linearFromSrgb8(0xCC, 0x79, 0xA7);
inline const vec3 kRefractionRay = linearFromSrgb8(0xE6, 0x9F, 0x00);
inline const vec3 kVisited = linearFromSrgb8(0x56, 0xB4, 0xE9); ///< cells and volumes on a ray's way
inline const vec3 kLightFrustum = linearFromSrgb8(0xE6, 0x9F, 0x00);
inline const vec3 kMapTexel = linearFromSrgb8(0xCC, 0x79, 0xA7); ///< one texel of a map, on the surface that it is compared with
inline const vec3 kReceiverPlane = linearFromSrgb8(0x56, 0xB4, 0xE9);
inline const vec3 kPassedOver = linearFromSrgb8(0xCC, 0x79, 0xA7); ///< triangles on a light's line that do not stand in its way

// The two patches of a form factor: j, which the pixel shows, and k.
inline const vec3 kPatchJ = linearFromSrgb8(0xE6, 0x9F, 0x00);
inline const vec3 kPatchK = linearFromSrgb8(0x56, 0xB4, 0xE9);

/// The maps of one light: cascades from the eye outward, or those along +x -x +y -y +z -z.
inline const std::array<vec3, 6> kLayers = {linearFromSrgb8(0xD5, 0x5E, 0x00), linearFromSrgb8(0x00, 0x9E, 0x73),
                                            linearFromSrgb8(0xCC, 0x79, 0xA7), linearFromSrgb8(0x00, 0x72, 0xB2),
                                            linearFromSrgb8(0xE6, 0x9F, 0x00), linearFromSrgb8(0xF2, 0xF2, 0xF2)};

// A technique's visibility compared with the truth; correct pixels show the picture in grey.
inline const vec3 kFalseLit = linearFromSrgb8(0xE6, 0x9F, 0x00);
inline const vec3 kFalseShadow = linearFromSrgb8(0x00, 0x72, 0xB2);
inline const vec3 kFalseLitSecond = linearFromSrgb8(0xD5, 0x5E, 0x00); ///< of the second of two techniques
inline const vec3 kFalseShadowSecond = linearFromSrgb8(0x56, 0xB4, 0xE9);
inline const vec3 kTie = linearFromSrgb8(0x99, 0x99, 0x99);
inline const vec3 kTieOnPicture = linearFromSrgb8(0x40, 0x40, 0x44); ///< darker than the lifted ground gets anywhere
inline const vec3 kStray = linearFromSrgb8(0xCC, 0x79, 0xA7);

// The true visibility.
inline const vec3 kLit = linearFromSrgb8(0xF2, 0xF2, 0xF2);
inline const vec3 kShadowed = linearFromSrgb8(0x38, 0x38, 0x3C);
inline const vec3 kTurnedAway = kAwayFromLight;
inline const vec3 kNoSurface = linearFromSrgb8(0x0C, 0x0C, 0x0E);
// Where shadows end by it: a plain line with a dark rim. It is where the sides of shadow volumes meet surfaces, and has their colour.
inline const vec3 kTrueOutline = kVolumeSide;

/// A palette: evenly spaced stops, linear RGB.
using Palette = std::array<vec3, 9>;

/// Magnitudes: viridis (van der Walt and Smith, 2015), perceptually even, dark to bright.
const Palette& viridis();

/// Signed counts: blue through a neutral light grey at zero to red (after Brewer's RdBu).
const Palette& diverging();

/// The palette at 0..1, interpolated.
vec3 colorAt(const Palette& palette, double t);

} // namespace shadowlab::look
