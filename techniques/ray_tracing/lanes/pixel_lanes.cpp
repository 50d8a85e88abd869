// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/lanes/pixel_lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/shading.h"

namespace shadowlab::ray_tracing {

namespace {

void assign(float (&to)[3], const vec3& from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/// Toward a spot's rim its light fades.
void fadeTowardRim(const PixelLanes& pixels, const LaneLight& spot, LightLanes& aimed) {
    for (std::size_t i = 0; i < pixels.count; ++i) {
        if (aimed.falloff[i] == 0) continue;
        const float angle = std::acos(std::clamp(aimed.cosAtLight[i], -1.0f, 1.0f));
        aimed.falloff[i] *= glm::smoothstep(0.0f, spot.edgeRadians, spot.halfConeRadians - angle);
    }
}

/// Blinn's highlight, normalised: (s + 8) / (8 pi) * (n.h)^s.
void addSpecular(const LaneKernels& kernels, PixelLanes& pixels, const LaneLight& light, const LightLanes& aimed) {
    // Powers below this are left out, for a power takes longer than all else of a pixel and most of them are next to nothing: 1e-6 of a
    // light that makes a diffuse surface white, with the lobe of a shininess of 1000, is a thirtieth of a level of 255.
    constexpr float kLeast = 1e-6f;
    Lane cosHalfway;
    kernels.halfway(pixels, aimed, cosHalfway);
    float shininess = -1, leastCos = 0;
    for (std::size_t i = 0; i < pixels.count; ++i) {
        const float s = pixels.shininess[i];
        if (s != shininess) {
            shininess = s;
            leastCos = s > 1 ? std::pow(kLeast, 1 / s) : 0;
        }
        const bool isSpecular = pixels.specular[0][i] != 0 || pixels.specular[1][i] != 0 || pixels.specular[2][i] != 0;
        if (!isSpecular || aimed.falloff[i] == 0 || !(cosHalfway[i] >= leastCos)) continue;
        const float lobe = (s + 8) / (8 * glm::pi<float>()) * std::pow(cosHalfway[i], s);
        for (std::size_t c = 0; c < 3; ++c)
            pixels.radiance[c][i] += aimed.falloff[i] * light.intensity[c] * pixels.specular[c][i] * lobe;
    }
}

} // namespace

LaneLight laneLight(const scene::Light& light, const dvec3& eyeWorld) {
    LaneLight lane;
    lane.type = light.type;
    assign(lane.positionEye, vec3(light.positionWorld - eyeWorld));
    assign(lane.axisWorld, vec3(light.type == scene::LightType::rect ? scene::rectNormalWorld(light) : light.directionWorld));
    assign(lane.intensity, vec3(dvec3(light.color) * scene::pointIntensity(light)));
    if (light.type == scene::LightType::spot) {
        lane.halfConeRadians = static_cast<float>(glm::radians(light.coneDegrees) / 2);
        lane.edgeRadians = static_cast<float>(glm::radians(light.edgeDegrees));
    }
    return lane;
}

void addLight(const LaneKernels& kernels, PixelLanes& pixels, const LaneLight& light) {
    LightLanes aimed;
    kernels.aim(pixels, light, aimed);
    if (light.edgeRadians > 0) fadeTowardRim(pixels, light, aimed);
    kernels.addDiffuse(pixels, light, aimed);
    if (pixels.anySpecular) addSpecular(kernels, pixels, light, aimed);
}

void encode(const LaneKernels& kernels, const PixelLanes& pixels, float exposure, std::span<image::Color8> colors) {
    std::uint32_t encoded[kLanes];
    kernels.encode(pixels, exposure, encoded);
    if constexpr (std::endian::native == std::endian::little) { // the bytes are where they belong
        static_assert(sizeof(image::Color8) == sizeof(std::uint32_t));
        std::memcpy(colors.data(), encoded, pixels.count * sizeof(image::Color8));
    } else {
        const auto byte = [](std::uint32_t color, int place) { return static_cast<std::uint8_t>(color >> (8 * place)); };
        for (std::size_t i = 0; i < pixels.count; ++i)
            colors[i] = {byte(encoded[i], 0), byte(encoded[i], 1), byte(encoded[i], 2), byte(encoded[i], 3)};
    }
}

} // namespace shadowlab::ray_tracing
