// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::trace {

namespace {

// The sides are made wider by this share of the size of the coordinates: thousands of roundings, so that nothing that
// touches the shaft is lost to them, and far less than anything that is worth leaving out.
constexpr double kRounding = 1e-12;

/// The largest product of the normal with a point of the box.
double farthest(const CentredBox& box, const dvec3& normal) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        sum += normal[axis] * (normal[axis] > 0 ? box.upper[axis] : box.lower[axis]);
    return sum;
}

} // namespace

CentredBox boxOf(const Triangle& triangle) {
    CentredBox box;
    for (const dvec3& corner : {triangle.a, triangle.b, triangle.c})
        box.include(corner);
    return box;
}

Shaft::Shaft(const CentredBox& from, const CentredBox& to) : hull_(from) {
    hull_.include(to.lower);
    hull_.include(to.upper);
    const dvec3 largest = glm::max(glm::abs(hull_.lower), glm::abs(hull_.upper));
    const double slack = kRounding * (largest.x + largest.y + largest.z);
    hull_.grow(slack);
    // Seen along an axis the boxes are rectangles. The hull of both has their own sides, and up to two that go from a corner
    // of one to the same corner of the other.
    for (int along = 0; along < 3; ++along) {
        const int i = (along + 1) % 3, j = (along + 2) % 3;
        for (int corner = 0; corner < 4; ++corner) {
            const auto at = [&](const CentredBox& box) {
                return dvec2((corner & 1 ? box.upper : box.lower)[i], (corner & 2 ? box.upper : box.lower)[j]);
            };
            const dvec2 way = at(to) - at(from);
            const double length = glm::length(way);
            if (!(length > 0)) continue;
            for (const double turn : {1.0, -1.0}) {
                Side side{dvec3(0.0), 0};
                side.normal[i] = turn * way.y / length;
                side.normal[j] = -turn * way.x / length;
                side.offset = side.normal[i] * at(from).x + side.normal[j] * at(from).y + 2 * slack;
                if (farthest(from, side.normal) <= side.offset && farthest(to, side.normal) <= side.offset)
                    sides_.push_back(side);
            }
        }
    }
}

bool Shaft::mayTouch(const CentredBox& box) const {
    if (!hull_.touches(box)) return false;
    for (const Side& side : sides_)
        if (-farthest(box, -side.normal) > side.offset) return false;
    return true;
}

bool Shaft::mayTouch(const Triangle& triangle) const {
    if (!hull_.touches(boxOf(triangle))) return false;
    for (const Side& side : sides_)
        if (glm::dot(side.normal, triangle.a) > side.offset && glm::dot(side.normal, triangle.b) > side.offset &&
            glm::dot(side.normal, triangle.c) > side.offset)
            return false;
    return true;
}

bool Shaft::mayTouch(const dvec3& firstCentred, const dvec3& secondCentred) const {
    CentredBox own;
    own.include(firstCentred);
    own.include(secondCentred);
    if (!hull_.touches(own)) return false;
    for (const Side& side : sides_)
        if (glm::dot(side.normal, firstCentred) > side.offset && glm::dot(side.normal, secondCentred) > side.offset)
            return false;
    return true;
}

} // namespace shadowlab::trace
