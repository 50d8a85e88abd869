// Which faces block light between two polygons?
//
// Candidates are the faces in the shaft between the polygons' boxes (E. Haines and J. Wallace, 1991) that are not behind either
// polygon's plane and do not have both polygons on one side. If there is none, the polygons certainly see each other fully. If
// the plane of one candidate separates the polygons, and all lines from corner to corner of the two pierce it, they certainly do
// not see each other: every other line crosses that plane between these points, and the face is convex. Otherwise lines between
// sample points decide.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

/// Numbers of faces. Found first for two whole faces, then, among these, for pieces of them.
using Blockers = std::vector<std::uint32_t>;

class Occlusion {
public:
    /// Both must outlive this object. `casts`: for each triangle of the scene, 1 where it blocks light, else 0.
    Occlusion(const Faces& faces, const trace::Bvh& bvh, std::vector<std::uint8_t> casts)
        : faces_(faces), bvh_(bvh), casts_(std::move(casts)) {
        for (const Face& face : faces.all)
            outlines_.push_back(outlineOf(face));
    }

    /// Faces that may block light between the two polygons. `known`: the blockers of larger polygons that contain these; only
    /// they are tested.
    [[nodiscard]] Blockers between(const Polygon& a, const Polygon& b, const Blockers* known = nullptr) const;
    /// The same where the other end has no front, as a light that shines in all directions: the convex hull of some points,
    /// perhaps of one. They need not lie in a plane.
    [[nodiscard]] Blockers betweenHull(const Polygon& a, const Polygon& hull, const Blockers* known = nullptr) const;
    /// Does one of the faces block every line between the two? Either may be a hull.
    [[nodiscard]] bool blocksAll(const Blockers& blockers, const Polygon& a, const Polygon& b) const;
    /// The first face in the list that blocks the line between the two points; end() if none does.
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
    /// A bounding sphere and the plane of each face, stored contiguously: they reject most lines.
    struct Outline {
        Plane plane;
        dvec3 centre{0.0};
        double squaredRadius = 0; ///< of a sphere around it, m^2
    };
    static Outline outlineOf(const Face& face);
    std::vector<Outline> outlines_;
};

} // namespace shadowlab::radiosity
