// The sides of faces that take part in the exchange of light.
//
// Triangles are seen from both sides, so a face has two. The inside of a closed body is dark unless there is a light in it, and
// no eye sees it from outside: for bodies known to be closed only the outside counts, as long as no light lies within their
// bounding box. Of the sides that are left, one that has nothing before it sends no light to the scene and receives none from it:
// the back of a room's wall. Its radiosity follows from the lights alone, and it is left out of the equations (loose).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

struct Sides {
    /// `all` holds sides, each a face of its own seen from its front: first those that exchange light, then the loose ones.
    /// `ofTriangle`: the side that is the triangle's front, or kNoFace.
    Faces faces;
    std::size_t exchanging = 0;                ///< how many exchange light
    std::vector<std::uint32_t> backOfTriangle; ///< for each triangle the side that is its back, or kNoFace
    std::vector<bool> isClosed;                ///< for each object: is its inside left out?
};

/// `plain`: from facesOf(), fronts only. `lightWithin`: for each object, is there a light within its bounding box?
Sides sidesOf(const scene::Scene& scene, const trace::WorldTriangles& world, const Faces& plain,
              const std::vector<bool>& lightWithin);

} // namespace shadowlab::radiosity
