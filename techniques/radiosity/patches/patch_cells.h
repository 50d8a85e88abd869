// A patch in cells, 4 x 4 of them or as many as are wanted: where on it something is, more finely than by the patch.
//
// They are those of the rectangle around the patch that is parallel to its first edge. Of a rectangle they are equal parts of it; of another polygon, some lie
// partly or wholly beside it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

class PatchCells {
public:
    static constexpr std::size_t kOnSide = 4, kCount = kOnSide * kOnSide;
    using Shares = std::array<float, kCount>; ///< of each of the 4 x 4 cells; they sum to 1

    explicit PatchCells(const Polygon& polygon, std::size_t onSide = kOnSide) : frame_(frameOf(polygon)), onSide_(onSide) {
        for (const dvec3& corner : polygon.corners()) {
            lower_ = glm::min(lower_, frame_.place(corner));
            upper_ = glm::max(upper_, frame_.place(corner));
        }
    }

    /// The cell of a point of the patch.
    [[nodiscard]] std::size_t at(const dvec3& positionCentred) const {
        const auto onSide = static_cast<double>(onSide_);
        const dvec2 place = onSide * (frame_.place(positionCentred) - lower_) / (upper_ - lower_);
        const auto index = [&](double along) { return static_cast<std::size_t>(glm::clamp(along, 0.0, onSide - 0.5)); };
        return index(place.y) * onSide_ + index(place.x);
    }
    /// The image of a point of the unit square in a cell. It may lie beside the patch.
    [[nodiscard]] dvec3 pointIn(std::size_t cell, const dvec2& where) const {
        const dvec2 place = lower_ + (dvec2(cell % onSide_, cell / onSide_) + where) / static_cast<double>(onSide_) * (upper_ - lower_);
        return frame_.originCentred + place.x * frame_.u + place.y * frame_.v;
    }
    /// Of one cell, m^2.
    [[nodiscard]] double area() const { return (upper_.x - lower_.x) * (upper_.y - lower_.y) / static_cast<double>(count()); }
    /// Of the part of each that lies in the polygon, from which they were made, m^2.
    [[nodiscard]] std::vector<double> areasIn(const Polygon& polygon) const;
    [[nodiscard]] std::size_t count() const { return onSide_ * onSide_; }

private:
    FaceFrame frame_;
    std::size_t onSide_ = 0;
    dvec2 lower_{0.0}, upper_{0.0}; ///< the frame's origin is a corner
};

} // namespace shadowlab::radiosity
