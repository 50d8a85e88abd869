// The medium that a ray is in, with nested and slightly overlapping solids: water in a glass, a bubble in the water.
//
// C. Schmidt and B. Budge, "Simple Nested Dielectrics in Ray Traced Images", Journal of Graphics Tools 2002: a ray carries the
// list of all solids it is inside of. Where several overlap, the one with the highest priority defines the medium; a surface
// inside a solid of higher priority is ignored, and the ray goes straight on. So water may extend into the wall of its glass,
// with no gap of air or double surface between them. Among equal priorities the solid entered last counts, which makes a bubble,
// or a ball in a ball, right without any priorities.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace shadowlab::ray_tracing {

/// A transparent solid. `solid` is its number: two objects of one material are two solids.
struct Medium {
    std::uint32_t solid = 0;
    int priority = 0;
    double ior = 1.0;
};

/// What a ray finds on the two sides of a transparent surface.
struct Crossing {
    double iorHere = 1.0, iorBeyond = 1.0;
    bool isReal = true; ///< false: a medium of higher priority is on both sides, and the surface is ignored
};

class DielectricStack {
public:
    /// The index of refraction of the medium that the ray is in; 1 in empty space.
    [[nodiscard]] double ior() const;
    /// Is the ray inside that solid?
    [[nodiscard]] bool holds(const Medium& medium) const;
    /// The indices on both sides of that solid's surface, crossed from outside or from inside.
    [[nodiscard]] Crossing crossing(const Medium& medium, bool entering) const;
    /// Crosses the surface. Leaving a solid that was never entered (its surface is not closed, or the near plane cut it) changes
    /// nothing.
    void cross(const Medium& medium, bool entering);

private:
    using Place = std::vector<Medium>::const_iterator;
    [[nodiscard]] Place last(const Medium& medium) const; ///< where that solid was entered last; end(): nowhere
    [[nodiscard]] Place top(Place leftOut) const;         ///< the solid with the highest priority, leaving one out
    std::vector<Medium> inside_;                          ///< in the order they were entered
};

} // namespace shadowlab::ray_tracing
