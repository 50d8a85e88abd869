// Points at which rounding decides: in the shadow of an edge, behind a triangle seen edge-on, in contact. Each handful of
// them is asked alone, so that nothing farther away makes its bucket, and what float may get wrong in it, larger than it need
// be.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/shadow_map/irregular/alias_free.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

using namespace shadowlab::testing;
using trace::SceneTracer;
using trace::SurfacePoint;
using trace::Visibility;

struct Counts {
    long shadowed = 0, lit = 0, different = 0, mixed = 0; ///< mixed: handfuls with both answers
};

void compare(const SceneTracer& tracer, std::span<const SurfacePoint> points, Counts& counts) {
    for (int light = 0; light < static_cast<int>(tracer.scene().lights.size()); ++light) {
        std::vector<Visibility> answers(points.size());
        aliasFreeVisibilities(tracer, points, light, answers);
        long shadowed = 0, lit = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Visibility expected = tracer.visibility(points[i], light);
            counts.different += answers[i] != expected;
            shadowed += expected == Visibility::shadowed;
            lit += expected == Visibility::lit;
        }
        counts.shadowed += shadowed;
        counts.lit += lit;
        counts.mixed += shadowed > 0 && lit > 0;
    }
}

/// Some points on a triangle, or just outside it, about where the line from `from` through `through` meets its plane: up to
/// `spread` away, in shares of its edges.
std::vector<SurfacePoint> behind(const SceneTracer& tracer, std::uint32_t primitive, const dvec3& fromCentred,
                                 const dvec3& throughCentred, double spread, Random& random) {
    const trace::Triangle& t = tracer.world().triangles[primitive];
    const dvec3 along = throughCentred - fromCentred, toA = t.a - t.c, toB = t.b - t.c, normal = glm::cross(toA, toB);
    const double share = glm::dot(normal, t.c - fromCentred) / glm::dot(normal, along);
    const dvec3 at = fromCentred + share * along - t.c;
    const double area = glm::dot(normal, normal);
    const dvec2 weights(glm::dot(glm::cross(at, toB), normal) / area, glm::dot(glm::cross(toA, at), normal) / area);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 9; ++i) {
        const dvec2 aside = i == 0 ? dvec2(0.0) : spread * dvec2(number(random, -1, 1), number(random, -1, 1));
        points.push_back({primitive, glm::dot(normal, fromCentred - t.c) > 0, weights + aside});
    }
    return points;
}

/// A triangle somewhere above the floor. The light is in its plane, or nearly, or not at all; of a fourth of them as far as
/// double can tell, and they reach behind the light. Another fourth does, too, but what a ray through the light hits of those
/// is behind it, and they pass before it at a distance.
std::array<dvec3, 3> cornersAbout(const dvec3& light, bool sun, int kind, Random& random) {
    const bool inPlane = kind % 4 < 2;
    const dvec3 aside = std::pow(10.0, inPlane ? number(random, -17, -14) : number(random, -16, 0)) * onSphere(random);
    if (kind % 4 == 1 && !sun) {
        const dvec3 up = glm::normalize(onSphere(random) + dvec3(0, 1.5, 0));
        const dvec3 across = glm::normalize(glm::cross(up, onSphere(random)));
        const auto at = [&](double along, double beside) { return light + along * up + beside * across; };
        return {at(-number(random, 0.1, 1.5), number(random, 1, 5)), at(number(random, 0.5, 2), -number(random, 0, 1)),
                at(number(random, 0.5, 2), number(random, 0, 1)) + aside};
    }
    const dvec3 a = inCube(random, 1) + dvec3(0, 1.1, 0), b = a + number(random, 0.01, 1) * onSphere(random);
    const double along = kind % 4 == 0 ? number(random, 1, 2) : number(random, -0.5, 1.5);
    return {a, b, a + along * (sun ? light : light - a) + number(random, -1, 1) * (b - a) + aside};
}

// The shadow of every kind of place on a triangle: within, on an edge, in a corner; the triangle seen from its side as well as
// edge-on, down to a plane that misses the light by an atom's width.
TEST(AliasFreeTies, BehindEdgesAndEdgeOnTriangles) {
    Counts sum;
    const auto tryCase = [&](int i) {
        Random random(static_cast<unsigned>(i));
        const dvec3 light(number(random, -1, 1), number(random, 2, 4), number(random, -1, 1));
        scene::Scene scene = floorScene();
        const bool sun = i % 3 == 0;
        scene.lights = {sun ? directionalLight(-light) : pointLight(light)};
        const auto [a, b, c] = cornersAbout(light, sun, i, random);
        // A mesh is in float: corners in double come from where objects are, each mesh a triangle and a stretched one at that.
        dmat4 worldFromMesh(1.0);
        worldFromMesh[0] = dvec4(b - a, 0);
        worldFromMesh[1] = dvec4(c - a, 0);
        worldFromMesh[2] = dvec4(glm::normalize(glm::cross(b - a, c - a)), 0);
        worldFromMesh[3] = dvec4(a, 1);
        addObject(scene, triangleSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), worldFromMesh);
        SceneTracer tracer;
        tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
        const dvec3 lightCentred = light - tracer.world().originWorld;
        const double p = number(random, 0, 1), q = number(random, 0, 1) * (1 - p);
        const dvec2 places[] = {{p, q}, {p, 0}, {0, p}, {p, 1 - p}, {1, 0}, {0, 1}, {0, 0}};
        const dvec2 place = places[static_cast<std::size_t>(i) % std::size(places)];
        const trace::Triangle& caster = tracer.world().triangles.back();
        const dvec3 through = caster.a + place.x * (caster.b - caster.a) + place.y * (caster.c - caster.a);
        const double spread = std::pow(10.0, number(random, -17, -6));
        compare(tracer,
                behind(tracer, static_cast<std::uint32_t>(i % 2), sun ? through + light : lightCentred, through, spread,
                       random),
                sum);
    };
    for (int i = 0; i < longRun(40) * 6000; ++i)
        tryCase(i);
    // Found among a million: all of the triangle is behind the light, and a ray still says that it is hit.
    for (const int i : {101705, 126253, 128969, 132637, 166313})
        tryCase(i);
    EXPECT_EQ(sum.different, 0);
    EXPECT_GT(sum.shadowed, 3000);
    EXPECT_GT(sum.lit, 3000);
    EXPECT_GT(sum.mixed, 500);
}

// Sheets one above the other, from touching to apart: what is contact toward the sun depends on how large coordinates are,
// down to a picometre, and so does what double can tell.
TEST(AliasFreeTies, ContactTowardTheSunAndALamp) {
    Counts sum;
    Random random(22);
    for (const double size : {1000.0, 1e-3})
        for (const double gap :
             {0.0, 1e-14, 1e-13, 9e-13, 1.1e-12, 1e-11, 1e-10, 2e-10, 5e-10, 1e-9, 2e-9, 1e-8, 1e-6}) {
            scene::Scene scene = floorScene();
            scene.objects.clear();
            addObject(scene, scene::makeQuad({size, size}));
            addObject(scene, scene::makeQuad({1.5 * size, 1.5 * size}), translation({0, gap, 0}));
            for (const double height : {-1e-3, 1e-3}) // the middle of the scene is on the floor
                addObject(scene, scene::makeQuad(dvec2(1e-3 * size)), translation({0, height * size, 0}));
            scene.lights = {directionalLight({0, -1, 0}), directionalLight({0.3, -1, 0.2}),
                            pointLight({0, 0.01 * size, 0}), pointLight(size * dvec3(0.1, 0.02, 0.003))};
            SceneTracer tracer;
            tracer.advance(snapshot(scene), std::chrono::steady_clock::time_point::max());
            for (int i = 0; i < 200; ++i) {
                const dvec3 from = size * (dvec3(0, 1, 0) + 0.1 * inCube(random, 1));
                compare(tracer,
                        behind(tracer, static_cast<std::uint32_t>(i % 2), from, 0.7 * size * inCube(random, 1),
                               std::pow(10.0, number(random, -9, -2)), random),
                        sum);
            }
        }
    EXPECT_EQ(sum.different, 0);
    EXPECT_GT(sum.shadowed, 3000);
    EXPECT_GT(sum.lit, 3000);
}

} // namespace
} // namespace shadowlab::shadow_map
