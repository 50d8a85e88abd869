// A convex piece of a light as one point sees it: its area, its irradiance, and a place in it.
//
// Of a disc it is what a polygon and the disc have in common, bounded by parts of the polygon's sides and by arcs of the circle:
// nothing is rounded off to sides.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/area/seen_light.h"

namespace shadowlab::trace {

class LightPiece {
public:
    /// `polygon`: convex and counter-clockwise, of places on the light. Both must live as long.
    LightPiece(const SeenLight& seen, std::span<const dvec2> polygon);

    [[nodiscard]] double area() const {
        return area_;
    } ///< in the units of SeenLight::area; 0: they have nothing in common
    /// A place within it.
    [[nodiscard]] dvec2 middle() const;
    /// Its product with a normal, above whose horizon all of the piece lies, is the integral of the cosine over the solid angle.
    [[nodiscard]] dvec3 vectorIrradiance() const;

private:
    /// A part of a side, and the arc from its end to where the next part begins.
    struct Part {
        dvec2 begin, end;
        double arc = 0; ///< radians, counter-clockwise
    };
    void cutWithDisc();
    [[nodiscard]] dvec3 alongSide(dvec2 begin, dvec2 end) const;
    [[nodiscard]] dvec3 alongArc(dvec2 begin, dvec2 end, double angle) const;

    const SeenLight& seen_;
    std::span<const dvec2> polygon_;
    std::vector<Part> parts_; ///< of a disc
    bool isWholeDisc_ = false;
    double area_ = 0;
};

} // namespace shadowlab::trace
