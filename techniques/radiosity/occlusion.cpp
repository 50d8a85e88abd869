// SPDX-License-Identifier: MIT
#include "techniques/radiosity/occlusion.h"

#include <algorithm>
#include <iterator>

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

/// What is nearer touches: by the size of all that lies between the two boxes.
double touchingIn(const trace::CentredBox& a, const trace::CentredBox& b) {
    return kTouching * glm::length(glm::max(a.upper, b.upper) - glm::min(a.lower, b.lower));
}

} // namespace

Blockers Occlusion::inShaft(const trace::Shaft& shaft, const Blockers* known) const {
    Blockers found;
    if (known) {
        std::ranges::copy_if(*known, std::back_inserter(found), [&](std::uint32_t number) {
            return std::ranges::any_of(faces_.all[number].triangles,
                                       [&](std::uint32_t t) { return shaft.mayTouch(bvh_.triangles[t]); });
        });
        return found;
    }
    for (const std::uint32_t t : shaft.triangles(bvh_, [&](std::uint32_t p) { return casts_[p] != 0; }))
        found.push_back(faces_.ofTriangle[t]);
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    return found;
}

Blockers Occlusion::betweenHull(const Polygon& a, const Polygon& hull, const Blockers* known) const {
    const trace::CentredBox boxA = boxOf(a), boxB = boxOf(hull);
    const Plane planeA = planeOf(a);
    const double touching = touchingIn(boxA, boxB);
    Blockers found = inShaft(trace::Shaft(boxA, boxB), known);
    std::erase_if(found, [&](std::uint32_t number) {
        const Face& face = faces_.all[number];
        if (isBehind(planeA, face.polygon, touching)) return true;
        const Plane &plane = face.plane, turned{plane.point, -plane.normal};
        // Both on one side: no line from one to the other goes through it.
        return (isBehind(plane, a, touching) && isBehind(plane, hull, touching)) ||
               (isBehind(turned, a, touching) && isBehind(turned, hull, touching));
    });
    return found;
}

Blockers Occlusion::between(const Polygon& a, const Polygon& b, const Blockers* known) const {
    const Plane planeB = planeOf(b);
    const double touching = touchingIn(boxOf(a), boxOf(b));
    Blockers found = betweenHull(a, b, known);
    std::erase_if(found, [&](std::uint32_t n) { return isBehind(planeB, faces_.all[n].polygon, touching); });
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
