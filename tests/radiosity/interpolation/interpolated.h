// Radiosity between the centres of patches, as the picture shows it.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

#include "techniques/radiosity/interpolation/patch_corners.h"

namespace shadowlab::testing {

/// Linear over each triangle of a patch's fan: its centre, and two points of its border, one after the other. `isAnchored`:
/// with the T-vertices; without, the polygon's own corners only, which is to be seen to be wrong.
inline dvec3 interpolated(const radiosity::PatchCorners& corners, const std::vector<dvec3>& atCorners,
                          const std::vector<radiosity::Patch>& patches, const std::vector<dvec3>& ofPatches,
                          std::size_t number, const dvec3& positionCentred, bool isAnchored = true) {
    const radiosity::Patch& patch = patches[number];
    const radiosity::PatchBorders& borders = corners.borders;
    std::vector<std::uint32_t> pieces;
    for (std::uint32_t piece = borders.first[number]; piece < borders.first[number + 1]; ++piece) {
        const dvec3& point = borders.pointsCentred[borders.pieces[piece].point];
        if (isAnchored || std::ranges::any_of(patch.polygon.corners(),
                                              [&](const dvec3& own) { return glm::distance(own, point) < 1e-6; }))
            pieces.push_back(piece);
    }
    dvec3 value(std::numeric_limits<double>::quiet_NaN());
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::uint32_t piece = pieces[i], next = pieces[(i + 1) % pieces.size()];
        const dvec3 a = borders.pointsCentred[borders.pieces[piece].point] - patch.centre,
                    b = borders.pointsCentred[borders.pieces[next].point] - patch.centre,
                    p = positionCentred - patch.centre;
        const double whole = glm::dot(patch.normal, glm::cross(a, b));
        const double atA = glm::dot(patch.normal, glm::cross(p, b)) / whole,
                     atB = glm::dot(patch.normal, glm::cross(a, p)) / whole;
        if (std::min(atA, atB) <= deepest) continue; // of all triangles the one that it lies in, or is nearest to
        deepest = std::min(atA, atB);
        value = (1 - atA - atB) * ofPatches[number] + atA * atCorners[corners.cornerOfPiece[piece]] +
                atB * atCorners[corners.cornerOfPiece[next]];
    }
    return value;
}

} // namespace shadowlab::testing
