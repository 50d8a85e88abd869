// Ear clipping: cut off a corner whose triangle holds no other corner, until a triangle is left. Each cut changes only
// the two neighbours, so the whole takes n times the number of concave corners.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/polygon_triangulation.h"

#include <cmath>

namespace shadowlab::scene {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Newell's normal: the sum over all edges, right also for concave and slightly bent polygons.
dvec3 newellNormal(std::span<const dvec3> corners) {
    dvec3 normal(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        // Relative to the first corner, so that a polygon far from the origin keeps its digits.
        const dvec3 a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
        normal += glm::cross(a, b);
    }
    return normal;
}

/// Twice the signed area of a triangle in the plane.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon seen along the largest axis of its normal: dropping a coordinate is exact, and keeps the orientation.
std::vector<dvec2> projected(std::span<const dvec3> corners) {
    const dvec3 normal = newellNormal(corners);
    const dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<dvec2> result;
    result.reserve(corners.size());
    for (const dvec3& corner : corners)
        result.push_back(normal[axis] >= 0.0 ? dvec2(corner[u], corner[v]) : dvec2(corner[v], corner[u]));
    return result;
}

class EarClipper {
public:
    EarClipper(const std::vector<dvec2>& points, std::vector<Triangle>& triangles)
        : points_(points), triangles_(triangles), next_(points.size()), previous_(points.size()),
          isEar_(points.size()) {
        const auto n = static_cast<std::uint32_t>(points.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
        }
        for (std::uint32_t i = 0; i < n; ++i)
            if (turnAt(i) <= 0.0) blunt_.push_back(i);
        for (std::uint32_t i = 0; i < n; ++i)
            isEar_[i] = checkEar(i);
    }

    void run() {
        std::uint32_t corner = 0;
        for (std::size_t left = points_.size(); left > 3; --left) {
            const std::uint32_t ear = findEar(corner, left);
            triangles_.push_back({previous_[ear], ear, next_[ear]});
            corner = cut(ear);
        }
        triangles_.push_back({previous_[corner], corner, next_[corner]});
    }

private:
    [[nodiscard]] double turnAt(std::uint32_t i) const {
        return turn(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    /// Only concave or straight corners can lie in another corner's triangle; those on its rim count too, else the
    /// cut would run through them and leave a triangle without area.
    [[nodiscard]] bool checkEar(std::uint32_t i) const {
        if (!(turnAt(i) > 0.0)) return false;
        const dvec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
        for (const std::uint32_t other : blunt_) {
            const dvec2& p = points_[other];
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    /// An ear; without one (a polygon that crosses itself) a convex corner, then any.
    [[nodiscard]] std::uint32_t findEar(std::uint32_t start, std::size_t left) const {
        std::uint32_t i = start, convex = start;
        bool hasConvex = false;
        for (std::size_t tried = 0; tried < left; ++tried, i = next_[i]) {
            if (isEar_[i]) return i;
            if (!hasConvex && turnAt(i) > 0.0) {
                hasConvex = true;
                convex = i;
            }
        }
        return convex;
    }

    /// Takes the corner out; returns the corner to go on from. Skipping one corner spreads the cuts around the polygon
    /// instead of making a fan of slivers.
    std::uint32_t cut(std::uint32_t ear) {
        const std::uint32_t before = previous_[ear], after = next_[ear];
        next_[before] = after;
        previous_[after] = before;
        std::erase_if(blunt_,
                      [&](std::uint32_t i) { return i == ear || ((i == before || i == after) && turnAt(i) > 0.0); });
        isEar_[before] = checkEar(before);
        isEar_[after] = checkEar(after);
        return next_[after];
    }

    const std::vector<dvec2>& points_;
    std::vector<Triangle>& triangles_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<char> isEar_;
    std::vector<std::uint32_t> blunt_; ///< corners that turn the wrong way, or not at all
};

} // namespace

void triangulate(std::span<const dvec3> corners, std::vector<Triangle>& triangles) {
    triangles.clear();
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return;
    }
    const std::vector<dvec2> p = projected(corners);
    if (corners.size() == 4) {
        // The diagonal 0-2, unless only 1-3 stays inside.
        const bool along02 = turn(p[0], p[1], p[2]) > 0.0 && turn(p[0], p[2], p[3]) > 0.0;
        const bool along13 = turn(p[0], p[1], p[3]) > 0.0 && turn(p[1], p[2], p[3]) > 0.0;
        if (along13 && !along02)
            triangles.insert(triangles.end(), {{0, 1, 3}, {1, 2, 3}});
        else
            triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
        return;
    }
    EarClipper(p, triangles).run();
}

} // namespace shadowlab::scene
