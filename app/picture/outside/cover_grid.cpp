// SPDX-License-Identifier: MIT
#include "app/picture/outside/cover_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace shadowlab::picture {

namespace {

std::uint64_t bitOf(std::size_t thing) { return std::uint64_t{1} << thing; }

} // namespace

bool cutToBox(dvec2& from, dvec2& to, const PixelBox& box) {
    const dvec2 along = to - from, start = from;
    double enters = 0, leaves = 1;
    for (int axis = 0; axis < 2; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const double speed = side * along[axis]; // outward, across this border
            const double room = side > 0 ? box.upper[axis] - start[axis] : start[axis] - box.lower[axis];
            if (speed == 0 && room < 0) return false;
            if (speed > 0) leaves = std::min(leaves, room / speed);
            if (speed < 0) enters = std::max(enters, room / speed);
        }
    if (!(enters <= leaves)) return false;
    from = start + enters * along;
    to = start + leaves * along;
    return true;
}

CoverGrid::CoverGrid(ivec2 pictureSize, double cellPixels)
    : cellPixels_(cellPixels), cells_(glm::max(ivec2(1), ivec2(glm::ceil(dvec2(pictureSize) / cellPixels)))),
      pictureSize_(pictureSize), lines_(static_cast<std::size_t>(cells_.x) * static_cast<std::size_t>(cells_.y)),
      faces_(lines_.size()) {}

ivec2 CoverGrid::cellAt(const dvec2& pixel) const {
    return glm::clamp(ivec2(glm::floor(glm::clamp(pixel, dvec2(0), pictureSize_) / cellPixels_)), ivec2(0), cells_ - 1);
}

void CoverGrid::addLine(dvec2 from, dvec2 to, std::size_t thing) {
    if (thing >= kMostThings || !cutToBox(from, to, {dvec2(0), pictureSize_})) return;
    // Two steps for each cell: none that the line passes for long is left out.
    const int steps = 1 + static_cast<int>(2 * glm::length(to - from) / cellPixels_);
    for (int i = 0; i <= steps; ++i)
        lines_[index(cellAt(glm::mix(from, to, static_cast<double>(i) / steps)))] |= bitOf(thing);
}

void CoverGrid::addTriangle(const std::array<dvec2, 3>& corners, std::size_t thing) {
    if (thing >= kMostThings) return;
    const auto [a, b, c] = corners;
    const dvec2 lower = glm::min(a, glm::min(b, c)), upper = glm::max(a, glm::max(b, c));
    if (glm::any(glm::lessThan(upper, dvec2(0))) || glm::any(glm::greaterThan(lower, pictureSize_))) return;
    const auto across = [](const dvec2& p, const dvec2& q, const dvec2& r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const double area = across(a, b, c);
    if (area == 0) return;
    const ivec2 first = cellAt(lower), last = cellAt(upper);
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            const dvec2 middle = middleOf({x, y});
            const bool inside = across(a, b, middle) * area >= 0 && across(b, c, middle) * area >= 0 &&
                                across(c, a, middle) * area >= 0;
            if (inside) faces_[index({x, y})] |= bitOf(thing);
        }
}

bool CoverGrid::hasFace(ivec2 cell, std::size_t thing) const {
    return thing < kMostThings && (faces_[index(cell)] & bitOf(thing)) != 0;
}

int CoverGrid::otherLines(ivec2 cell, std::size_t thing) const {
    return std::popcount(lines_[index(cell)] & ~(thing < kMostThings ? bitOf(thing) : 0));
}

int CoverGrid::otherFaces(ivec2 cell, std::size_t thing) const {
    return std::popcount(faces_[index(cell)] & ~(thing < kMostThings ? bitOf(thing) : 0));
}

template <typename Test>
double CoverGrid::share(const PixelBox& box, const Test& test) const {
    const ivec2 first = cellAt(box.lower), last = cellAt(box.upper);
    int all = 0, found = 0;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x, ++all)
            found += test(ivec2(x, y)) ? 1 : 0;
    return static_cast<double>(found) / all;
}

double CoverGrid::lineShare(const PixelBox& box) const {
    return share(box, [&](ivec2 cell) { return lines_[index(cell)] != 0; });
}

double CoverGrid::otherFaceShare(const PixelBox& box, std::size_t thing) const {
    return share(box, [&](ivec2 cell) { return otherFaces(cell, thing) > 0; });
}

bool CoverGrid::isOnFace(const PixelBox& box, std::size_t thing) const {
    return share(box, [&](ivec2 cell) { return hasFace(cell, thing); }) == 1;
}

} // namespace shadowlab::picture
