// Cuts a convex polygon along contours (parts of lines), until no contour lies within a piece.
//
// A tree of cuts, as in Fuchs, Kedem and Naylor, "On Visible Surface Generation by A Priori Tree Structures", SIGGRAPH
// 1980, in the plane. A cut goes on beyond its contour, to the border of the piece, so it may split others; chosen is the contour that
// splits fewest. While many lie in one piece it is halved first: to compare all with all would cost more.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::trace {

/// Linear functions x * place.x + y * place.y + z: the part of the line where the first is zero and none of the others is
/// negative.
struct Contour {
    dvec3 line{0.0}, from{0.0, 0.0, 1.0}, to{0.0, 0.0, 1.0};
};

class UniformPieces {
public:
    using Visit = std::function<void(std::span<const dvec2>)>;
    /// Calls visit(piece) for convex pieces that make up the outline; all are counter-clockwise, as it must be. Pieces that
    /// are only rounding errors wide may be left out.
    /// `borders`: lines around a convex part, where their functions are not negative. What is beyond them is left out as far as no
    /// contour lies there: along a border it must be nothing that is to be visited.
    void cut(std::span<const dvec2> outline, std::span<const dvec3> borders, std::span<const Contour> contours, const Visit& visit);

private:
    struct Range {
        std::size_t first, count;
    };
    /// What of a contour lies within a piece.
    struct Part {
        std::uint32_t contour;
        dvec2 begin, end;
    };
    void settle(Range piece, Range within, int halvings);
    void addPart(std::uint32_t contour, Range piece);
    [[nodiscard]] dvec3 halving(Range piece) const;
    [[nodiscard]] std::size_t bestCut(Range within) const;
    [[nodiscard]] std::size_t splitBy(const dvec3& line, Range within, std::size_t atMost) const;
    Range keptSide(Range piece, const dvec3& line, double sign);
    Range stillWithin(Range among, std::size_t except, const dvec3& line, double sign);

    std::span<const Contour> contours_;
    const Visit* visit_ = nullptr;
    std::vector<dvec2> corners_; ///< of the pieces that wait, a stack
    std::vector<Part> parts_;    ///< that lie within them, likewise
};

/// Positive for a counter-clockwise polygon.
double areaOf(std::span<const dvec2> polygon);

/// The centroid of the polygon.
dvec2 centroidOf(std::span<const dvec2> polygon);

/// Cuts off the part of a convex polygon where the function is negative.
void keepPart(std::vector<dvec2>& polygon, const dvec3& function);

} // namespace shadowlab::trace
