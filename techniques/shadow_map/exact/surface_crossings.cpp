// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/surface_crossings.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/trace/bvh/ray_box.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::shadow_map {

namespace {

using Corners = std::array<dvec3, 3>;

Corners cornersOf(const trace::Triangle& t) { return {t.a, t.b, t.c}; }

// Distances from a plane below this share of the coordinates are rounding, and count as on it.
constexpr double kOnPlane = 1e-12;

/// Distances of a triangle's corners from the other's plane, in units of that plane's normal; too small ones are zero.
std::array<double, 3> distances(const Corners& corners, const dvec3& normal, const dvec3& onPlane) {
    std::array<double, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 offset = corners[i] - onPlane;
        const dvec3 size = glm::abs(corners[i]) + glm::abs(onPlane);
        d[i] = glm::dot(normal, offset);
        if (std::abs(d[i]) <= kOnPlane * glm::dot(glm::abs(normal), size)) d[i] = 0;
    }
    return d;
}

bool onOneSide(const std::array<double, 3>& d) {
    return (d[0] > 0 && d[1] > 0 && d[2] > 0) || (d[0] < 0 && d[1] < 0 && d[2] < 0);
}

/// The two points at which a triangle's outline meets the other's plane, by their place along the line of both planes.
struct Span {
    double from = 1e300, to = -1e300;
    dvec3 fromPoint{0.0}, toPoint{0.0};
    void include(double place, const dvec3& point) {
        if (place < from) from = place, fromPoint = point;
        if (place > to) to = place, toPoint = point;
    }
};

Span spanOf(const Corners& corners, const std::array<double, 3>& d, const dvec3& line) {
    Span span;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (d[i] == 0) span.include(glm::dot(line, corners[i]), corners[i]);
        if (d[i] * d[j] < 0) {
            const dvec3 point = corners[i] + (corners[j] - corners[i]) * (d[i] / (d[i] - d[j]));
            span.include(glm::dot(line, point), point);
        }
    }
    return span;
}

std::ptrdiff_t sharedCorners(const Corners& first, const Corners& second) {
    return std::ranges::count_if(first, [&](const dvec3& a) { return std::ranges::find(second, a) != second.end(); });
}

/// So short that it is the shared corner, found twice.
bool isPoint(const Crossing& crossing) {
    constexpr double kRounding = 1e-12;
    return glm::length(crossing.bCentred - crossing.aCentred) <=
           kRounding * (glm::length(crossing.aCentred) + glm::length(crossing.bCentred));
}

struct FloatBox {
    float lower[3], upper[3];
};

FloatBox boxOf(const Corners& corners) {
    FloatBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
        box.lower[axis] = trace::roundedDown(least);
        box.upper[axis] = trace::roundedUp(most);
    }
    return box;
}

bool overlaps(const FloatBox& box, const trace::BvhNode& node, int child) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(node.planes[axis][0][child] <= box.upper[axis] && node.planes[axis][1][child] >= box.lower[axis]))
            return false;
    return true;
}

/// Calls visit(primitive) for all triangles in leaves whose box overlaps.
template <typename Visit>
void forEachNear(const trace::Bvh& bvh, const FloatBox& box, const Visit& visit) {
    std::array<trace::BvhChild, trace::BvhWalk::kMostWaiting> stack;
    std::size_t size = 0;
    if (!bvh.nodes.empty()) stack[size++] = trace::BvhChild::node(0);
    while (size > 0) {
        const trace::BvhChild child = stack[--size];
        if (child.isLeaf()) {
            const trace::BvhLeaf& leaf = bvh.leaves[child.index()];
            for (int i = 0; i < leaf.count; ++i)
                visit(leaf.primitives[i]);
            continue;
        }
        const trace::BvhNode& node = bvh.nodes[child.index()];
        for (int i = 0; i < node.count; ++i)
            if (overlaps(box, node, i)) stack[size++] = trace::BvhChild(node.children[i]);
    }
}

} // namespace

std::optional<Crossing> crossingOf(const trace::Triangle& first, const trace::Triangle& second) {
    const Corners a = cornersOf(first), b = cornersOf(second);
    const dvec3 normalA = glm::cross(a[1] - a[0], a[2] - a[0]), normalB = glm::cross(b[1] - b[0], b[2] - b[0]);
    const std::array<double, 3> ofB = distances(b, normalA, a[0]);
    if (onOneSide(ofB)) return std::nullopt;
    const std::array<double, 3> ofA = distances(a, normalB, b[0]);
    if (onOneSide(ofA)) return std::nullopt;
    const dvec3 line = glm::cross(normalA, normalB);
    const bool inOnePlane = std::ranges::all_of(ofB, [](double d) { return d == 0; }) ||
                            std::ranges::all_of(ofA, [](double d) { return d == 0; });
    if (inOnePlane || !(glm::length(line) > 0)) return std::nullopt;
    const Span spanA = spanOf(a, ofA, line), spanB = spanOf(b, ofB, line);
    const Span& later = spanA.from > spanB.from ? spanA : spanB;
    const Span& sooner = spanA.to < spanB.to ? spanA : spanB;
    if (!(later.from <= sooner.to)) return std::nullopt;
    return Crossing{later.fromPoint, sooner.toPoint};
}

std::vector<Crossing> surfaceCrossings(const trace::Bvh& bvh, const trace::WorldTriangles& world,
                                       std::span<const std::uint8_t> objects) {
    constexpr std::size_t kAtOnce = 1024;
    const std::size_t count = world.triangles.size();
    std::vector<std::vector<Crossing>> found((count + kAtOnce - 1) / kAtOnce);
    trace::parallelFor(found.size(), [&](std::size_t run) {
        for (std::size_t t = run * kAtOnce; t < std::min(count, (run + 1) * kAtOnce); ++t) {
            if (!objects[world.objects[t]]) continue;
            const Corners corners = cornersOf(world.triangles[t]);
            forEachNear(bvh, boxOf(corners), [&](std::uint32_t other) {
                if (other <= t || !objects[world.objects[other]]) return;
                // Along an edge that they share they meet anyway; from a corner they may go on through each other.
                const std::ptrdiff_t shared = sharedCorners(corners, cornersOf(world.triangles[other]));
                if (shared > 1) return;
                const auto crossing = crossingOf(world.triangles[t], world.triangles[other]);
                if (crossing && !(shared == 1 && isPoint(*crossing))) found[run].push_back(*crossing);
            });
        }
    });
    std::vector<Crossing> all;
    for (const std::vector<Crossing>& some : found)
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

} // namespace shadowlab::shadow_map
