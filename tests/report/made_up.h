// Reports that nobody measured, for what is written from them.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "app/report/results.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::report {

/// A picture in one colour.
inline std::vector<std::uint8_t> plainPng(std::uint8_t level, ivec2 size = {32, 18}) {
    image::Image picture(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            picture.set(x, y, {level, static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)});
    return image::encodePng(picture);
}

inline Spread spreadAround(double median) { return {median, 0.95 * median, 1.08 * median, 1.3 * median}; }

/// `edgeErrorPx` 0: no wrong pixel.
inline Point madePoint(const std::string& technique, std::vector<std::string> settings, double frameMs,
                       double edgeErrorPx) {
    Point point;
    point.key = {technique, std::move(settings), "", "", 0};
    point.errors.edgeErrorPx = edgeErrorPx;
    point.errors.falseLit = static_cast<int>(std::lround(900 * edgeErrorPx));
    point.errors.rmse = 0.1 * edgeErrorPx;
    point.errors.pixels = 57600;
    Costs costs;
    costs.frames = 30;
    costs.frame = spreadAround(frameMs);
    costs.prepare = spreadAround(0.3 * frameMs);
    costs.draw = spreadAround(0.6 * frameMs);
    costs.shadow = spreadAround(0.8 * frameMs);
    costs.passes = {{"shadow-map", 0.3 * frameMs}, {"lit", 0.4 * frameMs}};
    point.costs = costs;
    point.command = "shadowlab measure still-life -t " + technique;
    point.picturePng = plainPng(200);
    point.errorPng = plainPng(static_cast<std::uint8_t>(10 * edgeErrorPx));
    return point;
}

/// A sweep of a shadow map: four times the texels, half the error.
inline void addSweep(Group& group, const std::string& title, const std::string& filter, double leastMs,
                     double mostError) {
    for (int i = 0; i < 5; ++i) {
        const std::string resolution = std::to_string(256 << i);
        Point point = madePoint("shadow-map", {"filter=" + filter, "resolution=" + resolution},
                                leastMs * std::pow(1.5, i), mostError * std::pow(0.5, i));
        point.key.sweep = title;
        point.key.varies = "resolution";
        point.key.value = 256 << i;
        group.points.push_back(point);
    }
}

/// Thirty points: three sweeps of maps, exact techniques, and one that serves a part of the pixels only.
inline Group madeGroup(const std::string& scene) {
    Group group{scene, "key", judge::TruthOf::centre, {}, {}, {}};
    group.points.push_back(madePoint("unshadowed", {}, 0.9, 38));
    group.points.back().isYardstick = true;
    addSweep(group, "Hard map", "hard", 1.6, 3.1);
    addSweep(group, "Percentage-closer filter", "pcf", 2.3, 2.4);
    addSweep(group, "Variance map", "variance", 2.1, 5.7);
    group.points.push_back(madePoint("planar", {}, 1.4, 0));
    group.points.back().errors.served = 0.6;
    double ms = 2.9;
    for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"})
        for (const char* cull : {"true", "false"})
            group.points.push_back(madePoint(technique, {std::string("cull=") + cull}, ms *= 1.13, 0));
    for (const char* structure : {"groups", "bvh", "grid", "none"})
        group.points.push_back(madePoint("ray-traced", {std::string("structure=") + structure}, ms *= 1.6, 0));
    for (const char* patches : {"500", "2000", "8000"})
        group.points.push_back(
            madePoint("radiosity", {std::string("patches=") + patches}, ms *= 2, 4000 / std::stod(patches)));
    group.points[17].errors.edgeErrorPx = 0.02; // z-pass with the eye in a shadow
    group.points[17].errors.falseLit = 18;
    for (Point& point : group.points) {
        point.onFront = !point.isYardstick && point.errors.served == 1;
        for (const Point& other : group.points)
            if (!other.isYardstick && other.errors.served == 1 &&
                other.costs->frame.median < point.costs->frame.median &&
                *other.errors.edgeErrorPx <= *point.errors.edgeErrorPx)
                point.onFront = false;
    }
    group.growth = {{"shadow-map", "Hard map", "resolution", 256, 4096, 0.58, -1.0},
                    {"shadow-map", "Variance map", "resolution", 256, 4096, 0.58, {}}};
    group.exactness = {19, 1, 2.3, 3.1, "shadow-volume-zfail: 4.2 ms, of which sides 61 %; shadow-map: 1.6 ms"};
    return group;
}

inline Report madeReport() {
    Report report;
    report.size = {320, 180};
    report.rounds = 30;
    report.machines = {{"Some Processor", "llvmpipe", "4.5", "egl", "g++", "shadowlab 0.1.0", 2, 4, 2, 8}};
    report.groups = {madeGroup("still-life"), madeGroup("billiards")};
    return report;
}

} // namespace shadowlab::report
