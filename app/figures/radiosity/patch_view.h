// From where two patches in space are drawn, so that both show their fronts, and neither hides the other.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/probe.h"
#include "techniques/probed/patch_exchange.h"

namespace shadowlab::figures {

/// A parallel projection: what is parallel in the scene is parallel in the drawing. Directions are those of the scene. Sizes are,
/// too, as far as they can be drawn: of a small surface beside a large one, or a long way off, nothing would be seen.
struct PatchView {
    dvec3 rightWorld{1, 0, 0}, upWorld{0, 1, 0};
    dvec3 towardViewerWorld{0, 0, 1};
    std::array<double, 2> magnified{1, 1}; ///< j and k are drawn so many times as large, about their centres
    double distanceShare = 1;              ///< so much of the distance between their centres is drawn

    /// Metres of the drawing, y upward.
    [[nodiscard]] dvec2 of(const dvec3& directionWorld) const {
        return {glm::dot(directionWorld, rightWorld), glm::dot(directionWorld, upWorld)};
    }
};

/// Of all directions to look from, one of the best.
PatchView patchView(const PatchProbe& j, const PatchProbe& k);

/// The corners as they are drawn, about a centre that is drawn there.
std::vector<dvec2> drawnCorners(const PatchProbe& patch, const PatchView& view, double magnified, dvec2 centre);

/// Have two convex polygons more than a rim in common?
bool overlap(const std::vector<dvec2>& a, const std::vector<dvec2>& b);

} // namespace shadowlab::figures
