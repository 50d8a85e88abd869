// Which sides of coinciding faces a rasteriser draws, and in how many layers, so that each pixel shows what coincident_faces.h says.
//
// A side that others hide everywhere is left out: no depths are compared, so nothing can go wrong. That is all there is to a face
// written twice, and to a box on a floor. Where a side is hidden in part, a decal on a floor, both are drawn, and the one that is seen
// a layer nearer to the eye.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/query/coincident/coincident_faces.h"

namespace shadowlab::scene {

struct SeenSide {
    bool isHidden = false; ///< to be left out
    std::int8_t layer = 0; ///< how often nearer to the eye; negative: farther
    bool isTwin = false;   ///< nearer by a rounding of depth alone: another triangle has the same three corners
    bool isWithin = false; ///< seen from within a closed skin alone: to be left out where the eye is outside of the object's box
    friend bool operator==(const SeenSide&, const SeenSide&) = default;
};

/// Both sides of a triangle.
struct SeenSides {
    std::uint32_t triangle = 0; ///< through all objects
    SeenSide front, back;
    double gap = 0; ///< metres by which rounding of float has moved its plane from those of the others, at most
    [[nodiscard]] bool isOrdinary() const { return front == SeenSide{} && back == SeenSide{}; }
};

/// Of the triangles that are not drawn as all others are, in order.
std::vector<SeenSides> seenSides(const Scene& scene, const CoincidentFaces& faces);

} // namespace shadowlab::scene
