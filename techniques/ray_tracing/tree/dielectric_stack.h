// In which medium is a ray? Water in a glass, a bubble in the water, and solids that overlap a little, as they must.
//
// C. Schmidt and B. Budge, "Simple Nested Dielectrics in Ray Traced Images", Journal of Graphics Tools 2002: a ray carries
// the list of all solids it is inside of. Where several overlap, that of the highest priority is what is really there;
// a surface inside a solid of higher priority is not there at all, and the ray goes straight on. So water may reach into
// the wall of its glass, and no gap of air or double surface is left between them. Of equal priorities the one that was
// entered last counts, which makes a bubble or a ball in a ball right without any numbers.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace shadowlab::ray_tracing {

/// A solid that light passes through. `solid` is its number: two of one material are two.
struct Medium {
    std::uint32_t solid = 0;
    int priority = 0;
    double ior = 1.0;
};

/// What a ray that meets a transparent surface finds there.
struct Crossing {
    double iorHere = 1.0, iorBeyond = 1.0;
    bool isReal = true; ///< false: a medium of higher priority is on both sides, and there is nothing to see
};

class DielectricStack {
public:
    /// Of the medium that is really there; 1 in empty space.
    [[nodiscard]] double ior() const;
    /// Is the ray inside that solid?
    [[nodiscard]] bool holds(const Medium& medium) const;
    /// What it would mean to cross the surface of that solid, from outside or from inside.
    [[nodiscard]] Crossing crossing(const Medium& medium, bool entering) const;
    /// Goes through it. Leaving what was never entered (the surface is not closed, or the near plane cut it) changes
    /// nothing.
    void cross(const Medium& medium, bool entering);

private:
    using Place = std::vector<Medium>::const_iterator;
    [[nodiscard]] Place last(const Medium& medium) const; ///< where that solid was entered last; end: nowhere
    [[nodiscard]] Place top(Place leftOut) const;         ///< what is really there, but for one
    std::vector<Medium> inside_;                          ///< in the order they were entered
};

} // namespace shadowlab::ray_tracing
