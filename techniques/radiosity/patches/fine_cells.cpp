// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/fine_cells.h"

#include <algorithm>

namespace shadowlab::radiosity {

FineCells::FineCells(const Patch& patch, std::size_t side) : frame_(frameOf(patch.polygon)), side_(side) {
    lower_ = upper_ = frame_.place(patch.polygon[0]);
    for (const dvec3& corner : patch.polygon.corners()) {
        lower_ = glm::min(lower_, frame_.place(corner));
        upper_ = glm::max(upper_, frame_.place(corner));
    }
}

std::size_t FineCells::at(const dvec3& positionCentred) const {
    const dvec2 place = static_cast<double>(side_) * (frame_.place(positionCentred) - lower_) / (upper_ - lower_);
    const auto index = [&](double along) { return std::min(static_cast<std::size_t>(std::max(along, 0.0)), side_ - 1); };
    return index(place.y) * side_ + index(place.x);
}

std::vector<double> FineCells::areas(const Patch& patch) const {
    std::vector<double> areas(count());
    const dvec2 size = (upper_ - lower_) / static_cast<double>(side_);
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        const dvec2 from = lower_ + size * dvec2(cell % side_, cell / side_);
        const auto corner = [&](double x, double y) { return frame_.originCentred + (from.x + x * size.x) * frame_.u + (from.y + y * size.y) * frame_.v; };
        Polygon part{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        for (std::size_t i = 0; i < patch.polygon.count() && !part.isEmpty(); ++i) {
            const dvec3 &a = patch.polygon[i], &b = patch.polygon[(i + 1) % patch.polygon.count()];
            part = partBefore({a, glm::normalize(glm::cross(patch.normal, b - a))}, part, 0);
        }
        areas[cell] = part.isEmpty() ? 0 : glm::length(areaVector(part));
    }
    return areas;
}

} // namespace shadowlab::radiosity
