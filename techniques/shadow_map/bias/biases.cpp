// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/bias/biases.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/shadow_map/bias/compared_depth.h"

namespace shadowlab::shadow_map {

namespace {

/// A step toward the light, in texels or metres (bias_constant.glsl).
dvec4 steppedTowardLight(const DepthComparison& of, const dvec4& clip, const dvec3& point, const dvec3&) {
    const BiasParams& bias = of.params().bias;
    const bool metres = bias.unit == BiasParams::Unit::metres;
    const double step = metres ? bias.constantTexels : bias.constantTexels * of.texelMetres(clip);
    return clip + of.lightClipFromLightRelative() * dvec4(step * of.towardLight(point), 0.0);
}

/// A step along the receiver's normal (bias_normal_offset.glsl, which says why it is that long).
dvec4 steppedAlongNormal(const DepthComparison& of, const dvec4& clip, const dvec3& point, const dvec3& normalAnySide) {
    const dvec3 towardLight = of.towardLight(point);
    dvec3 normal = normalAnySide;
    double cosine = glm::dot(normal, towardLight);
    if (cosine < 0) {
        normal = -normal;
        cosine = -cosine;
    }
    const dmat4 rows = glm::transpose(of.lightClipFromLightRelative());
    const dvec3 gradient = dvec3(rows[2]) * clip.w - dvec3(rows[3]) * clip.z;
    dvec3 nearer = normal - gradient * (cosine / glm::dot(gradient, towardLight));
    nearer -= towardLight * glm::dot(nearer, towardLight);
    const double metres =
        of.params().bias.normalOffset * of.kernelTexels() * std::sqrt(2.0) * of.texelMetres(clip) * glm::length(nearer);
    return clip + of.lightClipFromLightRelative() * dvec4(metres * normal, 0.0);
}

/// The receiver's plane at the offset, less half a texel of its slope (bias_receiver_plane.glsl).
double planeOffset(const DepthComparison& of, const ComparedPlace& place, const dvec2& offsetUv) {
    const double halfTexel = of.params().bias.slope * 0.5 / of.params().resolution;
    const double toward = halfTexel > 0 ? std::min(glm::dot(place.slope, offsetUv), 0.0) : 0.0;
    return toward - halfTexel * (std::abs(place.slope.x) + std::abs(place.slope.y));
}

/// The receiver's plane at the centre of the texel (bias_adaptive.glsl).
double centreOffset(const DepthComparison& of, const ComparedPlace& place, const dvec2& offsetUv) {
    const auto resolution = static_cast<double>(of.params().resolution);
    const dvec2 centreUv = (glm::floor((place.uv + offsetUv) * resolution) + 0.5) / resolution;
    return glm::dot(place.slope, centreUv - place.uv);
}

// Of a kernel's texels the farthest centre is radius + 1/2 away in both directions; the factor is for the larger of the two slopes,
// and the other may be as large.
double slopeOfKernel(const BiasParams& bias, double radius) { return bias.slope * (2 * radius + 1); }

// The receiver's slope (planeOffset) covers its own plane and convex corners. In a concave corner the kernel also meets a steeper
// neighbour: its depths are pushed back by its own slope, one texel for a single comparison and one more for each texel of radius.
double slopeOfNeighbour(const BiasParams& bias, double radius) { return bias.slope * (1 + radius); }

constexpr BiasInfo kBiases[] = {
    {.name = "none", .what = "no bias", .shader = "shadow_map/bias/bias_none.glsl", .params = {}},
    {.name = "constant",
     .what = "constant offset",
     .shader = "shadow_map/bias/bias_constant.glsl",
     .params = {"constant-bias", "bias-unit", "rounding-bias"},
     .biasedClip = steppedTowardLight},
    {.name = "slope-scaled",
     .what = "slope-scaled offset of casters",
     .shader = "shadow_map/bias/bias_slope_scaled.glsl",
     .params = {"slope-bias", "rounding-bias"},
     .slopeFactor = slopeOfKernel},
    {.name = "normal-offset",
     .what = "step along the receiver's normal",
     .shader = "shadow_map/bias/bias_normal_offset.glsl",
     .params = {"normal-offset", "rounding-bias"},
     .biasedClip = steppedAlongNormal},
    {.name = "receiver-plane",
     .what = "receiver's plane at each texel",
     .shader = "shadow_map/bias/bias_receiver_plane.glsl",
     .params = {"slope-bias", "rounding-bias"},
     .comparesWithOneDepth = false,
     .slopeFactor = slopeOfNeighbour,
     .depthOffset = planeOffset},
    {.name = "dual-depth",
     .what = "midway between two surfaces",
     .shader = "shadow_map/bias/bias_dual_depth.glsl",
     .params = {"slope-bias", "rounding-bias"},
     .isDualDepth = true,
     .slopeFactor = slopeOfKernel},
    {.name = "adaptive",
     .what = "receiver's plane, texel centre",
     .shader = "shadow_map/bias/bias_adaptive.glsl",
     .params = {"rounding-bias"},
     .comparesWithOneDepth = false,
     .comparesAtCentres = true,
     .depthOffset = centreOffset},
};

} // namespace

std::span<const BiasInfo> biases() { return kBiases; }

const BiasInfo& biasInfo(BiasMode mode) { return kBiases[static_cast<std::size_t>(mode)]; }

BiasMode biasNamed(std::string_view name) {
    const auto* found = std::ranges::find(kBiases, name, &BiasInfo::name);
    if (found == std::end(kBiases)) throw Error(ExitStatus::bug, "there is no shadow map bias " + std::string(name));
    return static_cast<BiasMode>(found - std::begin(kBiases));
}

bool BiasInfo::reads(std::string_view param) const { return std::ranges::find(params, param) != params.end(); }

params::ParamList describe(BiasParams& p) {
    using params::inGroup;
    std::vector<params::Named> choices;
    for (const BiasInfo& bias : kBiases)
        choices.emplace_back(bias.name, bias.what);
    params::ParamList all{params::choice({"bias-mode", "Bias type"}, p.mode, choices,
                                         "What keeps a surface from shadowing itself (acne), though one texel holds "
                                         "one depth for a whole piece of it.")};
    params::ParamList own{
        params::real({"constant-bias", "Constant bias"}, p.constantTexels, 0, 1000, "",
                     "Bias constant: how far the point is moved toward the light before it is compared; too far, and "
                     "shadows come off their casters (Peter-panning)."),
        inGroup("Bias",
                params::choice(
                    {"bias-unit", "Unit of the constant bias"}, p.unit, {"texels", "metres"},
                    "Texels fit any map and scene; metres are right for one scale of the scene only (teaching).")),
        params::real({"slope-bias", "Slope bias"}, p.slope, 0, 16, "",
                     "Biases slope-scaled, receiver-plane and dual-depth: offset in proportion to the surface's slope; "
                     "1 is what the kernel needs on a plane, 0 shows acne (teaching)."),
        params::real(
            {"normal-offset", "Normal offset"}, p.normalOffset, 0, 16, "",
            "Bias normal-offset: how far the point is moved along its normal; 1 is what the kernel needs on a plane."),
        inGroup("Bias", params::real({"rounding-bias", "Rounding bias"}, p.rounding, 0, 1000, "",
                                     "Every bias but none: offset against rounding; 1 is what float positions and the "
                                     "bits of a depth need.")),
    };
    for (params::Param& param : own) {
        const auto isRead = [&p, id = param.id] { return biasInfo(p.mode).reads(id); };
        all.push_back(params::onlyIf(isRead, std::move(param)));
    }
    return all;
}

} // namespace shadowlab::shadow_map
