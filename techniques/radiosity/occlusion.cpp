// SPDX-License-Identifier: MIT
#include "techniques/radiosity/occlusion.h"

#include <algorithm>

#include "techniques/foundation/trace/shaft.h"

namespace shadowlab::radiosity {

namespace {

/// Where a line that goes through the polygon's plane meets it: inside? The edges count as inside.
bool isPierced(const Polygon& polygon, const dvec3& from, const dvec3& to) {
    const dvec3 way = to - from;
    int left = 0, right = 0;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 a = polygon[i] - from, b = polygon[(i + 1) % polygon.count()] - from;
        const double side = glm::dot(way, glm::cross(a, b));
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

} // namespace

Blockers Occlusion::between(const Polygon& a, const Polygon& b, const Blockers* known) const {
    const trace::CentredBox boxA = boxOf(a), boxB = boxOf(b);
    const Plane planeA = planeOf(a), planeB = planeOf(b);
    trace::CentredBox both = boxA;
    both.include(boxB.lower);
    both.include(boxB.upper);
    const double touching = kTouching * glm::length(both.upper - both.lower);
    const trace::Shaft shaft(boxA, boxB);
    Blockers found;
    const auto consider = [&](std::uint32_t number) {
        const Face& face = faces_.all[number];
        if (isBehind(planeA, face.polygon, touching) || isBehind(planeB, face.polygon, touching)) return;
        const Plane &plane = face.plane, turned{plane.point, -plane.normal};
        const bool onOneSide = (isBehind(plane, a, touching) && isBehind(plane, b, touching)) ||
                               (isBehind(turned, a, touching) && isBehind(turned, b, touching));
        if (!onOneSide) found.push_back(number); // else no line from one to the other goes through it
    };
    if (known) {
        for (const std::uint32_t number : *known) {
            const Face& face = faces_.all[number];
            if (shaft.mayTouch(bvh_.triangles[face.triangles[0]]) || shaft.mayTouch(bvh_.triangles[face.triangles[1]]))
                consider(number);
        }
        return found;
    }
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t t : shaft.triangles(bvh_, [&](std::uint32_t p) { return casts_[p] != 0; }))
        numbers.push_back(faces_.ofTriangle[t]);
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
    std::ranges::for_each(numbers, consider);
    return found;
}

bool Occlusion::hideAll(const Blockers& blockers, const Polygon& a, const Polygon& b) const {
    return std::ranges::any_of(blockers, [&](std::uint32_t number) {
        const Face& face = faces_.all[number];
        const auto allOn = [&](const Polygon& p, double side) {
            return std::ranges::all_of(p.corners(),
                                       [&](const dvec3& corner) { return side * face.plane.height(corner) > 0; });
        };
        if (!((allOn(a, 1) && allOn(b, -1)) || (allOn(a, -1) && allOn(b, 1)))) return false;
        for (const dvec3& from : a.corners())
            for (const dvec3& to : b.corners())
                if (!isPierced(face.polygon, from, to)) return false;
        return true;
    });
}

bool Occlusion::hide(const Blockers& blockers, const dvec3& fromCentred, const dvec3& toCentred) const {
    return std::ranges::any_of(blockers, [&](std::uint32_t number) {
        const Face& face = faces_.all[number];
        const double from = face.plane.height(fromCentred), to = face.plane.height(toCentred);
        return ((from > 0 && to < 0) || (from < 0 && to > 0)) && isPierced(face.polygon, fromCentred, toCentred);
    });
}

} // namespace shadowlab::radiosity
