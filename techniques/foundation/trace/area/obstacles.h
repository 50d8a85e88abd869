// What may change what a group of points sees of a light: found for all of them together, then narrowed down for parts of the group.
//
// What stands in the group's shaft matters only by its contours (area_visibility.h). An edge is none for any point of a box that is on
// one side of each of its triangles where these sides cancel, so of a finely tessellated body there remains a band along its outline.
// The smaller the box, the narrower the band: a hierarchy of points in place of one of triangles.
// SPDX-License-Identifier: MIT
#pragma once
#include <initializer_list>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::trace {

/// Where a group of points is. All in centred space.
struct AreaVisibility::Bounds {
    /// The plane of a point's triangle: what lies below hides nothing from the point.
    struct Horizon {
        dvec3 up;     ///< unit
        double level; ///< products with `up` that are not larger are below
    };
    CentredBox box; ///< around the points, and all places they move to
    double largestMove = 0;
    std::vector<Horizon> horizons; ///< of all points; none where there are too many
    /// Below all of the horizons? False where there are none.
    [[nodiscard]] bool isBelow(std::initializer_list<dvec3> cornersCentred) const;
};

class AreaVisibility::Obstacles {
public:
    /// Of all triangles that cast.
    Obstacles(const AreaVisibility& owner, const Bounds& bounds);
    /// What is left for a part of the group.
    [[nodiscard]] Obstacles narrowed(const AreaVisibility& owner, const Bounds& bounds) const;

    [[nodiscard]] std::size_t count() const { return edges.size() + cuts.size() + near.size() + perforated.size(); }

    std::vector<std::uint32_t> edges;      ///< that may be contours for one of the points
    std::vector<std::uint32_t> cuts;       ///< likewise: chords of AreaVisibility::cuts_
    std::vector<std::uint32_t> near;       ///< triangles that may touch the light, or a point
    std::vector<std::uint32_t> perforated; ///< triangles with holes

private:
    class Filter;
    Obstacles() = default;
};

} // namespace shadowlab::trace
