// Faces that coincide: every pixel shows the one that the rule names (scene/query/coincident/coincident_faces.h), for the rasteriser, for
// rays and for the exact judge, held against the plane's own equation.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/scene/id_buffer.h"
#include "techniques/foundation/gl/scene/seen_runs.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/support/area_lights.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using CoincidentFacesTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};
constexpr dvec2 kFloor{2, 2}, kDecal{0.5, 0.4}; // half sizes
constexpr dvec2 kDecalMiddle{0.2, 0.1};

/// A rectangle in the plane y = 0 of a turned space, its front up or down, its diagonal one way or the other.
std::vector<dvec3> rectangle(const dvec2& middle, const dvec2& half, bool facesUp, bool otherDiagonal) {
    const auto at = [&](double x, double z) { return dvec3(middle.x + x * half.x, 0, middle.y + z * half.y); };
    std::array<dvec3, 4> c{at(-1, -1), at(-1, 1), at(1, 1), at(1, -1)}; // counter-clockwise from above
    if (!facesUp) std::swap(c[1], c[3]);
    if (otherDiagonal) std::ranges::rotate(c, c.begin() + 1);
    return {c[0], c[1], c[2], c[0], c[2], c[3]};
}

struct Case {
    bool decalIsLater = true, decalFacesUp = true, otherDiagonal = false, isWhole = false;
    bool inFile = false; ///< the corners are turned, then written with six decimals, so that the planes differ; else the objects are turned
};

void add(scene::Scene& scene, const dmat4& turn, const std::vector<dvec3>& corners, bool inFile) {
    std::vector<dvec3> placed = corners;
    if (inFile)
        for (dvec3& corner : placed)
            corner = glm::round(transformPoint(turn, corner) * 1e6) / 1e6;
    testing::addObject(scene, testing::triangleSoup(placed), inFile ? dmat4(1) : turn);
}

scene::Scene sceneOf(const Case& one, const dmat4& turn) {
    scene::Scene scene;
    scene.materials.emplace_back();
    const auto floor = [&] { add(scene, turn, rectangle({0, 0}, kFloor, true, false), one.inFile); };
    const auto decal = [&] {
        const dvec2 half = one.isWhole ? kFloor : kDecal, middle = one.isWhole ? dvec2(0) : kDecalMiddle;
        add(scene, turn, rectangle(middle, half, one.decalFacesUp, one.otherDiagonal), one.inFile);
    };
    if (one.decalIsLater) {
        floor();
        decal();
    } else {
        decal();
        floor();
    }
    return scene;
}

/// The place in the plane that the pixel shows, if it shows any.
std::optional<dvec2> placeOf(const scene::Camera& camera, const dmat4& planeFromWorld, const dvec2& pixel) {
    const dvec3 from = transformPoint(planeFromWorld, camera.positionWorld);
    const dvec3 way = transformDirection(planeFromWorld, scene::rayDirectionWorld(camera, pixel, kSize));
    const double t = -from.y / way.y;
    if (!(t > 0)) return std::nullopt;
    return dvec2(from.x + t * way.x, from.z + t * way.z);
}

bool isIn(const std::optional<dvec2>& place, const dvec2& middle, const dvec2& half) {
    return place && glm::all(glm::lessThan(glm::abs(*place - middle), half));
}

/// The object that the pixel shows by the rule; -1: none. Nothing within a hundredth of a pixel of an edge.
std::optional<int> expected(const Case& one, const scene::Camera& camera, const dmat4& planeFromWorld, int x, int y) {
    const auto at = [&](const dvec2& pixel) {
        const auto place = placeOf(camera, planeFromWorld, pixel);
        if (!isIn(place, {0, 0}, kFloor)) return -1;
        const int floor = one.decalIsLater ? 0 : 1, decal = 1 - floor;
        if (!one.isWhole && !isIn(place, kDecalMiddle, kDecal)) return floor;
        const bool fromAbove = transformPoint(planeFromWorld, camera.positionWorld).y > 0;
        const bool floorFaces = fromAbove, decalFaces = fromAbove == one.decalFacesUp;
        if (floorFaces != decalFaces) return floorFaces ? floor : decal;
        return 1; // of two alike the later
    };
    const dvec2 centre = dvec2(x, y) + 0.5;
    const int answer = at(centre);
    for (const dvec2& off : {dvec2(0.01, 0), dvec2(-0.01, 0), dvec2(0, 0.01), dvec2(0, -0.01)})
        if (at(centre + off) != answer) return std::nullopt;
    return answer;
}

struct Eye {
    dvec3 position; ///< in the space of the plane
    double fovYDegrees;
};

/// Straight down, aslant, at a grazing angle, near and far; from below as well. The far ones look through a long lens.
std::vector<Eye> eyes() {
    std::vector<Eye> eyes{{{0.3, 2, 0.1}, 60}, {{2, 2, 1}, 40}, {{0.4, 0.3, 0.2}, 60}, {{5, 0.4, 3}, 30},
                          {{9, 0.08, 2}, 2},   {{30, 20, 11}, 4}, {{0.02, 40, 0.03}, 5}, {{3000, 1500, 900}, 0.05}};
    for (std::size_t i = eyes.size(); i-- > 0;)
        eyes.push_back({eyes[i].position * dvec3(1, -1, 1), eyes[i].fovYDegrees});
    return eyes;
}

struct Counts {
    int compared = 0, ofDecal = 0, wrongOnCard = 0, wrongRays = 0, wrongJudge = 0, wrongNaively = 0;
};

/// What each pixel shows, by triangle numbers: two triangles to an object.
int objectOf(std::uint32_t triangle) { return triangle < 2 ? 0 : triangle < 4 ? 1 : -1; }

/// The rasteriser without the rule: all triangles as they are, the nearest wins.
std::vector<std::uint32_t> drawnNaively(const scene::Scene& scene, const gl::SceneBuffers& buffers) {
    const gl::Program program("position.vert", "triangle_id.frag");
    gl::Texture2D ids(GL_R32UI, kSize, "ids"), depth(GL_DEPTH24_STENCIL8, kSize, "depth");
    const gl::Framebuffer framebuffer(&ids, &depth, "ids");
    gl::setBaselineState();
    framebuffer.bind();
    const GLuint none[4] = {~0u, ~0u, ~0u, ~0u};
    glClearBufferuiv(GL_COLOR, 0, none);
    glClear(GL_DEPTH_BUFFER_BIT);
    program.use();
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        program.set("clipFromMesh", mat4(gl::eyeMatrices(scene.camera, kSize).clipFromMesh(scene.objects[o])));
        program.set("triangleBase", buffers.triangleBase(o));
        buffers.mesh(o).drawNumbered(0, static_cast<std::uint32_t>(scene.objects[o].mesh->triangles.size()));
    }
    std::vector<std::uint32_t> read(static_cast<std::size_t>(kSize.x * kSize.y)), result(read.size());
    glReadPixels(0, 0, kSize.x, kSize.y, GL_RED_INTEGER, GL_UNSIGNED_INT, read.data());
    for (int y = 0; y < kSize.y; ++y)
        std::copy_n(&read[static_cast<std::size_t>((kSize.y - 1 - y) * kSize.x)], kSize.x, &result[static_cast<std::size_t>(y * kSize.x)]);
    return result;
}

Counts compared(const Case& one, const dmat4& turn, const Eye& eye) {
    scene::Scene scene = sceneOf(one, turn);
    scene.camera.positionWorld = transformPoint(turn, eye.position);
    scene.camera.targetWorld = transformPoint(turn, dvec3(kDecalMiddle.x, 0, kDecalMiddle.y));
    scene.camera.upWorld = transformDirection(turn, dvec3(0.3, 0.1, 1));
    scene.camera.fovYDegrees = eye.fovYDegrees;
    const auto snapshot = testing::snapshot(scene);
    gl::SceneBuffers buffers;
    buffers.update(snapshot);
    gl::IdBuffer idBuffer;
    idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, kSize), kSize);
    const std::vector<std::uint32_t> ids = idBuffer.read(), naive = drawnNaively(scene, buffers);
    const trace::SceneTracer tracer = testing::tracerOf(snapshot);
    const trace::ExactVisibility judge(snapshot);
    std::vector<trace::SurfacePoint> points(ids.size());
    tracer.eyePoints(tracer.eyeRays(scene.camera, kSize), {0, 0}, kSize, dvec2(0.5), points);
    Counts counts;
    const dmat4 planeFromWorld = glm::inverse(turn);
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const auto object = expected(one, scene.camera, planeFromWorld, x, y);
            if (!object) continue;
            const auto i = static_cast<std::size_t>(y * kSize.x + x);
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize);
            ++counts.compared;
            counts.ofDecal += *object == (one.decalIsLater ? 1 : 0);
            counts.wrongOnCard += objectOf(ids[i]) != *object;
            counts.wrongNaively += objectOf(naive[i]) != *object;
            counts.wrongRays += objectOf(points[i].primitive) != *object;
            counts.wrongJudge += (hit ? static_cast<int>(hit->object) : -1) != *object;
        }
    return counts;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const bool inFile : {false, true})
        for (const bool later : {false, true})
            for (const bool up : {false, true})
                for (const auto& [whole, diagonal] : {std::pair(false, false), std::pair(true, false), std::pair(true, true)})
                    all.push_back({later, up, diagonal, whole, inFile});
    return all;
}

std::string nameOf(const Case& one) {
    return std::string(one.decalIsLater ? "floor, then " : "before the floor ") + (one.isWhole ? "as large a face" : "a decal") +
           (one.decalFacesUp ? "" : ", turned over") + (one.otherDiagonal ? ", cut otherwise" : "") +
           (one.inFile ? ", planes apart by rounding" : "");
}

TEST_F(CoincidentFacesTest, OneOfThemIsSeenInEveryPixelFromAnywhere) {
    const dmat4 tilt = glm::rotate(glm::rotate(dmat4(1), 0.6, dvec3(1, 0, 0)), 0.4, dvec3(0, 1, 0.3));
    const std::vector<dmat4> places{dmat4(1), testing::translation({1.3, -7.7, 5.9}) * tilt, testing::translation({1e5, -3e4, 2e5}) * tilt};
    int pictures = 0, withDecal = 0, wrongNaively = 0;
    for (const Case& one : cases())
        for (std::size_t place = 0; place < places.size(); ++place) {
            if (one.inFile && place == 2) continue; // a file would have its own origin there
            for (const Eye& eye : eyes()) {
                const Counts counts = compared(one, places[place], eye);
                const auto where = [&] {
                    return nameOf(one) + " place " + std::to_string(place) + " eye " + std::to_string(eye.position.x) + " " +
                           std::to_string(eye.position.y);
                };
                EXPECT_GT(counts.compared, kSize.x * kSize.y / 2) << where();
                EXPECT_EQ(counts.wrongOnCard, 0) << where();
                EXPECT_EQ(counts.wrongRays, 0) << where();
                EXPECT_EQ(counts.wrongJudge, 0) << where();
                wrongNaively += counts.wrongNaively;
                withDecal += counts.ofDecal > 30;
                ++pictures;
            }
        }
    EXPECT_EQ(pictures, (12 * 3 + 12 * 2) * 16);
    EXPECT_GT(withDecal, pictures / 3);
    EXPECT_GT(wrongNaively, 100000) << "without the rule the pictures should be wrong: in that many pixels of eighteen million";
}

/// A house with a gable whose modeller wrote every face twice, once for each side; the inner skin may come first.
scene::Scene houseWrittenTwice(bool innerFirst) {
    const std::vector<dvec3> v{{-1, 0, 1},   {1, 0, 1},     {1, 0, -1},   {-1, 0, -1},  {-1, 1.5, 1},
                               {1, 1.5, 1},  {1, 1.5, -1},  {-1, 1.5, -1}, {0, 2.4, 1}, {0, 2.4, -1}};
    const std::vector<std::array<int, 3>> faces{{3, 2, 1}, {3, 1, 0}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6},
                                                {3, 0, 4}, {3, 4, 7}, {4, 5, 8}, {6, 7, 9}, {5, 6, 9}, {5, 9, 8}, {7, 4, 8}, {7, 8, 9}};
    std::vector<dvec3> outer, inner;
    for (const auto& [a, b, c] : faces)
        for (const int corner : {a, b, c})
            outer.push_back(v[static_cast<std::size_t>(corner)]);
    for (std::size_t t = 0; t < outer.size(); t += 3)
        inner.insert(inner.end(), {outer[t + 2], outer[t + 1], outer[t]});
    scene::Scene scene;
    scene.materials.emplace_back();
    std::vector<dvec3> both = innerFirst ? inner : outer;
    both.insert(both.end(), (innerFirst ? outer : inner).begin(), (innerFirst ? outer : inner).end());
    testing::addObject(scene, testing::triangleSoup(both));
    return scene;
}

// A software renderer compiles a program for each pair of offsets. Bounds: what planes need that rounding has moved apart by a tenth of a
// millimetre, which goes over 5.4 octaves in units and 3.6 in slopes between 1 and 100 m; two steps an octave, one more for the rest of one.
TEST_F(CoincidentFacesTest, LayersHaveFewOffsetsWhereverTheEyeIs) {
    constexpr double kGap = 1e-4;
    constexpr int kDistances = 2000;
    const dmat4 clipFromView = scene::clipFromView(scene::Camera{}, 4.0 / 3);
    glViewport(0, 0, 960, 720);
    std::set<std::pair<float, float>> steps;
    for (int i = 0; i < kDistances; ++i) {
        const double nearest = std::pow(100.0, static_cast<double>(i) / (kDistances - 1));
        const gl::LayerStep step = gl::layerStep(kGap, nearest, clipFromView);
        EXPECT_GE(step.units, 2 * kGap * std::abs(clipFromView[3][2]) / (2 * nearest * nearest) * (1 << 24)) << nearest;
        EXPECT_GE(step.slopes, 2 * kGap / nearest * clipFromView[1][1] * 360) << nearest;
        steps.emplace(step.slopes, step.units);
    }
    EXPECT_LE(steps.size(), 12u + 9u);
    EXPECT_GE(steps.size(), 6u); // and they do follow the distance
}

TEST_F(CoincidentFacesTest, OfAHouseWrittenTwiceTheInsideIsSeenFromWithinAlone) {
    constexpr int kEyes = 40;
    int inside = 0, outside = 0, naively = 0, fromWithin = 0, wrongFromWithin = 0;
    for (const bool innerFirst : {false, true}) {
        scene::Scene scene = houseWrittenTwice(innerFirst);
        gl::SceneBuffers buffers;
        buffers.update(testing::snapshot(scene));
        const auto isInner = [&](std::uint32_t id) { return id != gl::IdBuffer::kNone && (id < 16) == innerFirst; };
        const auto look = [&](const dvec3& eye, const dvec3& target) {
            scene.camera.positionWorld = eye;
            scene.camera.targetWorld = target;
            gl::IdBuffer idBuffer;
            idBuffer.draw(scene, buffers, gl::eyeMatrices(scene.camera, kSize), kSize);
            return idBuffer.read();
        };
        for (int i = 0; i < kEyes; ++i) {
            const double turn = 0.37 + i * 0.61;
            for (const std::uint32_t id : look({5 * std::cos(turn), 0.3 + 0.1 * i, 5 * std::sin(turn)}, {0.1, 1, 0})) {
                inside += isInner(id);
                outside += id != gl::IdBuffer::kNone && !isInner(id);
            }
            for (const std::uint32_t id : drawnNaively(scene, buffers))
                naively += isInner(id);
        }
        for (const std::uint32_t id : look({0.2, 0.9, 0.1}, {-1, 1.1, -0.4})) {
            ++fromWithin;
            wrongFromWithin += !isInner(id);
        }
    }
    EXPECT_EQ(inside, 0);
    EXPECT_GT(outside, 2 * kEyes * 2000);
    EXPECT_GT(naively, outside / 20) << "without the rule the inside should be seen in patches";
    EXPECT_EQ(wrongFromWithin, 0);
    EXPECT_EQ(fromWithin, 2 * kSize.x * kSize.y);
}

} // namespace
} // namespace shadowlab
