// Every structure against trying every triangle: the same primitive at the same distance with the same weights, to the last
// bit, of random rays and of rays aimed at corners and edges. And hard inputs: equal ones, deep ones, none at all.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/structures/engine.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

constexpr Structure kExact[] = {Structure::none,   Structure::objectSpheres, Structure::objectBoxes,
                                Structure::groups, Structure::sphereTree,    Structure::bvh,
                                Structure::grid};
const char* nameOf(Structure structure) {
    static constexpr const char* names[] = {"none", "object-spheres", "object-boxes", "groups", "sphere-tree",
                                            "bvh",  "grid",           "embree"};
    return names[static_cast<int>(structure)];
}

/// Objects of nine triangles each, as far as they go.
std::vector<std::uint32_t> nines(const Triangles& triangles) {
    std::vector<std::uint32_t> first;
    for (std::uint32_t i = 0; i < triangles.size(); i += 9)
        first.push_back(i);
    return first;
}

struct Built {
    explicit Built(const Triangles& triangles) : first(nines(triangles)) {
        for (const Structure structure : kExact) {
            engines.push_back(makeEngine(structure, {triangles, first}));
            EXPECT_TRUE(engines.back()->advance(Engine::Deadline::max()));
        }
    }
    std::vector<std::uint32_t> first;
    std::vector<std::unique_ptr<Engine>> engines;
};

/// From anywhere to a vertex, to an edge, or to anywhere; along axes; short ones, and ones that begin late.
Ray randomRay(Random& random, const Triangles& triangles, int kind) {
    const Triangle& to = triangles[random() % triangles.size()];
    Ray ray;
    ray.originCentred = triangles[random() % triangles.size()].a + inCube(random, 2);
    dvec3 target = to.b;
    if (kind % 4 == 1) target = 0.5 * to.a + 0.5 * to.b;
    if (kind % 4 >= 2) target = to.a + inCube(random, 1);
    ray.directionCentred = (target - ray.originCentred) * number(random, 0.1, 3);
    if (kind % 12 == 3) aimAlongAxis(ray, to.b, static_cast<int>(random() % 3), kind % 24 == 3);
    limitSome(ray, random, kind);
    return ray;
}

struct Counts {
    std::atomic<long> rays = 0, hits = 0;
    std::array<std::atomic<long>, kStructureCount> differences{};
};

/// `withFlags`: some triangles may not be hit.
void compare(const Triangles& triangles, const Built& built, long rays, unsigned seed, bool withFlags, Counts& counts) {
    std::vector<std::uint8_t> flags(triangles.size());
    for (std::size_t i = 0; i < flags.size(); ++i)
        flags[i] = i % 5 != 0;
    constexpr long kPerPiece = 500;
    parallelFor(static_cast<std::size_t>(rays / kPerPiece), [&](std::size_t piece) {
        Random random(seed * 100'000 + piece);
        for (int i = 0; i < kPerPiece; ++i) {
            const Ray ray = randomRay(random, triangles, i);
            MayHit mayHit;
            if (withFlags) mayHit.flags = flags.data();
            if (withFlags) mayHit.except = static_cast<std::uint32_t>(random() % triangles.size());
            const RayHit expected = closestOfAll(triangles, ray, mayHit);
            counts.hits += bool(expected);
            ++counts.rays;
            // The first is the plain loop again: an eighth of the rays is enough for it.
            for (std::size_t e = i % 8 == 0 ? 0 : 1; e < built.engines.size(); ++e) {
                RayTests tests;
                const RayHit found =
                    i % 2 ? built.engines[e]->closest(ray, mayHit) : built.engines[e]->closest(ray, mayHit, tests);
                const bool any = built.engines[e]->any(ray, mayHit) != kNoPrimitive;
                const bool same = found.primitive == expected.primitive && found.t == expected.t &&
                                  found.barycentric == expected.barycentric && any == bool(expected);
                counts.differences[e] += !same;
            }
        }
    });
}

TEST(StructuresTest, EqualTryingEveryTriangle) {
    const std::pair<const char*, Triangles> meshes[] = {
        {"soup", soup(300, 1, 0.5, 1)},   {"sphere", sphere(3)},
        {"torus", torus(1, 0.4, 20, 10)}, {"fans", fans(2)},
        {"far details", farDetails(3)},   {"degenerate", degenerate(4)}};
    long all = 0;
    unsigned seed = 0;
    for (const auto& [name, triangles] : meshes) {
        const Built built(triangles);
        Counts counts;
        compare(triangles, built, 17'000L * longRun(100), ++seed, false, counts);
        compare(triangles, built, 2'000L * longRun(10), ++seed, true, counts);
        std::cout << name << ": " << triangles.size() << " triangles, " << counts.rays << " rays, " << counts.hits
                  << " hits\n";
        for (std::size_t e = 0; e < std::size(kExact); ++e)
            EXPECT_EQ(counts.differences[e], 0) << name << ", " << nameOf(kExact[e]);
        EXPECT_GT(counts.hits, counts.rays / 20) << name;
        EXPECT_LT(counts.hits, counts.rays) << name;
        all += counts.rays;
    }
    EXPECT_GE(all, 100'000);
}

// Through every vertex and every middle of an edge of a closed mesh, from inside: no ray may slip out, through boxes that fit
// as tightly as boxes can.
TEST(StructuresTest, NoRayLeavesAClosedMesh) {
    const Triangles triangles = sphere(4);
    const Built built(triangles);
    long rays = 0;
    std::array<long, std::size(kExact)> lost{};
    Random random(11);
    for (const Triangle& t : triangles)
        for (const dvec3& target : {t.a, t.b, 0.5 * (t.a + t.b), 0.5 * (t.b + t.c), 0.5 * (t.c + t.a)}) {
            const dvec3 from = rays % 2 ? dvec3(0) : inCube(random, 0.4);
            const Ray ray{from, target - from};
            ++rays;
            for (std::size_t e = 1; e < built.engines.size(); ++e) // the first is tried by the others' test already
                lost[e] += !built.engines[e]->closest(ray) || built.engines[e]->any(ray) == kNoPrimitive;
        }
    EXPECT_EQ(rays, 5 * 2048);
    for (std::size_t e = 1; e < built.engines.size(); ++e)
        EXPECT_EQ(lost[e], 0) << nameOf(kExact[e]);
}

TEST(StructuresTest, OfEquallyNearTrianglesTheFirstIsHit) {
    const Triangles triangles(1000, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    const Built built(triangles);
    const Ray ray{{0, 0, 1}, {0, 0, -1}};
    std::vector<std::uint8_t> late(triangles.size(), 0);
    std::fill(late.begin() + 700, late.end(), 1);
    for (const auto& engine : built.engines) {
        EXPECT_EQ(engine->closest(ray).primitive, 0u);
        EXPECT_EQ(engine->closest(ray).t, 1.0);
        EXPECT_EQ(engine->closest(ray, {.flags = late.data()}).primitive, 700u);
        EXPECT_EQ(engine->closest(ray, {.except = 0}).primitive, 1u);
    }
}

TEST(StructuresTest, HardMeshesAreBuiltAndAnsweredRight) {
    Triangles oneHuge = soup(100'000, 1e-3, 1e-5, 5);
    oneHuge.push_back({{-1e6, 0, -1e6}, {1e6, 0, -1e6}, {0, 0, 1e6}});
    Triangles collinear, doubling;
    for (int i = 0; i < 100'000; ++i)
        collinear.push_back({{i * 1e-3, 0, 0}, {i * 1e-3, 1, 0}, {i * 1e-3, 0, 1}});
    for (int i = 0; i < 20'000; ++i) { // each twice as far as the last
        const double x = std::ldexp(1.0, i % 100);
        doubling.push_back({{x, 0, 0}, {x, x, 0}, {x, 0, x}});
    }
    const std::pair<const char*, Triangles> meshes[] = {
        {"identical", Triangles(100'000, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}})},
        {"one huge, many tiny", oneHuge},
        {"collinear", collinear},
        {"doubling", doubling}};
    unsigned seed = 50;
    for (const auto& [name, triangles] : meshes) {
        const Built built(triangles);
        Random random(++seed);
        int hits = 0;
        for (int i = 0; i < 16; ++i) {
            const Ray ray = randomRay(random, triangles, i);
            const RayHit expected = closestOfAll(triangles, ray, MayHit{});
            hits += bool(expected);
            for (std::size_t e = 1; e < built.engines.size(); ++e) {
                const RayHit found = built.engines[e]->closest(ray);
                EXPECT_EQ(found.primitive, expected.primitive) << name << ", " << nameOf(kExact[e]);
                EXPECT_EQ(found.t, expected.t) << name << ", " << nameOf(kExact[e]);
                EXPECT_LT(built.engines[e]->bytes(), triangles.size() * 400) << name << ", " << nameOf(kExact[e]);
            }
        }
        EXPECT_GT(hits, 2) << name;
    }
}

TEST(StructuresTest, NothingAndNonsenseAreNotHit) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const Ray ray{{0, 0, 1}, {0, 0, -1}};
    const Triangles none;
    for (const auto& engine : Built(none).engines) {
        EXPECT_FALSE(engine->closest(ray));
        EXPECT_EQ(engine->any(ray), kNoPrimitive);
        EXPECT_TRUE(engine->parts(10).size() <= 1); // the empty grid is one cell
    }
    Triangles triangles(10, Triangle{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    triangles.push_back({{-1, -1, 0}, {inf, -1, 0}, {0, 1, 0}});
    for (const auto& engine : Built(triangles).engines)
        EXPECT_FALSE(engine->closest(ray));
    triangles.push_back({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    const Built built(triangles);
    for (std::size_t e = 0; e < built.engines.size(); ++e) {
        const Engine& engine = *built.engines[e];
        EXPECT_EQ(engine.closest(ray).primitive, 11u) << nameOf(kExact[e]);
        for (const double bad : {nan, inf, -inf})
            for (int axis = 0; axis < 3; ++axis) {
                Ray origin = ray, direction = ray;
                origin.originCentred[axis] = bad;
                direction.directionCentred[axis] = bad;
                EXPECT_FALSE(engine.closest(origin));
                EXPECT_EQ(engine.any(direction), kNoPrimitive);
            }
        // Very long and very short directions are still directions; and so is a ray from very far away.
        for (const double length : {1e-200, 1e-30, 1e30, 1e200})
            EXPECT_EQ(engine.closest(Ray{{0, 0, 1}, {0, 0, -length}}).primitive, 11u) << nameOf(kExact[e]) << length;
        for (const double far : {1e6, 1e12, 1e18})
            EXPECT_EQ(engine.closest(Ray{{0, 0, far}, {0, 0, -1}}).primitive, 11u) << nameOf(kExact[e]) << far;
    }
}

TEST(StructuresTest, BuiltInSlicesTheyAreTheSame) {
    const Triangles triangles = torus(1, 0.4, 128, 64);
    const Built whole(triangles);
    for (std::size_t e = 0; e < std::size(kExact); ++e) {
        const auto sliced = makeEngine(kExact[e], {triangles, whole.first});
        int slices = 1;
        while (!sliced->advance(Engine::Deadline::min())) {
            ++slices;
            EXPECT_LT(sliced->done(), 1.0);
        }
        EXPECT_EQ(sliced->done(), 1.0);
        const bool isLong =
            kExact[e] == Structure::sphereTree || kExact[e] == Structure::bvh || kExact[e] == Structure::grid;
        EXPECT_TRUE(!isLong || slices > 5) << nameOf(kExact[e]);
        EXPECT_EQ(sliced->bytes(), whole.engines[e]->bytes());
        Random random(3);
        for (int i = 0; i < 300; ++i) {
            const Ray ray = randomRay(random, triangles, i);
            RayTests a, b;
            EXPECT_EQ(sliced->closest(ray, {}, a).t, whole.engines[e]->closest(ray, {}, b).t);
            EXPECT_EQ(a.all(), b.all()) << nameOf(kExact[e]);
        }
    }
}

// What a structure is for: fewer tests. And what is counted is what is tried.
TEST(StructuresTest, TryLessThanEverything) {
    const Triangles triangles = torus(1, 0.4, 64, 32);
    const Built built(triangles);
    std::array<RayTests, std::size(kExact)> sums{};
    Random random(4);
    constexpr int kRays = 1000;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray = randomRay(random, triangles, 4 * i + 2);
        for (std::size_t e = 0; e < built.engines.size(); ++e) {
            (void)built.engines[e]->closest(ray, {}, sums[e]);
            (void)built.engines[e]->any(ray, {}, sums[e]);
        }
    }
    const auto all = static_cast<std::uint64_t>(kRays) * triangles.size();
    EXPECT_GE(sums[0].triangles, all);
    EXPECT_LE(sums[0].triangles, 2 * all);
    for (std::size_t e = 0; e < built.engines.size(); ++e) {
        std::cout << nameOf(kExact[e]) << ": per ray " << double(sums[e].volumes) / (2 * kRays) << " volumes, "
                  << double(sums[e].triangles) / (2 * kRays) << " triangles, " << double(sums[e].steps) / (2 * kRays)
                  << " steps\n";
        const std::uint64_t share = kExact[e] >= Structure::sphereTree ? 20 : e > 0 ? 3 : 1;
        EXPECT_LE(sums[e].all(), sums[0].all() / share) << nameOf(kExact[e]);
    }
}

TEST(StructuresTest, PartsHoldAllTriangles) {
    const Triangles triangles = torus(1, 0.4, 32, 16); // each triangle of which shares its cells with two others
    const Built built(triangles);
    for (std::size_t e = 1; e < built.engines.size(); ++e) {
        const auto parts = built.engines[e]->parts(1000);
        ASSERT_FALSE(parts.empty()) << nameOf(kExact[e]);
        int deepest = 0;
        for (const StructurePart& part : parts)
            deepest = std::max(deepest, part.level);
        EXPECT_LE(built.engines[e]->parts(100).size(), 100u * static_cast<std::size_t>(deepest + 1));
        for (int level = 0; level <= std::min(deepest, 2); ++level)
            for (const Triangle& t : triangles) {
                bool held = false;
                for (const StructurePart& part : parts) {
                    const dvec3 lower = glm::min(t.a, glm::min(t.b, t.c)), upper = glm::max(t.a, glm::max(t.b, t.c));
                    held |= part.level == level &&
                            (part.isBall ? glm::distance(t.a, part.centreCentred) <= part.radius
                                         : glm::all(glm::lessThanEqual(part.lowerCentred, upper)) &&
                                               glm::all(glm::lessThanEqual(lower, part.upperCentred)));
                }
                EXPECT_TRUE(held) << nameOf(kExact[e]) << ", level " << level;
            }
    }
}

} // namespace
} // namespace shadowlab::trace
