// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/probe/map_probe.h"

#include <algorithm>
#include <cmath>

#include "techniques/probed/map_probe.h"
#include "techniques/shadow_map/filters/filters.h"

namespace shadowlab::shadow_map {

namespace {

constexpr double kHalfNear =
    5.5;                    ///< texels on each side of the point that are drawn large: each is a finger wide on a slide
constexpr int kAcross = 44; ///< texels of the whole map: more rays could not be told apart

struct Maps {
    const ComparedPoint& point;
    dmat4 lightRelativeFromClip = glm::inverse(point.maps.lightClipFromLightRelative(point.layer));
    double resolution = point.params.resolution;

    [[nodiscard]] ivec2 texelOf(const dvec2& uv) const { return ivec2(glm::floor(uv * resolution)); }
    [[nodiscard]] dvec2 centreOf(const ivec2& texel) const { return (dvec2(texel) + 0.5) / resolution; }
    [[nodiscard]] dvec3 lightRelative(const dvec2& uv, double depth) const {
        const dvec4 place = lightRelativeFromClip * dvec4(dvec3(uv, depth) * 2.0 - 1.0, 1.0);
        return dvec3(place) / place.w;
    }
    [[nodiscard]] dvec3 world(const dvec2& uv, double depth) const {
        return point.maps.originWorld + lightRelative(uv, depth);
    }
    [[nodiscard]] std::array<dvec3, 3> cornersLightRelative() const {
        std::array<dvec3, 3> corners = point.cornersWorld;
        for (dvec3& corner : corners)
            corner -= point.maps.originWorld;
        return corners;
    }
};

} // namespace

double metresOf(const LightMaps& maps, int layer, const dvec2& uv, double depth) {
    const dvec4 p = maps.lightViewFromLightClip(layer) * dvec4(dvec3(uv, depth) * 2.0 - 1.0, 1.0);
    return -p.z / p.w - (maps.parallel ? maps.nearest : 0.0);
}

std::optional<MapProbe> probeMap(const ComparedPoint& point) {
    const Maps maps{point};
    const DepthComparison comparison(point.maps, point.layer, point.params, point.filter, point.minReferenceDepth);
    const dvec3 pointLightRelative = point.pointWorld - point.maps.originWorld;
    const dvec4 clip = comparison.lightClipFromLightRelative() * dvec4(pointLightRelative, 1.0);
    if (clip.w <= 0) return std::nullopt;
    const ComparedPlace place = comparison.placeOf(pointLightRelative, maps.cornersLightRelative());
    MapProbe probe;
    probe.layer = point.layer;
    probe.layers = point.maps.layers();
    probe.lightClipFromLightRelative = comparison.lightClipFromLightRelative();
    probe.originWorld = point.maps.originWorld;
    probe.resolution = point.params.resolution;
    probe.str = dvec3(clip) / clip.w * 0.5 + 0.5;
    probe.texel = maps.texelOf(place.uv);
    const TexelDepth texel = point.depths.at(probe.texel);
    const dvec2 centre = maps.centreOf(probe.texel);
    probe.first = texel.first;
    probe.stored = texel.stored;
    probe.compared = comparison.referenceDepth(place, dvec2(0.0));
    const auto metres = [&](const dvec2& uv, double depth) { return metresOf(point.maps, point.layer, uv, depth); };
    probe.firstMetres = metres(centre, texel.first);
    probe.storedMetres = metres(centre, texel.stored);
    probe.comparedMetres = metres(place.uv, probe.compared);
    probe.pointMetres = metres(dvec2(probe.str), probe.str.z);
    probe.texelMetres = comparison.texelMetres(clip);
    if (!texel.isEmpty()) probe.blockerWorld = maps.world(centre, texel.clamped);
    // The texel on the point's plane: depth varies there as the place's slope says.
    probe.texelIsOnReceiver = true;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec2 corner = (dvec2(probe.texel) + dvec2(i == 1 || i == 2, i >= 2)) / maps.resolution;
        const double depth = probe.str.z + glm::dot(place.slope, corner - dvec2(probe.str));
        probe.texelOnReceiverWorld[i] = maps.world(corner, depth);
        // Where light or eye see the plane nearly edge-on a texel's image has no end.
        const double far = glm::length(probe.texelOnReceiverWorld[i] - point.pointWorld);
        probe.texelIsOnReceiver = probe.texelIsOnReceiver && std::isfinite(far) && far < 1000 * probe.texelMetres;
    }
    return probe;
}

void addCells(MapProbe& probe, const ComparedPoint& point, const LightSection& section) {
    const Maps maps{point};
    const DepthComparison comparison(point.maps, point.layer, point.params, point.filter, point.minReferenceDepth);
    const dvec3 pointLightRelative = point.pointWorld - point.maps.originWorld;
    const dvec3 towardLight = point.maps.parallel ? point.maps.towardLight : -glm::normalize(pointLightRelative);
    // Across the light's ray within the plane: the plane holds the light, so it is a line in the map.
    const dvec3 across = glm::cross(section.normalWorld(), towardLight);
    const auto uvOf = [&](const dvec3& place) {
        const dvec4 clip = comparison.lightClipFromLightRelative() * dvec4(place, 1.0);
        return dvec2(clip) / clip.w * 0.5 + 0.5;
    };
    const dvec2 uv0(probe.str);
    const dvec2 way = uvOf(pointLightRelative + probe.texelMetres * across) - uv0;
    if (!(glm::length(way) > 0)) return;
    const dvec2 along = glm::normalize(way) / maps.resolution; // one texel's width
    const ComparedPlace here = comparison.placeOf(pointLightRelative, maps.cornersLightRelative());

    const auto cell = [&](double from, double to) {
        MapProbe::Cell one;
        one.texel = maps.texelOf(uv0 + 0.5 * (from + to) * along);
        const TexelDepth depth = point.depths.at(one.texel);
        one.isEmpty = depth.isEmpty();
        for (std::size_t end = 0; end < 2; ++end) {
            const dvec2 uv = uv0 + (end ? to : from) * along;
            const double onPlane = probe.str.z + glm::dot(here.slope, uv - uv0);
            const ComparedPlace there =
                comparison.placeOf(maps.lightRelative(uv, onPlane), maps.cornersLightRelative());
            one.rays[end] = section.of(point.maps.parallel ? maps.world(uv, 0) : point.maps.originWorld);
            // What stands before the map's near plane is stored as if it stood in it; it is drawn where it stands.
            one.stored[end] = section.of(maps.world(uv, depth.clamped < 0 ? depth.clamped : depth.stored));
            one.compared[end] = section.of(maps.world(there.uv, comparison.referenceDepth(there, dvec2(0.0))));
        }
        return one;
    };
    // Where the line passes from texel to texel: at whole numbers of columns and rows.
    std::vector<double> borders{-kHalfNear, kHalfNear};
    for (int axis = 0; axis < 2; ++axis) {
        const double speed = along[axis] * maps.resolution, start = uv0[axis] * maps.resolution;
        if (std::abs(speed) < 1e-9) continue;
        const double low = start - std::abs(speed) * kHalfNear, high = start + std::abs(speed) * kHalfNear;
        for (double line = std::ceil(low); line <= high; ++line)
            borders.push_back((line - start) / speed);
    }
    std::ranges::sort(borders);
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
        if (borders[i + 1] - borders[i] > 1e-6) probe.near.push_back(cell(borders[i], borders[i + 1]));

    double from = -1e300, to = 1e300; // of the line, in the map
    for (int axis = 0; axis < 2; ++axis) {
        if (along[axis] == 0) continue;
        const double a = -uv0[axis] / along[axis], b = (1 - uv0[axis]) / along[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    for (int i = 0; i < kAcross && from < to; ++i) {
        const double middle = std::round(glm::mix(from, to, (i + 0.5) / kAcross));
        probe.across.push_back(cell(middle - 0.5, middle + 0.5));
    }
}

} // namespace shadowlab::shadow_map
