// SPDX-License-Identifier: MIT
#include "tests/relations/solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"

namespace shadowlab::relations {

namespace {

using lvec3 = glm::i64vec3; // products of three numbers of 2^13 need more than 32 bits

/// Six times the volume of the tetrahedron: positive where `d` lies behind a, b, c, that is inside. Exact.
std::int64_t behind(const ivec3& a, const ivec3& b, const ivec3& c, const ivec3& d) {
    const lvec3 u = lvec3(b) - lvec3(a), v = lvec3(c) - lvec3(a), w = lvec3(a) - lvec3(d);
    const lvec3 normal(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    return normal.x * w.x + normal.y * w.y + normal.z * w.z;
}

ivec3 rounded(const dvec3& place) { return ivec3(glm::round(place)); }

Solid icosahedron() {
    const double t = (1 + std::sqrt(5.0)) / 2, scale = 1000; // any number: only directions matter
    Solid solid;
    for (const dvec3 corner :
         {dvec3(-1, t, 0), dvec3(1, t, 0), dvec3(-1, -t, 0), dvec3(1, -t, 0), dvec3(0, -1, t), dvec3(0, 1, t),
          dvec3(0, -1, -t), dvec3(0, 1, -t), dvec3(t, 0, -1), dvec3(t, 0, 1), dvec3(-t, 0, -1), dvec3(-t, 0, 1)})
        solid.corners.push_back(rounded(scale * corner));
    solid.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return solid;
}

} // namespace

Solid makeBoxSolid(const ivec3& size) {
    Solid solid;
    for (int i = 0; i < 8; ++i)
        solid.corners.push_back(size / 2 * ivec3((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1));
    solid.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return solid;
}

Solid makeBallSolid(const ivec3& size) {
    const Solid coarse = icosahedron();
    std::vector<dvec3> directions;
    for (const ivec3& corner : coarse.corners)
        directions.push_back(glm::normalize(dvec3(corner)));
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
        const auto [known, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<unsigned>(directions.size()));
        if (isNew) directions.push_back(glm::normalize(directions[a] + directions[b]));
        return known->second;
    };
    Solid solid;
    for (const uvec3& t : coarse.triangles) {
        const unsigned ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
        for (const uvec3& part : {uvec3(t.x, ab, ca), uvec3(ab, t.y, bc), uvec3(ca, bc, t.z), uvec3(ab, bc, ca)})
            solid.triangles.push_back(part);
    }
    for (const dvec3& direction : directions)
        solid.corners.push_back(rounded(direction * dvec3(size) / 2.0));
    return solid;
}

Solid makePrismSolid(const ivec3& size, unsigned shape) {
    std::mt19937 random(shape);
    const auto share = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random() % 1024) / 1023; // the same with every library
    };
    const unsigned corners = 4 + random() % 3;
    const ivec3 shift = rounded({share(-0.25, 0.25) * size.x, size.y / 2, share(-0.25, 0.25) * size.z});
    Solid solid;
    for (const int side : {-1, 1})
        for (unsigned i = 0; i < corners; ++i) {
            std::mt19937 again(shape + 1 + i); // the same outline on both sides
            const double radius = 0.25 + 0.25 * static_cast<double>(again() % 1024) / 1023;
            const double angle = -2 * M_PI * i / corners;
            const ivec3 foot = rounded(radius * dvec3(size) * dvec3(std::cos(angle), 0, std::sin(angle)));
            solid.corners.push_back(foot + side * shift);
        }
    // A star seen from its middle: fans from there are right even where a fan from a corner would not be.
    const auto below = static_cast<unsigned>(solid.corners.size()), above = below + 1;
    solid.corners.push_back(-shift);
    solid.corners.push_back(shift);
    for (unsigned i = 0; i < corners; ++i) {
        const unsigned next = (i + 1) % corners;
        for (const uvec3& part : {uvec3(i, below, next), uvec3(corners + i, corners + next, above),
                                  uvec3(i, next, corners + next), uvec3(i, corners + next, corners + i)})
            solid.triangles.push_back(part);
    }
    return solid;
}

Solid makeHullSolid(const ivec3& size, unsigned shape) {
    std::mt19937 random(shape);
    const auto coordinate = [&](int extent) {
        return static_cast<int>(random() % static_cast<unsigned>(extent + 1)) - extent / 2;
    };
    std::vector<ivec3> points;
    for (unsigned i = 8 + random() % 7; i > 0; --i) {
        const int x = coordinate(size.x), y = coordinate(size.y), z = coordinate(size.z);
        points.emplace_back(x, y, z);
    }
    // Every triple that has all other points behind it. Where four corners lie in one plane that would be more triangles than
    // the face needs: by chance it all but never happens, and then a box stands in.
    Solid solid{points, {}};
    const auto n = static_cast<unsigned>(points.size());
    for (unsigned a = 0; a < n; ++a)
        for (unsigned b = a + 1; b < n; ++b)
            for (unsigned c = b + 1; c < n; ++c) {
                int inside = 0, outside = 0, flat = 0;
                for (unsigned d = 0; d < n; ++d) {
                    if (d == a || d == b || d == c) continue;
                    const std::int64_t side = behind(points[a], points[b], points[c], points[d]);
                    ++(side > 0 ? inside : side < 0 ? outside : flat);
                }
                if (inside > 0 && outside > 0) continue;
                if (flat > 0) return makeBoxSolid(size);
                solid.triangles.push_back(inside > 0 ? uvec3(a, b, c) : uvec3(a, c, b));
            }
    return solid;
}

scene::Mesh meshOf(const Solid& solid, bool smooth) {
    scene::Mesh mesh;
    for (const ivec3& corner : solid.corners) {
        mesh.positionsMesh.emplace_back(dvec3(corner) * kGrid);
        mesh.normalsMesh.emplace_back(0, 1, 0);
    }
    mesh.triangles = solid.triangles;
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return scene::withNormals(mesh, smooth ? scene::NormalMode::smooth : scene::NormalMode::flat);
}

} // namespace shadowlab::relations
