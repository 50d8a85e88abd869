// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/occlusion.h"

#include <algorithm>
#include <iterator>

#include "techniques/foundation/trace/area/shaft.h"
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::radiosity {

namespace {

/// Does a line, which crosses the polygon's plane, pass through the polygon? Edges count as inside.
bool isPierced(const Polygon& polygon, const dvec3& from, const dvec3& to) {
    const dvec3 way = to - from;
    bool isLeft = false, isRight = false; // of some edge
    dvec3 a = polygon[polygon.count() - 1] - from;
    for (const dvec3& corner : polygon.corners()) {
        const dvec3 b = corner - from;
        const double side = glm::dot(way, glm::cross(a, b));
        isLeft |= side > 0;
        isRight |= side < 0;
        if (isLeft && isRight) return false;
        a = b;
    }
    return true;
}

/// The contact tolerance for two boxes: relative to the size of both together.
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
        // Both polygons lie on one side of its plane: no line between them crosses it.
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

bool Occlusion::blocksAll(const Blockers& blockers, const Polygon& a, const Polygon& b) const {
    // A light in a corner of a face lies in its plane, and on one side or the other by rounding.
    const double touching = touchingIn(boxOf(a), boxOf(b));
    return std::ranges::any_of(blockers, [&](std::uint32_t number) {
        const Face& face = faces_.all[number];
        const auto allOn = [&](const Polygon& p, double side) {
            return std::ranges::all_of(
                p.corners(), [&](const dvec3& corner) { return side * face.plane.height(corner) > touching; });
        };
        if (!((allOn(a, 1) && allOn(b, -1)) || (allOn(a, -1) && allOn(b, 1)))) return false;
        for (const dvec3& from : a.corners())
            for (const dvec3& to : b.corners())
                if (!isPierced(face.polygon, from, to)) return false;
        return true;
    });
}

Occlusion::Outline Occlusion::outlineOf(const Face& face) {
    constexpr double kRounded = 1 + 1e-9;
    Outline outline{face.plane, centroid(face.polygon), 0};
    for (const dvec3& corner : face.polygon.corners()) {
        const dvec3 off = corner - outline.centre;
        outline.squaredRadius = std::max(outline.squaredRadius, kRounded * glm::dot(off, off));
    }
    return outline;
}

Blockers::const_iterator Occlusion::firstBlocker(const Blockers& blockers, const dvec3& fromCentred,
                                                 const dvec3& toCentred) const {
    return std::ranges::find_if(blockers, [&](std::uint32_t number) {
        const Outline& outline = outlines_[number];
        const double from = outline.plane.height(fromCentred), to = outline.plane.height(toCentred);
        if (!((from > 0 && to < 0) || (from < 0 && to > 0))) return false;
        const double share = from / (from - to);
        if (share < trace::kContact || share > 1 - trace::kContact) return false; // contact at an end of the line
        const dvec3 off = fromCentred + share * (toCentred - fromCentred) - outline.centre;
        return glm::dot(off, off) <= outline.squaredRadius &&
               isPierced(faces_.all[number].polygon, fromCentred, toCentred);
    });
}

} // namespace shadowlab::radiosity
