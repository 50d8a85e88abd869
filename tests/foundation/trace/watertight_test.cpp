// From inside a closed mesh no ray gets out: not at a vertex, not at an edge, near the origin or a million metres away,
// in any size.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/world_triangles.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

struct ClosedMesh {
    const char* name;
    Triangles triangles;
    std::function<dvec3(Random&)> inside;
};

std::vector<ClosedMesh> closedMeshes() {
    const Triangles bumpy = [] {
        Triangles triangles = sphere(4);
        for (Triangle& t : triangles) // the same bump for the same vertex, whatever triangle it is of
            for (dvec3* p : {&t.a, &t.b, &t.c})
                *p = dvec3(vec3(*p * (1 + 0.2 * std::sin(13 * p->x) * std::sin(17 * p->y + 5 * p->z))));
        return triangles;
    }();
    const auto near = [](double half) { return [half](Random& random) { return inCube(random, half); }; };
    return {{"sphere", sphere(4), near(0.4)},
            {"bumpy", bumpy, near(0.3)},
            {"octahedron", sphere(0), near(0.2)},
            {"torus", torus(1, 0.4, 40, 20), [](Random& random) {
                 const double a = number(random, 0, 2 * M_PI);
                 return dvec3(std::cos(a), 0, std::sin(a)) + inCube(random, 0.15);
             }}};
}

/// The mesh as part of a scene, moved and scaled: the tracer sees what world_triangles.h makes of it.
Triangles placed(const Triangles& triangles, double offset, double scale) {
    std::vector<dvec3> corners;
    for (const Triangle& t : triangles)
        corners.insert(corners.end(), {t.a, t.b, t.c});
    scene::Scene scene;
    scene.materials.emplace_back();
    dmat4 worldFromObject = testing::translation(dvec3(offset, -offset, 0.5 * offset));
    worldFromObject = worldFromObject * dmat4(dmat3(scale));
    testing::addObject(scene, testing::triangleSoup(corners), worldFromObject);
    return worldTriangles(scene).triangles;
}

using HitsSomething = std::function<bool(const Ray&)>;

/// Rays from inside at vertices, at the middles of edges, at points on edges, and anywhere.
long leaks(const ClosedMesh& mesh, const Triangles& triangles, double scale, const dvec3& middle, long rays,
           unsigned seed, const HitsSomething& hits) {
    std::atomic<long> leaked = 0;
    constexpr long kPerPiece = 2000;
    parallelFor(static_cast<std::size_t>(rays / kPerPiece), [&](std::size_t piece) {
        Random random(seed * 100'003 + piece);
        for (int i = 0; i < kPerPiece; ++i) {
            Ray ray;
            ray.originCentred = middle + scale * mesh.inside(random);
            const Triangle& t = triangles[random() % triangles.size()];
            const dvec3 targets[] = {t.a, 0.5 * (t.b + t.c), glm::mix(t.a, t.b, number(random, 0, 1))};
            ray.directionCentred =
                i % 4 == 3 ? onSphere(random) : targets[static_cast<std::size_t>(i % 4)] - ray.originCentred;
            if (i % 8 >= 4) ray.directionCentred = glm::normalize(ray.directionCentred); // one rounding more
            leaked += !hits(ray);
        }
    });
    return leaked;
}

TEST(WatertightTest, NoRayLeavesAClosedMesh) {
    long all = 0, leaked = 0;
    unsigned seed = 0;
    for (const ClosedMesh& mesh : closedMeshes())
        for (const double offset : {0.0, 1e4, 1e6})
            for (const double scale : {1e-4, 1.0, 1e4}) {
                const Triangles triangles = placed(mesh.triangles, offset, scale);
                const Bvh bvh = buildBvh(triangles);
                // The middle of the boxes is not that of the mesh: find it again from a vertex.
                const dvec3 middle = triangles[0].a - scale * mesh.triangles[0].a;
                const long rays = 28'000L * longRun(100);
                const long found = leaks(mesh, triangles, scale, middle, rays, ++seed, [&](const Ray& ray) {
                    return bvh.closest(ray) && bvh.any(ray, [](std::uint32_t) { return true; }) != kNoPrimitive;
                });
                EXPECT_EQ(found, 0) << mesh.name << ", offset " << offset << ", scale " << scale;
                all += rays;
                leaked += found;
            }
    std::cout << all << " rays from inside closed meshes, " << leaked << " leaks\n";
    EXPECT_GE(all, 1'000'000);
}

/// Moeller and Trumbore, 1997, in float and as it is usually written down. Leaky on purpose.
bool naiveHit(const Ray& ray, const Triangle& t) {
    const vec3 o(ray.originCentred), d(ray.directionCentred), a(t.a), ab = vec3(t.b) - a, ac = vec3(t.c) - a;
    const vec3 p = glm::cross(d, ac);
    const float determinant = glm::dot(ab, p);
    if (std::abs(determinant) < 1e-12f) return false;
    const vec3 s = o - a, q = glm::cross(s, ab);
    const float u = glm::dot(s, p) / determinant, v = glm::dot(d, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && glm::dot(ac, q) / determinant > 0;
}

// The same rays must find the cracks of a tracer that has some, or they prove nothing.
TEST(WatertightTest, TheNaiveTestLeaks) {
    const ClosedMesh mesh = closedMeshes()[0];
    const long found = leaks(mesh, mesh.triangles, 1, dvec3(0), 4000, 1, [&](const Ray& ray) {
        for (const Triangle& t : mesh.triangles)
            if (naiveHit(ray, t)) return true;
        return false;
    });
    std::cout << "naive: " << found << " of 4000 leak\n";
    EXPECT_GT(found, 40);
}

} // namespace
} // namespace shadowlab::trace
