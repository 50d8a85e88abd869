// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/probe/texel_depths.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::shadow_map {

namespace {

/// The smallest step of the format, that glPolygonOffset counts in; of floats that of the largest depth of the triangle.
double unitOf(ShadowMapParams::DepthFormat format, double largestDepth) {
    switch (format) {
    case ShadowMapParams::DepthFormat::fixed16: return 1.0 / 65535;
    case ShadowMapParams::DepthFormat::fixed24: return 1.0 / 16777215;
    case ShadowMapParams::DepthFormat::float32: break;
    }
    constexpr int kMantissa = 23;
    return std::ldexp(1.0, std::ilogb(std::max(largestDepth, 1e-30)) - kMantissa);
}

/// The difference below which the dual-depth pass takes two depths for one surface: as in depth_pass.cpp.
double depthEpsilon(ShadowMapParams::DepthFormat format) {
    return format == ShadowMapParams::DepthFormat::fixed16 ? 4.0 / (1 << 16) : 4.0 / (1 << 24);
}

void findBounds(const std::array<dvec4, 3>& clip, dvec2& lowerNdc, dvec2& upperNdc) {
    constexpr double kEverywhere = 1e300;
    lowerNdc = dvec2(kEverywhere);
    upperNdc = dvec2(-kEverywhere);
    for (const dvec4& corner : clip) {
        if (corner.w <= 0) {
            lowerNdc = dvec2(-kEverywhere);
            upperNdc = dvec2(kEverywhere);
            return;
        }
        lowerNdc = glm::min(lowerNdc, dvec2(corner) / corner.w);
        upperNdc = glm::max(upperNdc, dvec2(corner) / corner.w);
    }
    constexpr double kRounding = 1e-12; // of a division: the exact test is still to come
    lowerNdc -= kRounding;
    upperNdc += kRounding;
}

} // namespace

double asKept(ShadowMapParams::DepthFormat format, double depth) {
    if (format == ShadowMapParams::DepthFormat::float32) return static_cast<double>(static_cast<float>(depth));
    const double steps = 1 / unitOf(format, 1);
    return std::round(depth * steps) / steps;
}

TexelDepths::TexelDepths(const Asked& asked) : scene_(asked.scene), params_(asked.params), rules_(asked.rules) {
    const dmat4 lightClip = asked.maps.lightClipFromLightRelative(asked.layer);
    for (const std::size_t caster : asked.casters) {
        const scene::Object& object = scene_.objects[caster];
        const dmat4 clipFromMesh = lightClip * lightRelativeFromMesh(asked.maps, object);
        std::vector<dvec4> clip;
        for (const vec3& positionMesh : object.mesh->positionsMesh)
            clip.push_back(clipFromMesh * dvec4(dvec3(positionMesh), 1.0));
        const bool hasHoles = scene::hasHoles(scene_, object), mirrored = scene::isMirrored(object);
        const scene::Bounds& box = asked.bounds[caster];
        const bool lightIsOutside = asked.maps.parallel ||
                                    glm::any(glm::lessThan(asked.maps.originWorld, box.lowerWorld)) ||
                                    glm::any(glm::greaterThan(asked.maps.originWorld, box.upperWorld));
        const bool frontsSuffice = object.mesh->outward && !hasHoles && lightIsOutside;
        for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
            const uvec3& corners = object.mesh->triangles[t];
            Triangle triangle{.clip = {clip[corners.x], clip[corners.y], clip[corners.z]},
                              .object = caster,
                              .triangle = t,
                              .hasHoles = hasHoles};
            findBounds(triangle.clip, triangle.lowerNdc, triangle.upperNdc);
            const auto row = [&](std::size_t i) {
                return dvec3(triangle.clip[i].x, triangle.clip[i].y, triangle.clip[i].w);
            };
            const double turn = glm::dot(row(0), glm::cross(row(1), row(2))); // counter-clockwise in the map: positive
            triangle.isLeftOut = frontsSuffice && (turn > 0) == mirrored;
            triangles_.push_back(triangle);
        }
    }
}

/// At a place of the map, in the light's normalised device coordinates; none where the triangle does not cover it.
std::optional<TexelDepths::Depth> TexelDepths::depthOf(const Triangle& triangle, const dvec2& ndc) const {
    // Weights of the corners at which x / w and y / w are those of the place. Nothing is divided by w: a triangle may reach
    // behind the light.
    std::array<dvec2, 3> p{};
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = dvec2(triangle.clip[i]) - ndc * triangle.clip[i].w;
    const auto cross = [](const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; };
    dvec3 weights(cross(p[1], p[2]), cross(p[2], p[0]), cross(p[0], p[1]));
    const bool inside =
        glm::all(glm::greaterThanEqual(weights, dvec3(0))) || glm::all(glm::lessThanEqual(weights, dvec3(0)));
    const double sum = weights.x + weights.y + weights.z;
    if (!inside || sum == 0) return std::nullopt;
    weights /= sum;
    double w = 0, z = 0;
    for (int i = 0; i < 3; ++i) {
        w += weights[i] * triangle.clip[static_cast<std::size_t>(i)].w;
        z += weights[i] * triangle.clip[static_cast<std::size_t>(i)].z;
    }
    if (w <= 0) return std::nullopt; // behind the light
    if (triangle.hasHoles && scene::isInHole(scene_, scene_.objects[triangle.object], triangle.triangle, weights))
        return std::nullopt;
    Depth depth;
    depth.own = 0.5 * z / w + 0.5;
    if (!rules_.depthClamp && (depth.own < 0 || depth.own > 1)) return std::nullopt;
    // z / w = A x / w + B y / w + C on the triangle, so z = A x + B y + C w at its corners.
    const auto& c = triangle.clip;
    const dmat3 rows = glm::transpose(
        dmat3(dvec3(c[0].x, c[0].y, c[0].w), dvec3(c[1].x, c[1].y, c[1].w), dvec3(c[2].x, c[2].y, c[2].w)));
    const dvec3 slopes = glm::inverse(rows) * dvec3(c[0].z, c[1].z, c[2].z);
    const double perTexel = std::max(std::abs(slopes.x), std::abs(slopes.y)) / params_.resolution;
    double largest = 0;
    for (const dvec4& corner : c)
        largest = std::max(largest, 0.5 * corner.z / corner.w + 0.5);
    depth.pushed = depth.own + rules_.slopeFactor * perTexel + rules_.units * unitOf(params_.depthFormat, largest);
    return depth;
}

TexelDepth TexelDepths::at(const ivec2& asked) const {
    ivec2 texel = asked;
    if (params_.border == ShadowMapParams::Border::edge)
        texel = glm::clamp(asked, ivec2(0), ivec2(params_.resolution - 1));
    TexelDepth result;
    if (glm::any(glm::lessThan(texel, ivec2(0))) || glm::any(glm::greaterThanEqual(texel, ivec2(params_.resolution))))
        return result;
    const dvec2 ndc = (dvec2(texel) + 0.5) / static_cast<double>(params_.resolution) * 2.0 - 1.0;
    std::vector<double> own; // of all surfaces, those too that are left out, for the second one
    double nearest = 1e300;
    for (const Triangle& triangle : triangles_) {
        if (glm::any(glm::lessThan(ndc, triangle.lowerNdc)) || glm::any(glm::greaterThan(ndc, triangle.upperNdc)))
            continue;
        const auto depth = depthOf(triangle, ndc);
        if (!depth) continue;
        own.push_back(glm::clamp(depth->own, 0.0, 1.0));
        if (triangle.isLeftOut) continue;
        result.stored = std::min(result.stored, glm::clamp(depth->pushed, 0.0, 1.0));
        if (depth->own >= nearest) continue;
        nearest = depth->own;
        result.first = glm::clamp(depth->own, 0.0, 1.0);
        result.clamped = depth->own;
        result.object = triangle.object;
        result.triangle = triangle.triangle;
    }
    if (rules_.dual && nearest < 1) {
        double second = 1;
        for (const double depth : own)
            if (depth > result.first + depthEpsilon(params_.depthFormat)) second = std::min(second, depth);
        result.stored = std::min(0.5 * (result.first + second), result.stored);
    }
    return result;
}

} // namespace shadowlab::shadow_map
