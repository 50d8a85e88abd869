// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/openings.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/room/sample_hemisphere.h"

namespace shadowlab::radiosity {

namespace {

// Light from outside is found by chance well enough where patches see it in more than this share of their view.
constexpr double kRareView = 0.25;

// The walls of a room may have outsides that see nothing but the sky. Then the patches that see less than that count alone, if they are this share of all
// surfaces and see this much on average: under the open sky too some patches see little of it, but more than through a window.
constexpr double kInside = 0.3, kThroughWindows = 0.03;

// Less of all light than that may be noise: it is not seen.
constexpr double kMuch = 0.05;

// Cells along a side of each face of the box. A window is some of them; with finer ones rays would miss more.
constexpr std::size_t kCells = 24, kCellsOfFace = kCells * kCells;

// So many rays look for openings, spread over all patches.
constexpr std::size_t kSearchRays = 16384;

// The box is so much larger than what it holds, as a share of its size: surfaces in its faces lie inside.
constexpr double kMargin = 1e-3;

/// Face 2 a lies at the lower end of the axis a, face 2 a + 1 at the upper end. Its cells are numbered along the two other axes.
std::size_t faceOfCell(std::size_t cell) { return cell / kCellsOfFace; }

} // namespace

Openings::Openings(const Room& room) {
    const Room::MeanView all = room.meanView(1), inside = room.meanView(kRareView);
    const bool isRare = all.share <= kRareView, hasInside = inside.area > kInside * all.area && inside.share <= kThroughWindows;
    if (!(inside.share > 0) || !(isRare || hasInside)) return;
    for (const double view : room.surroundings())
        viewInside_.push_back(view <= kRareView ? view : kOutside);
    lower_ = dvec3(1e300);
    upper_ = dvec3(-1e300);
    for (const Patch& patch : room.allPatches())
        for (const dvec3& corner : patch.polygon.corners()) {
            lower_ = glm::min(lower_, corner);
            upper_ = glm::max(upper_, corner);
        }
    const double margin = kMargin * glm::length(upper_ - lower_);
    lower_ += room.world().originWorld - margin;
    upper_ += room.world().originWorld + margin;
    isOpen_.assign(6 * kCellsOfFace, 0);
    open(room);
    const dvec3 size = upper_ - lower_;
    for (std::uint32_t cell = 0; cell < isOpen_.size(); ++cell) {
        if (isOpen_[cell] == 0) continue;
        const int axis = static_cast<int>(faceOfCell(cell) / 2);
        area_ += size[(axis + 1) % 3] * size[(axis + 2) % 3] / static_cast<double>(kCellsOfFace);
        open_.push_back(cell);
        upTo_.push_back(area_);
    }
    for (double& share : upTo_)
        share /= area_;
}

bool Openings::bringMuch(const dvec3& outside, std::span<const Patch> patches, std::span<const dvec3> irradiance) const {
    if (isEmpty()) return false;
    double power = 0, fromOutside = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        if (viewInside_[i] == kOutside) continue;
        power += patches[i].area * luminance(irradiance[i]);
        fromOutside += patches[i].area * viewInside_[i] * glm::pi<double>() * luminance(outside);
    }
    return fromOutside > kMuch * power;
}

/// Marks the cells through which rays go out, and those around them: what goes out beside is found by chance alone, and is noise.
void Openings::open(const Room& room) {
    const std::size_t perPatch = std::max<std::size_t>(1, kSearchRays / room.patches().size());
    for (std::size_t i = 0; i < room.patches().size(); ++i) {
        if (viewInside_[i] == 0 || viewInside_[i] == kOutside) continue;
        for (const HemisphereRay& ray : outwardRays(room.tracer(), room.patches()[i], perPatch))
            if (const dvec3 from = room.world().originWorld + ray.fromCentred; surround(from)) openAround(crossing(from, ray.direction).cell);
    }
}

void Openings::openAround(std::size_t cell) {
    const std::size_t face = faceOfCell(cell) * kCellsOfFace, row = (cell - face) / kCells, column = (cell - face) % kCells;
    for (std::size_t y = row - std::min<std::size_t>(row, 1); y <= std::min(row + 1, kCells - 1); ++y)
        for (std::size_t x = column - std::min<std::size_t>(column, 1); x <= std::min(column + 1, kCells - 1); ++x)
            isOpen_[face + y * kCells + x] = 1;
}

bool Openings::surround(const dvec3& positionWorld) const {
    return glm::all(glm::greaterThan(positionWorld, lower_)) && glm::all(glm::lessThan(positionWorld, upper_));
}

/// Where a ray from within the box goes out of it.
Openings::Crossing Openings::crossing(const dvec3& fromWorld, const dvec3& direction) const {
    Crossing found{1e300, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) continue;
        const double distance = ((direction[axis] > 0 ? upper_ : lower_)[axis] - fromWorld[axis]) / direction[axis];
        if (distance < found.distance) found = {distance, axis, 0};
    }
    const dvec3 place = (fromWorld + found.distance * direction - lower_) / (upper_ - lower_); // of the unit cube
    const auto along = [&](int axis) {
        return static_cast<std::size_t>(std::clamp(place[axis] * static_cast<double>(kCells), 0.0, static_cast<double>(kCells) - 1));
    };
    const std::size_t face = 2 * static_cast<std::size_t>(found.axis) + (direction[found.axis] > 0 ? 1 : 0);
    found.cell = face * kCellsOfFace + along((found.axis + 2) % 3) * kCells + along((found.axis + 1) % 3);
    return found;
}

Openings::Choice Openings::choose(double which, const dvec2& where) const {
    const auto found = std::min<std::ptrdiff_t>(std::ranges::upper_bound(upTo_, which) - upTo_.begin(),
                                                static_cast<std::ptrdiff_t>(open_.size()) - 1);
    const std::size_t cell = open_[static_cast<std::size_t>(found)], face = faceOfCell(cell), within = cell - face * kCellsOfFace;
    const int axis = static_cast<int>(face / 2);
    const bool isUpper = face % 2 == 1;
    dvec3 place(isUpper ? 1.0 : 0.0), inward(0);
    place[(axis + 1) % 3] = (static_cast<double>(within % kCells) + where.x) / static_cast<double>(kCells);
    place[(axis + 2) % 3] = (static_cast<double>(within / kCells) + where.y) / static_cast<double>(kCells);
    inward[axis] = isUpper ? -1 : 1;
    return {lower_ + place * (upper_ - lower_), inward};
}

std::optional<Openings::Exit> Openings::exit(const dvec3& fromWorld, const dvec3& direction) const {
    const Crossing found = crossing(fromWorld, direction);
    if (isOpen_[found.cell] == 0) return std::nullopt;
    return Exit{found.distance, std::abs(direction[found.axis])};
}

} // namespace shadowlab::radiosity
