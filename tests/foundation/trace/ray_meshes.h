// Meshes to shoot at. Closed ones share their vertices to the last bit; all are seeded, so every run sees the same.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::testing {

/// Ten times the work, and then some, when there is time.
inline int longRun(int times) { return std::getenv("SHADOWLAB_LONG") ? times : 1; }

using Random = std::mt19937_64;
inline double number(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}
inline dvec3 inCube(Random& random, double half) {
    const double x = number(random, -half, half), y = number(random, -half, half);
    return {x, y, number(random, -half, half)};
}
inline dvec3 onSphere(Random& random) {
    for (;;) {
        const dvec3 p = inCube(random, 1);
        if (const double l = glm::length(p); l > 0.1 && l < 1) return p / l;
    }
}

using Triangles = std::vector<trace::Triangle>;

/// A grid of points that closes in both directions.
inline Triangles closedGrid(int around, int along, const std::function<dvec3(int, int)>& at) {
    Triangles triangles;
    const auto wrapped = [&](int i, int j) { return at(i % around, j % along); };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            triangles.push_back({wrapped(i, j), wrapped(i, j + 1), wrapped(i + 1, j + 1)});
            triangles.push_back({wrapped(i, j), wrapped(i + 1, j + 1), wrapped(i + 1, j)});
        }
    return triangles;
}
inline Triangles torus(double major, double minor, int around, int tube) {
    return closedGrid(around, tube, [=](int i, int j) {
        const double a = 2 * M_PI * i / around, t = 2 * M_PI * j / tube, r = major + minor * std::cos(t);
        return dvec3(vec3(static_cast<float>(r * std::cos(a)), static_cast<float>(minor * std::sin(t)),
                          static_cast<float>(-r * std::sin(a))));
    });
}
/// An octahedron, each triangle cut in four and pushed out to the sphere, again and again.
inline Triangles sphere(int levels) {
    Triangles triangles;
    for (int i = 0; i < 8; ++i) {
        const dvec3 x((i & 1) ? -1 : 1, 0, 0), y(0, (i & 2) ? -1 : 1, 0), z(0, 0, (i & 4) ? -1 : 1);
        triangles.push_back({x, y, z});
    }
    // The middle of an edge is the same point from both sides: addition does not mind the order.
    const auto middle = [](const dvec3& a, const dvec3& b) { return dvec3(vec3(glm::normalize(a + b))); };
    for (; levels > 0; --levels) {
        Triangles finer;
        for (const auto& [a, b, c] : triangles) {
            const dvec3 ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const auto& t : {trace::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(t);
        }
        triangles = std::move(finer);
    }
    return triangles;
}
inline Triangles soup(int count, double half, double side, unsigned seed) {
    Random random(seed);
    Triangles triangles;
    for (int i = 0; i < count; ++i) {
        const dvec3 p = inCube(random, half);
        const dvec3 q = p + inCube(random, side);
        triangles.push_back({p, q, p + inCube(random, side)});
    }
    return triangles;
}
/// Many triangles on one edge, thin ones among them, some twice.
inline Triangles fans(unsigned seed) {
    Random random(seed);
    Triangles triangles;
    for (int fan = 0; fan < 12; ++fan) {
        const dvec3 a = inCube(random, 1), b = inCube(random, 1);
        for (int i = 0; i < 20; ++i) {
            const trace::Triangle t{a, b, inCube(random, i % 3 ? 1.0 : 1e-3) + (i % 3 ? dvec3(0) : b)};
            triangles.push_back(t);
            if (i % 5 == 0) triangles.push_back({t.b, t.c, t.a}); // the same, begun elsewhere
        }
    }
    return triangles;
}
/// Details of a micrometre a kilometre away, beside large triangles.
inline Triangles farDetails(unsigned seed) {
    Triangles triangles = soup(60, 1, 1, seed);
    for (const trace::Triangle& t : soup(200, 1e-4, 1e-6, seed + 1)) {
        const dvec3 there(1000, -20, 3);
        triangles.push_back({t.a + there, t.b + there, t.c + there});
    }
    return triangles;
}
/// The same triangle many times, needles, points, and two coplanar sheets.
inline Triangles degenerate(unsigned seed) {
    Random random(seed);
    Triangles triangles(80, trace::Triangle{{-0.5, 0, -0.5}, {0.5, 0, -0.25}, {0, 0.25, 0.5}});
    for (int i = 0; i < 40; ++i) {
        const dvec3 p = inCube(random, 1), d = inCube(random, 1);
        triangles.push_back({p, p, p});
        triangles.push_back({p, p + d, p + d * 0.5});
        triangles.push_back({p, p + d, p + d});
        const double x = 0.05 * i - 1;
        triangles.push_back({{x, 0.5, -1}, {x + 0.3, 0.5, -1}, {x, 0.5, 1}});
    }
    return triangles;
}

/// By trying every triangle that `mayHit` allows.
template <typename MayHit>
trace::RayHit closestOfAll(const Triangles& triangles, const trace::Ray& ray, const MayHit& mayHit) {
    trace::RayHit best;
    if (!isUsable(ray)) return best;
    const trace::ShearedRay sheared(ray);
    double farthest = sheared.farthest;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (const auto hit = intersect(sheared, triangles[i], farthest); hit && hit->reach < farthest && mayHit(i)) {
            farthest = hit->reach;
            best = trace::RayHit{farthest / sheared.reachPerT, i, hit->barycentric};
        }
    return best;
}
inline trace::RayHit closestOfAll(const Triangles& triangles, const trace::Ray& ray) {
    return closestOfAll(triangles, ray, [](std::uint32_t) { return true; });
}

/// Exactly along an axis, through the point; the other components are zeros of that sign.
inline void aimAlongAxis(trace::Ray& ray, const dvec3& throughCentred, int axis, bool positiveZeros) {
    ray.originCentred = throughCentred;
    ray.originCentred[axis] -= 3;
    ray.directionCentred = dvec3(positiveZeros ? 0.0 : -0.0);
    ray.directionCentred[axis] = 1;
}

/// Every seventh ray is short, every fifth begins late.
inline void limitSome(trace::Ray& ray, Random& random, int count) {
    if (count % 7 == 0) ray.farthest = number(random, 0.1, 1.5);
    if (count % 5 == 0) ray.nearest = number(random, 0, 0.5);
}

} // namespace shadowlab::testing
