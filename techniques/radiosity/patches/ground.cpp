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

/// Those of some objects. In another plane is a wall, a hill, a sky: light is sent between them, and they are no ground.
bool areInOnePlane(const Faces& faces, const std::vector<bool>& isOfObject) {
    std::optional<Plane> plane;
    return std::ranges::all_of(faces.all, [&](const Face& face) {
        if (!isOfObject[face.object]) return true;
        if (!plane) plane = face.plane;
        const double slack = kOnePlane * sizeOf(face.polygon);
        const auto isInPlane = [&](const dvec3& corner) { return std::abs(plane->height(corner)) <= slack; };
        return std::ranges::all_of(face.polygon.corners(), isInPlane) && glm::dot(plane->normal, face.plane.normal) >= 1 - kOnePlane;
    });
}

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
    std::ranges::stable_sort(bySize, {}, [&](std::uint32_t object) { return diagonal(boxes[object]); });

    // Of what is much larger than all that is smaller: houses may be so beside a bin, and are no ground.
    std::vector<bool> isLarge(boxes.size(), true);
    trace::CentredBox rest;
    for (const std::uint32_t object : bySize) {
        const bool isMuchLarger = rest.lower.x <= rest.upper.x && diagonal(boxes[object]) > kMuchLarger * diagonal(rest);
        if (isMuchLarger && areInOnePlane(faces, isLarge)) {
            rest_ = rest;
            for (const Face& face : faces.all)
                isGround_.push_back(isLarge[face.object]);
            return;
        }
        isLarge[object] = false;
        rest = around(rest, boxes[object]);
    }
}

double Ground::sizeAt(const Polygon& piece, double size) const {
    return std::max(size, kOfDistance * distanceBetween(boxOf(piece), rest_));
}

} // namespace shadowlab::radiosity
