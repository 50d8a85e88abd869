// What stands between two polygons?
//
// First the faces that may: those in the shaft between the polygons' boxes (Haines and Wallace, 1991) that are not behind either
// polygon's plane, and do not have both polygons on one side. None: the polygons see each other fully, and that is certain. One whose plane parts the two, and that all lines
// from corner to corner of the two pierce: they do not see each other at all, and that is certain, too, for every other line
// pierces that plane between these places, and the face is convex. Otherwise lines between points of both are samples.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

/// Faces by their numbers. Asked first for two whole faces, then, from what was found, for pieces of them.
using Blockers = std::vector<std::uint32_t>;

class Occlusion {
public:
    /// Both must live as long. `casts`: of each triangle of the scene, 1 or 0: does it block light?
    Occlusion(const Faces& faces, const trace::Bvh& bvh, std::vector<std::uint8_t> casts)
        : faces_(faces), bvh_(bvh), casts_(std::move(casts)) {
        for (const Face& face : faces.all)
            outlines_.push_back(outlineOf(face));
    }

    /// What may stand between the two, each without what lies behind the other. Of pieces of polygons whose blockers are known
    /// only these are looked at.
    [[nodiscard]] Blockers between(const Polygon& a, const Polygon& b, const Blockers* known = nullptr) const;
    /// The same where the other end has no front, as a light that shines in all directions: the convex hull of some points, of one
    /// point perhaps. They need not lie in a plane.
    [[nodiscard]] Blockers betweenHull(const Polygon& a, const Polygon& hull, const Blockers* known = nullptr) const;
    /// Does one of the faces hide all of the one from all of the other? Either may be a hull.
    [[nodiscard]] bool blocksAll(const Blockers& blockers, const Polygon& a, const Polygon& b) const;
    /// The first in the list that stands between the two points; its end: none does.
    [[nodiscard]] Blockers::const_iterator firstBlocker(const Blockers& blockers, const dvec3& fromCentred,
                                                        const dvec3& toCentred) const;
    [[nodiscard]] bool isBlocked(const Blockers& blockers, const dvec3& fromCentred, const dvec3& toCentred) const {
        return firstBlocker(blockers, fromCentred, toCentred) != blockers.end();
    }

private:
    [[nodiscard]] Blockers inShaft(const trace::Shaft& shaft, const Blockers* known) const;

    const Faces& faces_;
    const trace::Bvh& bvh_;
    std::vector<std::uint8_t> casts_;
    /// Of each face, side by side in memory, what tells of most lines that they miss it.
    struct Outline {
        Plane plane;
        dvec3 centre{0.0};
        double squaredRadius = 0; ///< of a sphere around it, m^2
    };
    static Outline outlineOf(const Face& face);
    std::vector<Outline> outlines_;
};

} // namespace shadowlab::radiosity
