// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/patch_cells.h"

namespace shadowlab::radiosity {

std::vector<double> PatchCells::areasIn(const Polygon& polygon) const {
    std::vector<double> areas(count());
    const dvec3 normal = planeOf(polygon).normal;
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        const Polygon whole{pointIn(cell, {0, 0}), pointIn(cell, {1, 0}), pointIn(cell, {1, 1}), pointIn(cell, {0, 1})};
        const Polygon part = partWithin(polygon, normal, whole, 0);
        areas[cell] = part.isEmpty() ? 0 : glm::length(areaVector(part));
    }
    return areas;
}

} // namespace shadowlab::radiosity
