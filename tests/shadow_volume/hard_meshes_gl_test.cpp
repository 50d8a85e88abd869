// Hard cases of shadow volumes: the caster's mesh. Each is compared with the exact judge for all three ways to count,
// before and after repair, and beside it the naive way that must fail. A list of all cases stands in hard_eyes_gl_test.cpp.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "tests/shadow_volume/counted_by_rays.h"
#include "tests/shadow_volume/volume_case.h"
#include "tests/support/hard_scenes.h"

namespace shadowlab {
namespace {

using testing::HardClass;
using testing::JudgedPicture;

class HardMeshes : public testing::VolumeCase {
protected:
    /// Exact in all three ways, where two faces to an edge are not enough.
    void expectLectureAloneFails(const scene::Scene& scene) const {
        expectExact(scene);
        int wrong = 0; // one of the lights may be where it does not matter
        for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light)
            wrong += wrongWith(judged(scene, light), "shadow-volume-zfail", {"construction=lecture"});
        EXPECT_GT(wrong, 200);
    }
};

/// The triangles of a mesh for which keep(middle of the triangle) is true.
template <typename Keep>
scene::Mesh partOf(scene::Mesh mesh, const Keep& keep) {
    std::erase_if(mesh.triangles, [&](const uvec3& t) {
        return !keep(dvec3(mesh.positionsMesh[t.x] + mesh.positionsMesh[t.y] + mesh.positionsMesh[t.z]) / 3.0);
    });
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

scene::Scene over(const scene::Mesh& mesh, const dvec3& place) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, mesh, testing::translation(place));
    scene.lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25})};
    return scene;
}

TEST_F(HardMeshes, OpenOnes) {
    const scene::Mesh ball = scene::makeSphere(1, 32);
    expectLectureAloneFails(over(scene::makeQuad({2, 3}), {0, 1.5, 0}));
    expectLectureAloneFails(over(partOf(ball, [](const dvec3& middle) { return middle.y > 0; }), {0, 0.5, 0}));
    expectLectureAloneFails(
        over(partOf(ball, [](const dvec3& middle) { return middle.y < 0.5; }), {0, 1.25, 0})); // no lid
    expectLectureAloneFails(over(
        partOf(scene::makeTorus(1, 0.4, {32, 16}), [](const dvec3& middle) { return middle.x > -0.5; }), {0, 1, 0}));
}

/// So many triangles on one edge, to all sides of it, every second one wound the other way round.
scene::Mesh fan(int triangles) {
    std::vector<dvec3> corners;
    const dvec3 a(-0.75, 1, -0.5), b(0.75, 1.5, 0.5);
    for (int i = 0; i < triangles; ++i) {
        const double angle = 2 * M_PI * i / triangles + 0.3;
        const dvec3 tip(0.5 * std::sin(angle), 1.25 + 0.75 * std::cos(angle), -std::sin(angle));
        corners.insert(corners.end(), {a, i % 2 ? tip : b, i % 2 ? b : tip});
    }
    return testing::triangleSoup(corners);
}

TEST_F(HardMeshes, ManyFacesOnOneEdge) {
    for (int triangles = 3; triangles <= 6; ++triangles) {
        SCOPED_TRACE(triangles);
        expectLectureAloneFails(over(fan(triangles), {0, 0, 0}));
    }
}

/// With every second triangle, by chance, the other way round.
scene::Mesh withHalfFlipped(scene::Mesh mesh) {
    std::mt19937 random(5);
    for (uvec3& t : mesh.triangles)
        if (random() % 2) std::swap(t.y, t.z);
    return mesh;
}

TEST_F(HardMeshes, WindingIsNobodysBusiness) {
    const scene::Scene alike = over(scene::makeTorus(1, 0.4, {24, 12}), {0, 1.25, 0});
    const scene::Scene flipped = over(withHalfFlipped(*alike.objects[1].mesh), {0, 1.25, 0});
    for (const int light : {0, 1}) {
        const JudgedPicture picture = judged(flipped, light), wound = judged(alike, light);
        expectExact(picture);
        for (const testing::ExactWay& way : testing::kExactWays) {
            for (const bool repair : {false, true}) {
                const auto one = draw(picture, way, repair), other = draw(wound, way, repair);
                int differing = 0;
                for (std::size_t i = 0; i < one.greyAlpha.size(); ++i)
                    differing += one.greyAlpha[i] != other.greyAlpha[i];
                EXPECT_EQ(differing, 0) << way.technique << (repair ? ", repaired" : "");
            }
        }
        // Who trusts the winding sees silhouettes all over the torus. The same construction is right where it can be trusted.
        const auto classical = [&](const JudgedPicture& judgedPicture) {
            const scene::Scene& scene = *judgedPicture.snapshot();
            const scene::Light& source = scene.light(light);
            scene::Scene torusAlone = scene;
            torusAlone.objects[0].mesh = std::make_shared<scene::Mesh>(); // a floor is open, and shadows nothing
            return testing::countedBehind(
                judgedPicture,
                testing::betweenTwoFaces(torusAlone, testing::oneSign(torusAlone, source), testing::awayFrom(source)));
        };
        EXPECT_EQ(classical(wound).wrong, 0);
        EXPECT_GT(classical(picture).wrong, 100);
    }
}

// Corners on one line, none of them at a round place; the mesh around them is as it was.
TEST_F(HardMeshes, DegenerateTriangles) {
    const dvec3 a(-1, 1, 0.25), b(0.875, 1.25, -1), c(0.5, 1.125, 1), d(0.125, 2.25, 0);
    std::vector<dvec3> corners = {a, b, c, a, d, b, b, d, c, c, d, a};
    const scene::Scene plain = over(testing::triangleSoup(corners), {0, 0, 0});
    std::mt19937 random(7);
    const auto grid = [&](double low, double high) {
        return std::round(std::uniform_real_distribution<double>(low, high)(random) * 2048) / 2048;
    };
    for (int i = 0; i < 40; ++i) {
        const dvec3 p(grid(-2, 2), grid(0.5, 2), grid(-2, 2)),
            step(grid(-0.5, 0.5), grid(-0.25, 0.25), grid(-0.5, 0.5));
        corners.insert(corners.end(), {p, p + step, p + 2.0 * step}); // on one line
        corners.insert(corners.end(), {p, p, p + step});              // one corner twice
        corners.insert(corners.end(), {p, p, p});
        corners.insert(corners.end(), {p, p + step, p + 0.37 * step}); // on one line, until rounded to float
    }
    const scene::Scene degenerate = over(testing::triangleSoup(corners), {0, 0, 0});
    expectExact(degenerate);
    for (const int light : {0, 1}) {
        const JudgedPicture picture = judged(degenerate, light);
        const scene::Light& source = degenerate.light(light);
        for (const testing::ExactWay& way : testing::kExactWays)
            EXPECT_EQ(draw(picture, way, true).greyAlpha, draw(judged(plain, light), way, true).greyAlpha);
        const auto oneSign =
            testing::prisms(degenerate, testing::oneSign(degenerate, source), testing::awayFrom(source));
        EXPECT_EQ(testing::countedBehind(picture, oneSign).wrong, 0);
        if (light == 1) continue; // toward the sun the corner makes no difference
        const auto inFloat =
            testing::prisms(degenerate, testing::signsInFloat(degenerate, source), testing::awayFrom(source));
        EXPECT_GT(testing::countedBehind(picture, inFloat).wrong, 100) << "noise decides, and side faces stand alone";
    }
}

TEST_F(HardMeshes, DuplicatesAndVerticesOnEdges) {
    scene::Mesh box = scene::makeBox({1.5, 1, 1});
    const std::vector<uvec3> once = box.triangles;
    box.triangles.insert(box.triangles.end(), once.begin(), once.end()); // all faces twice, one of them three times
    box.triangles.push_back(once[3]);
    box.parts[0].triangleCount = static_cast<std::uint32_t>(box.triangles.size());
    expectLectureAloneFails(over(box, {0, 1, 0}));

    std::vector<dvec3> corners; // the same box out of loose triangles: no two share a vertex, but for its place
    for (const uvec3& t : once)
        for (int c = 0; c < 3; ++c)
            corners.emplace_back(box.positionsMesh[t[c]]);
    expectExact(over(testing::triangleSoup(corners), {0, 1, 0}));

    // A tetrahedron, one face of which is divided at the middle of an edge; its neighbour has no vertex there (a
    // T-junction).
    const dvec3 a(-1, 1, 0.25), b(1, 1.25, -1), c(0.5, 1.125, 1), d(0.125, 2.25, 0), m = 0.5 * (a + b);
    const scene::Mesh divided = testing::triangleSoup({a, m, c, m, b, c, a, d, b, b, d, c, c, d, a});
    expectLectureAloneFails(over(divided, {0, 0, 0}));
}

/// Without the two triangles whose middles are nearest to a point.
scene::Mesh withoutTwoNearest(scene::Mesh mesh, const dvec3& pointMesh) {
    std::ranges::sort(mesh.triangles, {}, [&](const uvec3& t) {
        const vec3 sum = mesh.positionsMesh[t.x] + mesh.positionsMesh[t.y] + mesh.positionsMesh[t.z];
        return glm::length(dvec3(sum) / 3.0 - pointMesh);
    });
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
    mesh.parts[0].triangleCount -= 2;
    return mesh;
}

TEST_F(HardMeshes, LightInATubeClosedAndWithAHole) {
    const scene::Mesh tube = scene::makeTorus(1.5, 0.625, {16, 10});
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, tube, testing::translation({0, 1.25, 0}));
    scene.lights = {testing::pointLight({1.5, 1.25, 0.125})};
    {
        const JudgedPicture outside = judged(scene);
        expectExact(outside, {.lit = 0, .shadowed = 20000}); // nothing leaves a closed tube
        EXPECT_GT(wrongWith(outside, "shadow-volume-zfail", {"caps=false"}), 10000);
    }
    // From within the tube one sees it lit, as far as its bend allows.
    scene.camera.positionWorld = {0.25, 1.25, 1.46875};
    scene.camera.targetWorld = {-1.375, 1.1875, 0.875};
    expectExact(judged(scene));
    // Two faces less, below the light: a patch of the floor is lit.
    scene.objects[1].mesh = scene::sharedMesh(withoutTwoNearest(tube, {1.5, -0.625, 0.125}));
    scene.camera.positionWorld = {3, 1.5, 2.5};
    scene.camera.targetWorld = {1.5, 0.125, 0};
    const JudgedPicture holed = judged(scene);
    expectExact(holed);
    EXPECT_GT(wrongWith(holed, "shadow-volume-zfail", {"construction=lecture"}), 200);
    EXPECT_GT(wrongWith(holed, "shadow-volume-zfail", {"caps=false"}), 10000);
}

} // namespace
} // namespace shadowlab
