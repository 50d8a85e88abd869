// SPDX-License-Identifier: MIT
#include <array>

#include "app/student/grading/families.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kExact =
    "a projection is exact but for the rounding of edges, which leaves a pixel here and there";

constexpr std::array kPlanarCases = std::to_array<Case>({
    {"flat-lamp", "the projection matrix, for a lamp", "1 2", 8, kExact, 3,
     "Compare the matrix with v' = (p.l) v - (p.v) l, term by term: which of the two is the row? If it is "
     "right on the ground, and all things before it are dark, the receiver's border is missing; if only sides of "
     "the box are dark, what lies below their planes is not clipped."},
    {"flat-sun", "the same matrix for a direction: l.w = 0", "1 2", 8, kExact, 2,
     "Nothing may divide by l.w: the light is a homogeneous point, and so is its shadow."},
    {"flat-above-lamp", "no anti-shadows of what is above the lamp", "1", 8, kExact, 2,
     "The weight of its shadow, p.l - l.w (p.v), is negative: leave the point homogeneous, or clip there."},
    {"flat-light-height", "a caster that reaches past the lamp's height", "1", 12, kExact, 2,
     "Leave the point homogeneous: at the lamp's height its weight is 0, and a division by it ends the shadow."},
    {"flat-sunk", "what is below the plane casts nothing on it", "4", 12, kExact, 2, "Clip where p.v is negative."},
    {"flat-table-edge", "a shadow ends where its receiver does", "3", 8, kExact, 2,
     "Draw the flattened caster only where the stencil has the receiver's tag."},
    {"flat-corner", "several receivers, each with a matrix of its own", "2 3", 12, kExact, 2,
     "Does each receiver have its own plane, and its own tag? The one before must not leave any."},
    {"flat-screen", "sheets cast, whichever side the light is on", "1 2", 8, kExact, 2,
     "A plane is turned to the side that the light is on, before the matrix is made."},
    {"flat-far", "ground and shadow at one depth, far away", "1 2", 8, kExact, 3,
     "Which of the two is nearer is a matter of rounding: draw the flattened caster without a depth test."},
});

} // namespace

std::span<const Case> planarCases() { return kPlanarCases; }

} // namespace shadowlab::student
