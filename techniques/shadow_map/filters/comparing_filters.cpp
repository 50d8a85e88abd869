// The filters that compare depths, on the processor and in double, for the probe: what filter_hard.glsl to filter_pcss.glsl and
// sample_points.glsl compute.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/bias/biases.h"
#include "techniques/shadow_map/filters/filters.h"
#include "techniques/shadow_map/probe/map_probe.h"

namespace shadowlab::shadow_map {

namespace {

// As sample_points.glsl writes them: a shader's constants are floats.
constexpr double kGoldenAngle = 2.39996323, kTurn = 6.2831853;
constexpr dvec2 kPlastic{0.7548776662, 0.5698402910};

/// pcg3d: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
dvec2 hash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v += uvec3(v.y, v.z, v.x) * uvec3(v.z, v.x, v.y);
    v ^= v >> 16u;
    v += uvec3(v.y, v.z, v.x) * uvec3(v.z, v.x, v.y);
    return dvec2(v.x >> 8u, v.y >> 8u) / 16777216.0;
}

/// Two numbers in 0..1 that turn a pixel's samples. `fragment`: the pixel, rows counted from below.
dvec2 sampleNoise(FilterParams::Noise noise, const ivec2& fragment, const ivec2& texel, int layer) {
    if (noise == FilterParams::Noise::none) return dvec2(0.0);
    const ivec2 seed = noise == FilterParams::Noise::pixel ? fragment : texel;
    return hash(uvec3(glm::uvec2(seed), static_cast<unsigned>(layer)));
}

/// Of `count` points in the unit circle, the seeds of a sunflower (Vogel 1979).
dvec2 pointInDisc(int i, int count, const dvec2& chance) {
    const double angle = i * kGoldenAngle + kTurn * chance.x;
    return std::sqrt((i + 0.5) / count) * dvec2(std::cos(angle), std::sin(angle));
}

/// Of any number of points in the square from -1 to 1 (Roberts 2018).
dvec2 pointInSquare(int i, const dvec2& chance) { return 2.0 * glm::fract(chance + (i + 1.0) * kPlastic) - 1.0; }

std::array<dvec3, 3> cornersLightRelative(const ComparedPoint& point) {
    std::array<dvec3, 3> corners = point.cornersWorld;
    for (dvec3& corner : corners)
        corner -= point.maps.originWorld;
    return corners;
}

double litShare(const std::vector<MapProbe::Tap>& taps) {
    double share = 0;
    for (const MapProbe::Tap& tap : taps)
        share += tap.isLit ? tap.weight : 0;
    // Shares such as 1/9 do not add up to one in binary: a millionth is rounding.
    return share > 1 - 1e-6 ? 1 : share;
}

/// The light's half axes in the map's clip space, as filter_pcss.glsl has them.
struct LightShape {
    dvec3 axis{0.0}; ///< that distances count along
    dvec4 clipU{0.0}, clipV{0.0};
    bool isDisc = false;
    double width = 0;         ///< metres
    double mostMagnified = 0; ///< so that a kernel is no wider than it may be
};

LightShape lightShape(const ComparedPoint& point, const ProbedLayer& map) {
    const bool isRect = point.light.type == scene::LightType::rect;
    const double radius = isRect ? 0.0 : lightReach(point.light, point.filter);
    const dvec3 fromLight = point.pointWorld - point.maps.originWorld;
    const dvec3 toward = point.maps.parallel ? point.maps.towardLight : -glm::normalize(fromLight);
    LightShape shape;
    shape.isDisc = radius > 0;
    shape.axis = isRect ? scene::rectNormalWorld(point.light) : -toward;
    dvec3 halfU = isRect ? 0.5 * point.light.edgeUWorld : dvec3(0.0),
          halfV = isRect ? 0.5 * point.light.edgeVWorld : dvec3(0.0);
    if (shape.isDisc) { // it faces the point
        halfU = radius * glm::normalize(glm::cross(toward, std::abs(toward.x) < 0.8 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
        halfV = glm::cross(toward, halfU);
    }
    shape.width = 2 * (shape.isDisc ? radius : std::max(glm::length(halfU), glm::length(halfV)));
    const dvec4 clip = map.place().clip;
    shape.clipU = map.clipFromLightRelative() * dvec4(halfU, 0.0);
    shape.clipV = map.clipFromLightRelative() * dvec4(halfV, 0.0);
    const dvec2 alongU = dvec2(shape.clipU) - dvec2(clip) / clip.w * shape.clipU.w;
    const dvec2 alongV = dvec2(shape.clipV) - dvec2(clip) / clip.w * shape.clipV.w;
    const dvec2 reach =
        shape.isDisc ? glm::sqrt(alongU * alongU + alongV * alongV) : glm::abs(alongU) + glm::abs(alongV);
    shape.mostMagnified = point.filter.widest * 2.0 * std::abs(clip.w) / std::max(std::max(reach.x, reach.y), 1e-30);
    return shape;
}

/// w / w_L: how large the light is on the receiver, seen through a hole at the blocker.
double magnification(bool isParallel, double receiver, double blocker) {
    const double between = std::max(receiver - blocker, 0.0);
    return isParallel ? between : between / std::max(blocker, 1e-3 * receiver);
}

dvec2 offsetThrough(const LightShape& shape, const ProbedLayer& map, const dvec2& onLight, double magnified) {
    const dvec4 clip = map.place().clip + magnified * (onLight.x * shape.clipU + onLight.y * shape.clipV);
    return dvec2(clip) / clip.w * 0.5 + 0.5 - map.place().uv;
}

double farthestTexels(const std::vector<MapProbe::Tap>& taps, const ProbedLayer& map) {
    double farthest = 0;
    for (const MapProbe::Tap& tap : taps)
        farthest = std::max(farthest, glm::length(tap.placeTexels - map.place().uv * map.resolution()));
    return farthest;
}

MapProbe::Tap weighted(MapProbe::Tap tap, double weight) {
    tap.weight = weight;
    return tap;
}

} // namespace

ProbedLayer::ProbedLayer(const ComparedPoint& point)
    : point_(point), comparison_(point.maps, point.layer, point.params, point.filter, point.minReferenceDepth),
      lightRelativeFromClip_(glm::inverse(comparison_.lightClipFromLightRelative())),
      place_(comparison_.placeOf(point.pointWorld - point.maps.originWorld, cornersLightRelative(point))) {}

MapProbe::Tap ProbedLayer::tap(const dvec2& offsetUv, double compared) const {
    const dvec2 uv = place_.uv + offsetUv;
    MapProbe::Tap tap;
    tap.texel = texelOf(uv);
    tap.placeTexels = uv * resolution();
    tap.stored = point_.depths.at(tap.texel).stored;
    tap.compared = compared;
    tap.isLit = compared <= tap.stored;
    const dvec4 onPlane =
        lightRelativeFromClip_ * dvec4(dvec3(uv, place_.depth + glm::dot(place_.slope, offsetUv)) * 2.0 - 1.0, 1.0);
    tap.onPlaneWorld = point_.maps.originWorld + dvec3(onPlane) / onPlane.w;
    return tap;
}

namespace {

FilterAnswer answerOfTaps(std::vector<MapProbe::Tap> taps) {
    const double share = litShare(taps);
    return {.taps = std::move(taps), .visibility = share};
}

} // namespace

FilterAnswer hardAnswer(const ComparedPoint& point) {
    return answerOfTaps({weighted(ProbedLayer(point).tap(dvec2(0.0)), 1)});
}

FilterAnswer fourTexelsAnswer(const ComparedPoint& point) {
    const ProbedLayer map(point);
    const double step = 1.0 / map.resolution();
    const dvec2 lowerLeft = glm::floor(map.place().uv * map.resolution() - 0.5);
    const dvec2 share = map.place().uv * map.resolution() - 0.5 - lowerLeft;
    const dvec2 toCentre = (lowerLeft + 0.5) * step - map.place().uv;
    const std::array corners{dvec2(0, 0), dvec2(1, 0), dvec2(0, 1), dvec2(1, 1)};
    double compared = 1;
    for (const dvec2& corner : corners)
        compared = std::min(compared, map.depthAt(toCentre + step * corner));
    std::vector<MapProbe::Tap> taps;
    for (const dvec2& corner : corners) {
        const dvec2 weight = glm::mix(1.0 - share, share, corner);
        taps.push_back(weighted(map.tap(toCentre + step * corner, compared), weight.x * weight.y));
    }
    return answerOfTaps(std::move(taps));
}

FilterAnswer squareAnswer(const ComparedPoint& point) {
    const ProbedLayer map(point);
    const double step = 1.0 / map.resolution();
    const bool oneDepth = biasInfo(point.params.bias.mode).comparesWithOneDepth;
    const int radius = point.filter.pcfRadius;
    const double weight = 1.0 / ((2 * radius + 1) * (2 * radius + 1));
    std::vector<MapProbe::Tap> taps;
    for (int row = -radius; row <= radius; ++row)
        for (int column = -radius; column <= radius; ++column) {
            const dvec2 offset = dvec2(column, row) * step;
            taps.push_back(weighted(map.tap(offset, map.depthAt(oneDepth ? dvec2(0.0) : offset)), weight));
        }
    return answerOfTaps(std::move(taps));
}

FilterAnswer discAnswer(const ComparedPoint& point) {
    const ProbedLayer map(point);
    const double step = 1.0 / map.resolution();
    const ivec2 texel = map.texelOf(map.place().uv);
    const dvec2 chance = sampleNoise(point.filter.noise, point.fragment, texel, point.layer);
    std::vector<MapProbe::Tap> taps;
    for (int i = 0; i < point.filter.samples; ++i)
        taps.push_back(weighted(map.tap(point.filter.discRadius * step * pointInDisc(i, point.filter.samples, chance)),
                                1.0 / point.filter.samples));
    return answerOfTaps(std::move(taps));
}

FilterAnswer softShadowAnswer(const ComparedPoint& point) {
    const ProbedLayer map(point);
    const LightShape shape = lightShape(point, map);
    const dvec2 chance = sampleNoise(point.filter.noise, point.fragment, map.texelOf(map.place().uv), point.layer);
    const auto comparisons = [&](int count, double magnified) {
        std::vector<MapProbe::Tap> taps;
        for (int i = 0; i < count; ++i) {
            const dvec2 onLight = shape.isDisc ? pointInDisc(i, count, chance) : pointInSquare(i, chance);
            taps.push_back(map.tap(offsetThrough(shape, map, onLight, magnified)));
            taps.back().weight = 1.0 / count;
        }
        return taps;
    };
    const dvec3 fromLight = point.pointWorld - point.maps.originWorld;
    FilterAnswer answer;
    MapProbe::BlockerSearch search;
    search.lightMetres = shape.width;
    search.receiverMetres = glm::dot(shape.axis, fromLight);
    const bool parallel = point.maps.parallel;
    // Along the point's own ray all distances shrink alike, whichever axis they count along.
    const double most =
        magnification(parallel, parallel ? search.receiverMetres : glm::length(fromLight), point.maps.nearest);
    search.looks = comparisons(point.filter.blockerSamples, std::min(most, shape.mostMagnified));
    search.searchTexels = farthestTexels(search.looks, map);
    double sum = 0;
    for (const MapProbe::Tap& look : search.looks) {
        if (look.isLit) continue;
        const dvec4 place = map.lightRelativeFromClip() *
                            dvec4(dvec3(look.placeTexels / map.resolution(), look.stored) * 2.0 - 1.0, 1.0);
        sum += glm::dot(shape.axis, dvec3(place) / place.w);
        ++search.found;
    }
    if (search.found > 0) {
        search.blockerMetres = sum / search.found;
        const double magnified =
            std::min(magnification(parallel, search.receiverMetres, search.blockerMetres), shape.mostMagnified);
        search.penumbraMetres = shape.width * magnified;
        answer.taps = comparisons(point.filter.samples, magnified);
        answer.visibility = litShare(answer.taps);
        search.kernelTexels = farthestTexels(answer.taps, map);
    }
    answer.search = std::move(search);
    return answer;
}

} // namespace shadowlab::shadow_map
