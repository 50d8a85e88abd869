// Space on a sheet of paper, in perspective: for drawings that are no section.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "app/drawing/labels.h"

namespace shadowlab::figures {

class SpaceView {
public:
    /// From that side (unit, toward the viewer), and from so far away that nothing of `shownWorld` is behind the viewer; all of
    /// it as large as fits into `area`, with `margin` pixels around it. `mostScale`: pixels for a metre in the middle, at most; with
    /// such a limit all stands at the lower border.
    SpaceView(std::span<const dvec3> shownWorld, const dvec3& towardViewerWorld, const drawing::Box& area, dvec2 margin,
              double mostScale = std::numeric_limits<double>::infinity());

    /// Pixels for a metre that lies square to the view, in the middle of what is shown.
    [[nodiscard]] double pixelsPerMetre() const { return scale_ / away_; }

    [[nodiscard]] dvec2 operator()(const dvec3& positionWorld) const { return centre_ + scale_ * flat(positionWorld); }
    /// Metres from the viewer, along the view.
    [[nodiscard]] double depth(const dvec3& positionWorld) const {
        return glm::dot(viewerWorld_ - positionWorld, towardViewerWorld_);
    }
    /// Is the triangle seen from the side from which its corners run counter-clockwise?
    [[nodiscard]] bool showsFront(const std::array<dvec3, 3>& cornersWorld) const;
    [[nodiscard]] const dvec3& viewerWorld() const { return viewerWorld_; }

private:
    [[nodiscard]] dvec2 flat(const dvec3& positionWorld) const; ///< y downward, at a distance of 1

    dvec3 viewerWorld_{0.0}, towardViewerWorld_{0, 0, 1}, rightWorld_{1, 0, 0}, upWorld_{0, 1, 0};
    dvec2 centre_{0.0};
    double scale_ = 1;
    double away_ = 1; ///< metres from the viewer to the middle
};

/// Of directions all around (unit, toward the viewer), none of them steeply from above or below, the one that is worth most.
dvec3 bestDirection(const std::function<double(const dvec3& towardViewerWorld)>& worth);

} // namespace shadowlab::figures
