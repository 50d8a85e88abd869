// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/ground.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace shadowlab::radiosity {

namespace {

// A ground is so many times as large as all that stands on it; a table is not so many times as large as what stands on that.
constexpr double kMuchLarger = 4;

// Edges of pieces of ground are no longer than that many times the distance from what stands on it: seen from there, all are about
// equally large.
constexpr double kOfDistance = 1;

// Planes of one ground differ by no more than this share of its size, and of a turn.
constexpr double kOnePlane = 1e-4;

double diagonal(const trace::CentredBox& box) { return glm::distance(box.lower, box.upper); }

} // namespace

Ground::Ground(const Faces& faces) {
    std::vector<trace::CentredBox> boxes; // of objects
    for (const Face& face : faces.all) {
        if (face.object >= boxes.size()) boxes.resize(face.object + 1);
        boxes[face.object] = around(boxes[face.object], boxOf(face.polygon));
    }
    std::vector<std::uint32_t> bySize;
    for (std::uint32_t object = 0; object < boxes.size(); ++object)
        if (boxes[object].lower.x <= boxes[object].upper.x) bySize.push_back(object); // it has faces
    if (bySize.size() < 2) return;
    std::ranges::stable_sort(bySize, {}, [&](std::uint32_t object) { return diagonal(boxes[object]); });

    std::vector<bool> isOfGround(boxes.size(), false);
    trace::CentredBox rest;
    bool isFound = false;
    for (const std::uint32_t object : bySize) {
        isFound = isFound || (rest.lower.x <= rest.upper.x && diagonal(boxes[object]) > kMuchLarger * diagonal(rest));
        if (isFound)
            isOfGround[object] = true;
        else
            rest = around(rest, boxes[object]);
    }
    if (!isFound) return;
    std::optional<Plane> plane;
    for (const Face& face : faces.all) {
        if (!isOfGround[face.object]) continue;
        if (!plane) plane = face.plane;
        // Another plane: a wall, a hill, a sky. Light is sent between them, and they are no ground.
        const double slack = kOnePlane * sizeOf(face.polygon);
        if (std::ranges::any_of(face.polygon.corners(), [&](const dvec3& corner) { return std::abs(plane->height(corner)) > slack; }) ||
            glm::dot(plane->normal, face.plane.normal) < 1 - kOnePlane)
            return;
    }
    rest_ = rest;
    for (const Face& face : faces.all)
        isGround_.push_back(isOfGround[face.object]);
}

double Ground::sizeAt(const Polygon& piece, double size) const {
    return std::max(size, kOfDistance * distanceBetween(boxOf(piece), rest_));
}

} // namespace shadowlab::radiosity
