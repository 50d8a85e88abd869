// Which sides of the faces take part in the exchange of light?
//
// Triangles are seen from both sides, so a face has two. But no eye sees the inside of a closed body unless it is in there, and
// nothing is bright in there unless a light is: of bodies known to be closed only the outside counts, as long as no light is
// within their box. Of the sides that are left, one before which nothing lies sends light to nothing in the scene and receives
// none from there: the back of a room's wall. Its radiosity follows from the lights alone, and it stays out of the equations.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

struct Sides {
    /// `all` holds sides, each a face of its own that is seen from its front: first those that exchange light, then those that do
    /// not. `ofTriangle`: the side that is the triangle's front, or kNoFace.
    Faces faces;
    std::size_t exchanging = 0;                ///< so many of them come first
    std::vector<std::uint32_t> backOfTriangle; ///< the side that is its back, or kNoFace
    std::vector<bool> isClosed;                ///< of each object: is its inside left out?
};

/// `plain`: from facesOf, front sides only. `lightWithin`: of each object, is there a light within its box?
Sides sidesOf(const scene::Scene& scene, const trace::WorldTriangles& world, const Faces& plain,
              const std::vector<bool>& lightWithin);

} // namespace shadowlab::radiosity
