// A patch in as many cells as are wanted: what changes within it by far more than the patch is small (patch_cells.h has few of them, for choosing by).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

class FineCells {
public:
    FineCells() = default; ///< none
    /// side x side cells of the rectangle around the patch that is parallel to its first edge.
    FineCells(const Patch& patch, std::size_t side);

    [[nodiscard]] bool isEmpty() const { return side_ == 0; }
    [[nodiscard]] std::size_t count() const { return side_ * side_; }
    /// The cell of a point of the patch.
    [[nodiscard]] std::size_t at(const dvec3& positionCentred) const;
    /// Of the part of each cell that lies in the patch, m^2.
    [[nodiscard]] std::vector<double> areas(const Patch& patch) const;

private:
    FaceFrame frame_;
    dvec2 lower_{0.0}, upper_{0.0};
    std::size_t side_ = 0;
};

} // namespace shadowlab::radiosity
