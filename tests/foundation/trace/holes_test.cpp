// Rays through holes: by a formula, by the judge, by the tracer, and by trying every triangle with arithmetic of its own.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/trace/world_triangles.h"

#include <random>

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

SceneTracer tracerOf(const scene::Snapshot& snapshot) {
    SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    return tracer;
}

// A sheet of 4 m x 4 m lies 1 m over the floor, the sun stands right above: the floor shows the image, upright for who looks
// down with -z up. The camera looks on from between the two.
TEST(Holes, TheShadowOfASheetIsItsImage) {
    const Pattern pattern = {"##..#", "#.#..", ".####", "#...."};
    scene::Scene scene = floorScene();
    addObject(scene, scene::makeQuad({4, 4}), translation({0, 1, 0}));
    perforate(scene, 1, pattern);
    scene.lights.push_back(directionalLight({0, -1, 0}));
    scene.camera.positionWorld = {0.1, 0.9, 3.9};
    scene.camera.targetWorld = {0, 0, 0.5};
    const auto snapshot = testing::snapshot(scene);
    const ExactVisibility judge(snapshot);
    const SceneTracer tracer = tracerOf(snapshot);
    const ivec2 size{161, 121};
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    int lit = 0, shadowed = 0, beside = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const dvec2 pixel = dvec2(x, y) + 0.5;
            const auto hit = judge.eyeHit(scene.camera, pixel, size);
            if (!hit || hit->object != 0) continue;
            const dvec2 image((hit->positionWorld.x + 2) / 4 * 5,
                              (hit->positionWorld.z + 2) / 4 * 4); // from its upper left
            const bool under = image.x > 0 && image.y > 0 && image.x < 5 && image.y < 4;
            const bool solid =
                under && pattern[static_cast<std::size_t>(image.y)][static_cast<std::size_t>(image.x)] == '#';
            const Visibility expected = solid ? Visibility::shadowed : Visibility::lit;
            EXPECT_EQ(judge.visibility(*hit, scene.camera, 0), expected) << image.x << ", " << image.y;
            EXPECT_EQ(tracer.visibility(tracer.eyePoint(rays, pixel), 0), expected) << image.x << ", " << image.y;
            ++(!under ? beside : solid ? shadowed : lit);
        }
    EXPECT_GT(lit, 1000);
    EXPECT_GT(shadowed, 1000);
    EXPECT_GT(beside, 1000);
}

/// A scene asked by brute force: planes, areas and texels, written down once more.
class BruteForce {
public:
    explicit BruteForce(const scene::Scene& scene) : scene_(scene) {}

    struct Hit {
        double t = std::numeric_limits<double>::infinity();
        std::uint32_t object = kNoPrimitive, triangle = kNoPrimitive;
    };
    /// The nearest hit of a ray, but for one triangle; holes are passed unless it is said that they are not.
    [[nodiscard]] Hit nearest(const dvec3& origin, const dvec3& direction, double from, const Hit& except,
                              bool throughHoles) const {
        Hit best;
        for (std::uint32_t o = 0; o < scene_.objects.size(); ++o) {
            const scene::Object& object = scene_.objects[o];
            const scene::AlphaMask* mask = scene_.materials[object.partMaterials[0]].alphaMask.get();
            for (std::uint32_t t = 0; t < object.mesh->triangles.size(); ++t) {
                if (o == except.object && t == except.triangle) continue;
                const uvec3 corners = object.mesh->triangles[t];
                const auto place = [&](std::uint32_t v) {
                    return dvec3(object.worldFromObject * dvec4(dvec3(object.mesh->positionsMesh[v]), 1));
                };
                const dvec3 a = place(corners.x), ab = place(corners.y) - a, ac = place(corners.z) - a;
                // Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
                const dvec3 across = glm::cross(direction, ac);
                const double determinant = glm::dot(ab, across);
                const dvec3 fromA = origin - a, turned = glm::cross(fromA, ab);
                const double b = glm::dot(fromA, across) / determinant, c = glm::dot(direction, turned) / determinant;
                const double distance = glm::dot(ac, turned) / determinant;
                if (!(b >= 0 && c >= 0 && b + c <= 1 && distance > from && distance < best.t)) continue;
                if (mask && throughHoles && isHole(*mask, *object.mesh, corners, {1 - b - c, b, c})) continue;
                best = {distance, o, t};
            }
        }
        return best;
    }

private:
    static bool isHole(const scene::AlphaMask& mask, const scene::Mesh& mesh, const uvec3& corners,
                       const dvec3& weights) {
        dvec2 uv(0.0);
        for (int i = 0; i < 3; ++i)
            uv += weights[i] * dvec2(mesh.texcoords[corners[i]]);
        const ivec2 texel = ivec2(glm::floor((uv - glm::floor(uv)) * dvec2(mask.size())));
        return mask.texels()[static_cast<std::size_t>(texel.y * mask.size().x + texel.x)] == 0;
    }

    const scene::Scene& scene_;
};

TEST(Holes, JudgeTracerAndBruteForceAgreeOnRandomRays) {
    const scene::Scene scene = perforatedScene();
    const auto snapshot = testing::snapshot(scene);
    const ExactVisibility judge(snapshot);
    const SceneTracer tracer = tracerOf(snapshot);
    const BruteForce brute(scene);
    const ivec2 size{100, 75};
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(0, size.x), down(0, size.y);
    int lit = 0, shadowed = 0, eyeThrough = 0, lightThrough = 0, background = 0;
    for (int i = 0; i < 3000; ++i) {
        const dvec2 pixel(across(random), down(random));
        const auto judged = judge.eyeHit(scene.camera, pixel, size);
        const SurfacePoint traced = tracer.eyePoint(rays, pixel);
        const dvec3 direction = scene::rayDirectionWorld(scene.camera, pixel, size), eye = scene.camera.positionWorld;
        const BruteForce::Hit hit = brute.nearest(eye, direction, scene.camera.near, {}, true);
        ASSERT_EQ(bool(judged), bool(traced));
        ASSERT_EQ(bool(judged), hit.object != kNoPrimitive);
        const BruteForce::Hit whole = brute.nearest(eye, direction, scene.camera.near, {}, false);
        eyeThrough += whole.t < hit.t;
        background += !judged;
        if (!judged) continue;
        const std::uint32_t primitive = tracer.world().firstOfObject[hit.object] + hit.triangle;
        ASSERT_EQ(traced.primitive, primitive);
        ASSERT_EQ(tracer.world().firstOfObject[judged->object] + judged->triangle, primitive);
        for (int light = 0; light < 2; ++light) {
            const Visibility answer = judge.visibility(*judged, scene.camera, light);
            ASSERT_EQ(tracer.visibility(traced, light), answer);
            if (answer == Visibility::turnedAway) continue;
            const scene::Light& source = scene.light(light);
            const bool sun = source.type == scene::LightType::directional;
            const dvec3 toLight = sun ? -source.directionWorld : source.positionWorld - judged->positionWorld;
            const double end = sun ? std::numeric_limits<double>::infinity() : 1.0;
            const auto blocked = [&](bool throughHoles) {
                return brute.nearest(judged->positionWorld, toLight, 1e-9, hit, throughHoles).t < end;
            };
            EXPECT_EQ(answer, blocked(true) ? Visibility::shadowed : Visibility::lit) << pixel.x << ", " << pixel.y;
            lightThrough += blocked(true) != blocked(false);
            ++(answer == Visibility::lit ? lit : shadowed);
        }
    }
    EXPECT_GT(lit, 500);
    EXPECT_GT(shadowed, 300);
    EXPECT_GT(eyeThrough, 300);
    EXPECT_GT(lightThrough, 100);
    EXPECT_GT(background, 100);
}

// A technique whose shadows know nothing of holes asks a tracer that does not, either; what the eye sees stays the same.
TEST(Holes, CastersThatAreWholeAreSeenThroughAllTheSame) {
    const scene::Scene scene = perforatedScene();
    const auto snapshot = testing::snapshot(scene);
    scene::Scene solid = scene;
    for (scene::Object& object : solid.objects)
        object.partMaterials[0] = 0;
    const SceneTracer tracer = tracerOf(snapshot), solidTracer = tracerOf(testing::snapshot(solid));
    SceneTracer whole;
    whole.castWhole();
    whole.advance(snapshot, std::chrono::steady_clock::time_point::max());
    const ivec2 size{80, 60};
    const EyeRays rays = tracer.eyeRays(scene.camera, size);
    std::vector<SurfacePoint> points(80 * 60), same(points.size());
    tracer.eyePoints(rays, {0, 0}, size, dvec2(0.5), points);
    whole.eyePoints(rays, {0, 0}, size, dvec2(0.5), same);
    int darker = 0;
    std::vector<Visibility> answers(points.size()), wholeAnswers(points.size()), solidAnswers(points.size());
    for (int light = 0; light < 2; ++light) {
        tracer.visibilities(points, light, answers);
        whole.visibilities(points, light, wholeAnswers);
        solidTracer.visibilities(points, light, solidAnswers);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(points[i].primitive, same[i].primitive);
            EXPECT_EQ(wholeAnswers[i], solidAnswers[i]);
            EXPECT_EQ(wholeAnswers[i], whole.visibility(points[i], light));
            darker += answers[i] == Visibility::lit && wholeAnswers[i] == Visibility::shadowed;
        }
    }
    EXPECT_GT(darker, 200);
}

// What is traced through is shared by tracers of one geometry; where the holes are is not.
TEST(Holes, ComeAndGoWithTheMaterialAlone) {
    scene::Scene scene = perforatedScene();
    const auto perforated = testing::snapshot(scene);
    scene.materials[1].alphaMask = maskOf({"#"});
    scene.revisions.materials = scene::newRevision();
    const auto filled = testing::snapshot(scene);
    SceneTracer tracer = tracerOf(perforated);
    const ivec2 size{80, 60};
    const auto hitsOnFence = [&] {
        const EyeRays rays = tracer.eyeRays(scene.camera, size);
        int hits = 0;
        for (int i = 0; i < size.x * size.y; ++i)
            if (const SurfacePoint point = tracer.eyePoint(rays, dvec2(i % size.x, i / size.x) + 0.5))
                hits += tracer.world().objects[point.primitive] == 1;
        return hits;
    };
    const int before = hitsOnFence();
    tracer.advance(filled, std::chrono::steady_clock::time_point::max());
    const int after = hitsOnFence();
    EXPECT_GT(before, 100);
    EXPECT_GT(after, before * 5 / 4);
    tracer.advance(perforated, std::chrono::steady_clock::time_point::max());
    EXPECT_EQ(hitsOnFence(), before);
}

} // namespace
} // namespace shadowlab::trace
