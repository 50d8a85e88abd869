// A row's pixels in lanes: every coordinate in an array of its own, so that one vector instruction works on several pixels.
//
// The formulas are those of techniques/foundation/scene/query/shading.h, which shades one point at a time: lane_kernel.h has them as
// loops that compilers turn into vector instructions, and is compiled once for any processor and once for those with AVX2, whose
// vectors are twice as long. What is a power or an angle is found here, pixel by pixel, where there is one. No GL here.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "techniques/foundation/image/image.h"
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::ray_tracing {

// Of pixels that are shaded together: their arrays fit into the smallest cache, and are a whole number of vectors.
constexpr std::size_t kLanes = 64;
using Lane = float[kLanes];

/// Positions are relative to the eye, directions unit vectors, both along the axes of the world. The three arrays are of x, y and z,
/// or of red, green and blue.
struct PixelLanes {
    std::size_t count = 0; ///< pixels that there are; what is in lanes beyond them is not used
    bool anySpecular = false;
    Lane positionEye[3];
    Lane normalWorld[3]; ///< of any length; after turnToEye unit
    Lane mayTurn;        ///< 1: of that it is not known on which side it is, and turnToEye turns it to the eye's; 0: it is on that side
    Lane toEyeWorld[3];  ///< after turnToEye
    Lane diffuse[3], specular[3], shininess;
    Lane isLit; ///< by the light that is added: 1 or 0
    Lane radiance[3];
};

/// A light, as a point where it has an area.
struct LaneLight {
    scene::LightType type{};
    float positionEye[3];
    float axisWorld[3]; ///< the way the light of a sun or a spot travels; the normal of a rect light
    float intensity[3];
    float halfConeRadians = 0, edgeRadians = 0; ///< of a spot; without an edge 0
};

/// What of a light comes to each pixel.
struct LightLanes {
    Lane toLightWorld[3];
    Lane cosAtLight; ///< between the light's axis and the way to the pixel
    Lane falloff;    ///< irradiance per intensity; 0 in shadow
};

/// The loops, for one kind of processor.
struct LaneKernels {
    const char* name;
    void (*turnToEye)(PixelLanes& pixels);
    void (*aim)(const PixelLanes& pixels, const LaneLight& light, LightLanes& aimed);
    void (*addDiffuse)(PixelLanes& pixels, const LaneLight& light, const LightLanes& aimed);
    void (*halfway)(const PixelLanes& pixels, const LightLanes& aimed, Lane& cosHalfway);
    /// Red in the lowest byte, green, blue, and 255 in the highest.
    void (*encode)(const PixelLanes& pixels, float exposure, std::uint32_t (&colors)[kLanes]);
};

extern const LaneKernels kGenericLaneKernels;
/// None where the processor has no AVX2, or the build is for another kind.
const LaneKernels* avx2LaneKernels();
const LaneKernels& bestLaneKernels();

LaneLight laneLight(const scene::Light& light, const dvec3& eyeWorld);
/// Adds what the light gives to the pixels that are lit by it; after turnToEye.
void addLight(const LaneKernels& kernels, PixelLanes& pixels, const LaneLight& light);
/// Exposed, clamped and encoded as sRGB.
void encode(const LaneKernels& kernels, const PixelLanes& pixels, float exposure, std::span<image::Color8> colors);

} // namespace shadowlab::ray_tracing
