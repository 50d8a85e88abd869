// Shading and encoding of pixels in lanes (pixel_lanes.h). Included by one file for each kind of processor; everything has internal
// linkage, so that each keeps its own, and calls no function that another file shares.
//
// Every loop goes over all lanes, for a row that is shorter as well: with a number known beforehand compilers need no remainder.
// SPDX-License-Identifier: MIT
#pragma once
#include <math.h>

#include "techniques/ray_tracing/lanes/pixel_lanes.h"

namespace shadowlab::ray_tracing {
namespace {

constexpr float kPerPi = 0.318309886f;

void turnToEye(PixelLanes& pixels) {
    const auto& p = pixels.positionEye;
    auto& n = pixels.normalWorld;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float perDistance = -1.0f / sqrtf(p[0][i] * p[0][i] + p[1][i] * p[1][i] + p[2][i] * p[2][i]);
        const float perLength = 1.0f / sqrtf(n[0][i] * n[0][i] + n[1][i] * n[1][i] + n[2][i] * n[2][i]);
        const float away = n[0][i] * p[0][i] + n[1][i] * p[1][i] + n[2][i] * p[2][i];
        const float turned = (away > 0.0f) & (pixels.mayTurn[i] > 0.0f) ? -perLength : perLength;
        pixels.toEyeWorld[0][i] = p[0][i] * perDistance;
        pixels.toEyeWorld[1][i] = p[1][i] * perDistance;
        pixels.toEyeWorld[2][i] = p[2][i] * perDistance;
        n[0][i] *= turned;
        n[1][i] *= turned;
        n[2][i] *= turned;
    }
}

/// Of a sun: from everywhere the same way, and as strong.
void aimSun(const PixelLanes& pixels, const LaneLight& light, LightLanes& aimed) {
    const float x = -light.axisWorld[0], y = -light.axisWorld[1], z = -light.axisWorld[2];
    const auto& n = pixels.normalWorld;
    for (std::size_t i = 0; i < kLanes; ++i) {
        aimed.toLightWorld[0][i] = x;
        aimed.toLightWorld[1][i] = y;
        aimed.toLightWorld[2][i] = z;
        const float left = n[0][i] * x + n[1][i] * y + n[2][i] * z;
        aimed.falloff[i] = (pixels.isLit[i] > 0.0f) & (left > 0.0f) ? left : 0.0f;
    }
}

void aimPoint(const PixelLanes& pixels, const LaneLight& light, LightLanes& aimed) {
    const float lightX = light.positionEye[0], lightY = light.positionEye[1], lightZ = light.positionEye[2];
    const float axisX = light.axisWorld[0], axisY = light.axisWorld[1], axisZ = light.axisWorld[2];
    const auto& p = pixels.positionEye;
    const auto& n = pixels.normalWorld;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = lightX - p[0][i], y = lightY - p[1][i], z = lightZ - p[2][i];
        const float perSquare = 1.0f / (x * x + y * y + z * z), perDistance = sqrtf(perSquare);
        aimed.toLightWorld[0][i] = x * perDistance;
        aimed.toLightWorld[1][i] = y * perDistance;
        aimed.toLightWorld[2][i] = z * perDistance;
        aimed.cosAtLight[i] = -(x * axisX + y * axisY + z * axisZ) * perDistance;
        const float left = (n[0][i] * x + n[1][i] * y + n[2][i] * z) * perDistance * perSquare;
        // Chosen, not multiplied: at the light itself `left` is no number.
        aimed.falloff[i] = (pixels.isLit[i] > 0.0f) & (left > 0.0f) ? left : 0.0f;
    }
}

void aim(const PixelLanes& pixels, const LaneLight& light, LightLanes& aimed) {
    if (light.type == scene::LightType::directional) return aimSun(pixels, light, aimed);
    aimPoint(pixels, light, aimed);
    if (light.type != scene::LightType::rect) return;
    for (std::size_t i = 0; i < kLanes; ++i)
        aimed.falloff[i] *= aimed.cosAtLight[i] > 0.0f ? aimed.cosAtLight[i] : 0.0f;
}

void addDiffuse(PixelLanes& pixels, const LaneLight& light, const LightLanes& aimed) {
    for (std::size_t c = 0; c < 3; ++c) {
        const float perIntensity = light.intensity[c] * kPerPi;
        for (std::size_t i = 0; i < kLanes; ++i)
            pixels.radiance[c][i] += aimed.falloff[i] * perIntensity * pixels.diffuse[c][i];
    }
}

void halfway(const PixelLanes& pixels, const LightLanes& aimed, Lane& cosHalfway) {
    const auto& n = pixels.normalWorld;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = aimed.toLightWorld[0][i] + pixels.toEyeWorld[0][i], y = aimed.toLightWorld[1][i] + pixels.toEyeWorld[1][i],
                    z = aimed.toLightWorld[2][i] + pixels.toEyeWorld[2][i];
        cosHalfway[i] = (x * n[0][i] + y * n[1][i] + z * n[2][i]) / sqrtf(x * x + y * y + z * z);
    }
}

/// The level of 255 of a linear value, by the polynomial of shaders/srgb.glsl.
inline std::uint32_t levelOf(float exposed) {
    const float atLeast = exposed > 0.0f ? exposed : 0.0f; // of no number 0
    const float linear = atLeast < 1.0f ? atLeast : 1.0f;
    const float t = sqrtf(sqrtf(linear));
    float bright = 0.068207979f;
    bright = bright * t - 0.318415992f;
    bright = bright * t + 0.657188290f;
    bright = bright * t - 0.852957453f;
    bright = bright * t + 1.365921050f;
    bright = bright * t + 0.139604136f;
    bright = bright * t - 0.059546609f;
    const float dark = 12.92f * linear;
    return static_cast<std::uint32_t>(static_cast<int>((linear > 0.0031308f ? bright : dark) * 255.0f + 0.5f));
}

void encode(const PixelLanes& pixels, float exposure, std::uint32_t (&colors)[kLanes]) {
    for (std::size_t i = 0; i < kLanes; ++i)
        colors[i] = levelOf(exposure * pixels.radiance[0][i]) | levelOf(exposure * pixels.radiance[1][i]) << 8 |
                    levelOf(exposure * pixels.radiance[2][i]) << 16 | 0xff000000u;
}

} // namespace
} // namespace shadowlab::ray_tracing
