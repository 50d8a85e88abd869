// A patch in 4 x 4 cells: where on it something is, more finely than by the patch.
//
// They are those of the rectangle around the patch that is parallel to its first edge. Of a rectangle they are its sixteenths; of another polygon, some lie
// partly or wholly beside it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

class PatchCells {
public:
    static constexpr std::size_t kOnSide = 4, kCount = kOnSide * kOnSide;
    using Shares = std::array<float, kCount>; ///< of each cell; they sum to 1

    explicit PatchCells(const Polygon& polygon) : frame_(frameOf(polygon)) {
        for (const dvec3& corner : polygon.corners()) {
            lower_ = glm::min(lower_, frame_.place(corner));
            upper_ = glm::max(upper_, frame_.place(corner));
        }
    }

    /// The cell of a point of the patch.
    [[nodiscard]] std::size_t at(const dvec3& positionCentred) const {
        const dvec2 place = double{kOnSide} * (frame_.place(positionCentred) - lower_) / (upper_ - lower_);
        const auto index = [](double along) { return static_cast<std::size_t>(glm::clamp(along, 0.0, kOnSide - 0.5)); };
        return index(place.y) * kOnSide + index(place.x);
    }
    /// The image of a point of the unit square in a cell. It may lie beside the patch.
    [[nodiscard]] dvec3 pointIn(std::size_t cell, const dvec2& where) const {
        const dvec2 place = lower_ + (dvec2(cell % kOnSide, cell / kOnSide) + where) / double{kOnSide} * (upper_ - lower_);
        return frame_.originCentred + place.x * frame_.u + place.y * frame_.v;
    }
    /// Of one cell, m^2.
    [[nodiscard]] double area() const { return (upper_.x - lower_.x) * (upper_.y - lower_.y) / kCount; }

private:
    FaceFrame frame_;
    dvec2 lower_{0.0}, upper_{0.0}; ///< the frame's origin is a corner
};

} // namespace shadowlab::radiosity
