// What the shadow map knows of one pixel: the way from the point to its texel, what the texel holds, and the comparison.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <optional>

#include "techniques/exact_judge.h"
#include "techniques/shadow_map/technique.h"

namespace shadowlab::shadow_map {

namespace {

std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return digits;
}

template <typename Vector>
std::string texts(const Vector& v, int count) {
    std::string all;
    for (int i = 0; i < count; ++i)
        all += (i ? ", " : "") + text(v[i]);
    return "(" + all + ")";
}

/// Row by row, as it is written on a board.
std::string matrixText(const dmat4& m) {
    std::string rows;
    for (int row = 0; row < 4; ++row)
        rows += (row ? "; " : "") + texts(dvec4(m[0][row], m[1][row], m[2][row], m[3][row]), 4);
    return rows;
}

/// The first surface on the light's ray through a place of the map (0..1), as far as it is drawn into it: its depth there,
/// 0..1; none where the ray meets nothing.
std::optional<double> firstDepth(const scene::Scene& scene, std::span<const std::size_t> casters, const LightMaps& maps,
                                 int layer, const dvec2& uv) {
    const dmat4 lightClip = maps.lightClipFromLightRelative(layer);
    std::optional<double> nearest;
    for (const std::size_t caster : casters) {
        const scene::Object& object = scene.objects[caster];
        const dmat4 clipFromMesh = lightClip * lightRelativeFromMesh(maps, object);
        for (const uvec3& t : object.mesh->triangles) {
            dvec3 corners[3];
            bool before = true;
            for (int i = 0; i < 3; ++i) {
                const dvec4 clip = clipFromMesh * dvec4(dvec3(object.mesh->positionsMesh[t[i]]), 1.0);
                before = before && clip.w > 0;
                corners[i] = dvec3(clip) / clip.w * 0.5 + 0.5;
            }
            if (!before) continue; // reaches behind the light: too near to be what a map is for
            const auto side = [&](int i) {
                const dvec2 a = dvec2(corners[(i + 1) % 3]) - uv, b = dvec2(corners[(i + 2) % 3]) - uv;
                return a.x * b.y - a.y * b.x;
            };
            const dvec3 weights(side(0), side(1), side(2));
            const bool inside =
                glm::all(glm::greaterThanEqual(weights, dvec3(0))) || glm::all(glm::lessThanEqual(weights, dvec3(0)));
            const double area = weights.x + weights.y + weights.z;
            if (!inside || area == 0) continue;
            const double depth = glm::dot(weights, dvec3(corners[0].z, corners[1].z, corners[2].z)) / area;
            nearest = std::min(nearest.value_or(1e300), std::max(depth, 0.0)); // what is too near is clamped
        }
    }
    return nearest;
}

} // namespace

Probe ShadowMap::probe(const scene::Snapshot& snapshot, const View& view, ivec2 pixel, int light) {
    Probe probe = Technique::probe(snapshot, view, pixel, light);
    const auto hit = exactJudge(snapshot)->eyeHit(view.camera, dvec2(pixel) + 0.5, view.size);
    if (!hit || light < 0 || light >= static_cast<int>(snapshot->lights.size())) return probe;
    prepare(snapshot, Deadline::max());
    const LightMaps maps =
        fit(*snapshot, view, asked(*snapshot, light), receiversInView(*snapshot, view), FitRequest::Cover::needed);
    const dvec3 pointLightRelative = hit->positionWorld - maps.originWorld;
    const double eyeDepth = -transformPoint(scene::viewFromWorld(view.camera), hit->positionWorld).z;
    const std::optional<int> layer = layerOf(maps, pointLightRelative, eyeDepth);
    const auto add = [&](const char* label, std::string value, const char* unit = "") {
        probe.facts.push_back({label, std::move(value), unit});
    };
    if (!layer) {
        add("map", "none: nothing in view can be in this light's shadow");
        return probe;
    }
    add("map", std::to_string(*layer + 1) + " of " + std::to_string(maps.layers()));
    // The chain of matrices, from the world to (s, t, r).
    const auto index = static_cast<std::size_t>(*layer);
    add("point in the world", texts(hit->positionWorld, 3), "m");
    add("lightRelativeFromWorld: less the light's origin", texts(maps.originWorld, 3), "m");
    add("point, light-relative", texts(pointLightRelative, 3), "m");
    add("lightViewFromLightRelative", matrixText(maps.lightViewFromLightRelative[index]));
    add("point in the light's view",
        texts(transformPoint(maps.lightViewFromLightRelative[index], pointLightRelative), 3), "m");
    add("lightClipFromLightView", matrixText(maps.lightClipFromLightView[index]));
    const dvec4 clip = maps.lightClipFromLightRelative(*layer) * dvec4(pointLightRelative, 1.0);
    add("point in the light's clip space", texts(clip, 4));
    if (clip.w <= 0) {
        add("(s, t, r)", "none: behind the light's camera, where the projection would mirror it");
        return probe;
    }
    const dvec3 str = dvec3(clip) / clip.w * 0.5 + 0.5;
    add("(s, t, r) = clip / w / 2 + 1/2", texts(str, 3));
    if (glm::any(glm::lessThan(dvec2(str), dvec2(0))) || glm::any(glm::greaterThanEqual(dvec2(str), dvec2(1)))) {
        add("texel", "none: outside the map, so lit");
        return probe;
    }
    const dvec2 texel = glm::floor(dvec2(str) * static_cast<double>(params_.resolution));
    const dvec2 centreUv = (texel + 0.5) / static_cast<double>(params_.resolution);
    add("texel (column, row)",
        std::to_string(static_cast<int>(texel.x)) + ", " + std::to_string(static_cast<int>(texel.y)));
    const std::optional<double> stored =
        firstDepth(*snapshot, castersOf(*snapshot, maps, asked(*snapshot, light), *layer), maps, *layer, centreUv);
    add("d(u,v): depth at the texel's centre, before any bias", stored ? text(*stored) : "1 (nothing there)");
    add("z(u,v): depth of the point itself", text(str.z));
    const auto distanceAt = [&](const dvec2& uv, double depth) {
        const dvec4 p = maps.lightViewFromLightClip(*layer) * dvec4(dvec3(uv, depth) * 2.0 - 1.0, 1.0);
        return -p.z / p.w - (maps.parallel ? maps.nearest : 0.0);
    };
    if (stored) add("d(u,v) in metres", text(distanceAt(centreUv, *stored)), "m");
    add("z(u,v) in metres", text(distanceAt(dvec2(str), str.z)), "m");
    add("if d(u,v) < z(u,v) then pixel is shadowed",
        !stored           ? "no: nothing is in the way"
        : *stored < str.z ? "yes, by " + text(str.z - *stored) + " of the map's range: more than the bias, or acne"
                          : "no: d is not less, by " + text(*stored - str.z));
    return probe;
}

} // namespace shadowlab::shadow_map
