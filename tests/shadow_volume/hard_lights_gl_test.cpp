// Hard cases of shadow volumes: where the light is, and how many there are. Each is compared with the exact judge for all
// three ways to count, before and after repair, and beside it the naive way that must fail. A list of all cases stands in
// hard_eyes_gl_test.cpp.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>

#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/shadow_volume/cull/casters.h"
#include "tests/shadow_volume/counted_by_rays.h"
#include "tests/shadow_volume/volume_case.h"

namespace shadowlab {
namespace {

using testing::awayFrom;
using testing::countedBehind;
using testing::JudgedPicture;
using testing::oneSign;
using testing::prisms;
using testing::VolumeFaces;
using HardLights = testing::VolumeCase;

/// An octahedron of eight unlike faces, on a grid of 2^-4.
scene::Mesh crystal() {
    const dvec3 left(-1, 1.25, 0.125), right(0.9375, 1.125, -0.25), front(0.0625, 1, 0.875), back(-0.125, 1.375, -1),
        top(0.125, 2.25, -0.0625), bottom(-0.0625, 0.375, 0.1875);
    std::vector<dvec3> corners;
    const std::pair<dvec3, dvec3> around[] = {{front, right}, {right, back}, {back, left}, {left, front}};
    for (const auto& [a, b] : around)
        corners.insert(corners.end(), {a, b, top, b, a, bottom});
    return testing::triangleSoup(corners);
}

/// A sheet of 8 x 8 squares in a slanting plane, all coordinates on a grid of 2^-12.
struct Sheet {
    dvec3 corner{-1.0, 0.5, 0.25}, u{0.17578125, 0.0322265625, -0.064208984375},
        v{0.0498046875, 0.15966796875, 0.07080078125};
    [[nodiscard]] scene::Mesh mesh() const {
        std::vector<dvec3> corners;
        const auto at = [&](int i, int j) { return corner + double(i) * u + double(j) * v; };
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                corners.insert(corners.end(),
                               {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        return testing::triangleSoup(corners);
    }
};

void expectOneSignIsRightAndFloatIsNot(const JudgedPicture& picture, int leastWrong) {
    const scene::Scene& scene = *picture.snapshot();
    const scene::Light& light = scene.lights[0];
    EXPECT_EQ(countedBehind(picture, prisms(scene, oneSign(scene, light), awayFrom(light))).wrong, 0);
    const VolumeFaces inFloat = prisms(scene, testing::signsInFloat(scene, light), awayFrom(light));
    EXPECT_GT(countedBehind(picture, inFloat).wrong, leastWrong) << "streaks to infinity";
}

TEST_F(HardLights, InThePlaneOfAFace) {
    // A sheet that the light sees exactly edge-on shadows nothing; the crystal beside it does.
    const Sheet sheet;
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, sheet.mesh());
    testing::addObject(scene, crystal(), testing::translation({1.5, 0, -0.5}));
    scene.lights = {testing::pointLight(sheet.corner + 4.0 * sheet.u + 16.0 * sheet.v)};
    for (const std::int8_t sign : scene::facingSigns(scene.objects[1], scene.lights[0]))
        ASSERT_EQ(sign, 0);
    const JudgedPicture picture = judged(scene);
    expectExact(picture);
    expectOneSignIsRightAndFloatIsNot(picture, 100);

    // Each face of the crystal in turn, from a place beyond its edge. The box has a shadow in any case.
    const scene::Mesh mesh = crystal();
    scene.objects.erase(scene.objects.begin() + 1);
    scene.objects[1].worldFromObject = dmat4(1.0);
    testing::addObject(scene, scene::makeBox({0.75, 0.75, 0.75}), testing::translation({1.5, 0.375, 1}));
    int edgeOn = 0;
    for (const uvec3& t : mesh.triangles) {
        const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
        scene.lights = {testing::pointLight(a + 2.0 * (b - a) + (c - a))};
        if (scene.lights[0].positionWorld.y < 0.5) continue; // below everything that is seen
        const auto signs = scene::facingSigns(scene.objects[1], scene.lights[0]);
        edgeOn += static_cast<int>(std::ranges::count(signs, 0));
        expectExact(scene);
    }
    EXPECT_GE(edgeOn, 4);
}

TEST_F(HardLights, InAVertex) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, crystal());
    testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation({1.5, 0.25, 0.75}));
    const scene::Mesh& mesh = *scene.objects[1].mesh;
    int wrong = 0;
    for (const std::uint32_t vertex : {mesh.triangles[0].x, mesh.triangles[0].y, mesh.triangles[0].z}) {
        scene.lights = {testing::pointLight(dvec3(mesh.positionsMesh[vertex]))};
        const JudgedPicture picture = judged(scene);
        expectExact(picture);
        // What is pushed away from itself is (0, 0, 0, 0): a picture without a number in it would show that.
        picture::Session session(picture.snapshot());
        for (const testing::ExactWay& way : testing::kExactWays) {
            picture::Slot slot = picture::Session::makeSlot(way.technique);
            View view;
            view.camera = scene.camera;
            view.size = {80, 60};
            session.render(slot, view);
            for (const vec4& texel : gl::readTexels(slot.target.color))
                ASSERT_TRUE(std::isfinite(texel.r) && std::isfinite(texel.g) && std::isfinite(texel.b));
        }
        // Zero taken for "toward the light": a face through the light counts, and what it bounds is open.
        const scene::Light& light = scene.lights[0];
        const testing::SideOf right = oneSign(scene, light);
        const auto zeroCounts = [&](std::size_t object, std::uint32_t triangle, int use) {
            const int sign = right(object, triangle, use);
            return sign == 0 ? 1 : sign;
        };
        EXPECT_EQ(countedBehind(picture, prisms(scene, right, awayFrom(light))).wrong, 0);
        wrong += countedBehind(picture, prisms(scene, zeroCounts, awayFrom(light))).wrong;
    }
    EXPECT_GT(wrong, 100);
}

TEST_F(HardLights, AtInfinityAllSidesMeetInOnePoint) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, crystal());
    testing::addObject(scene, scene::makeTorus(0.5, 0.25, {16, 8}), testing::translation({1.5, 0.75, 0.75}));
    scene.lights = {testing::directionalLight({-0.3, -1, -0.2})};
    const JudgedPicture picture = judged(scene);
    expectExact(picture);
    const testing::SideOf right = oneSign(scene, scene.lights[0]);
    EXPECT_EQ(countedBehind(picture, prisms(scene, right, awayFrom(scene.lights[0]))).wrong, 0);
    // As if the direction toward the light were its place.
    const dvec3 toLight(scene::homogeneousPositionWorld(scene.lights[0]));
    const auto fromAPlace = [=](const dvec3& p) { return dvec4(p - toLight, 0); };
    EXPECT_GT(countedBehind(picture, prisms(scene, right, fromAPlace)).wrong, 100);

    // At infinity one triangle of each side is enough, and no bottom: the other ones have no area.
    shadow_volume::Casters casters;
    while (!casters.buildNext(picture.snapshot())) {
    }
    std::size_t edges = 0, triangles = 0;
    for (const shadow_volume::CasterVolume& caster : casters.of(0)) {
        const auto n = static_cast<std::uint32_t>(caster.mesh->mesh->positionsMesh.size());
        const auto isFar = [&](std::uint32_t index) { return index >= n; };
        for (const shadow_volume::SilhouetteEdge& edge : caster.silhouette)
            edges += edge.multiplicity;
        const std::vector<std::uint32_t>& sides = caster.volume.sides;
        // Only the first half is drawn: in the second two corners are far, and those are one point.
        for (std::size_t i = 0; i < sides.size(); i += 3) {
            const bool inFirstHalf = i < sides.size() / 2;
            EXPECT_EQ(std::count_if(&sides[i], &sides[i] + 3, isFar), inFirstHalf ? 1 : 2);
            triangles += inFirstHalf;
        }
    }
    EXPECT_GT(edges, 20u);
    EXPECT_EQ(triangles, edges);
}

/// A ball of 1280 triangles with smooth shading normals.
scene::Mesh icosphere() {
    const double t = (1 + std::sqrt(5.0)) / 2;
    std::vector<dvec3> points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::vector<uvec3> triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int subdivision = 0; subdivision < 3; ++subdivision) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, isNew] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
            if (isNew) points.push_back(0.5 * (glm::normalize(points[a]) + glm::normalize(points[b])));
            return found->second;
        };
        std::vector<uvec3> finer;
        for (const uvec3& f : triangles) {
            const std::uint32_t a = middle(f.x, f.y), b = middle(f.y, f.z), c = middle(f.z, f.x);
            finer.insert(finer.end(), {{f.x, a, c}, {f.y, b, a}, {f.z, c, b}, {a, b, c}});
        }
        triangles = finer;
    }
    scene::Mesh mesh;
    for (const dvec3& point : points) {
        mesh.positionsMesh.emplace_back(glm::normalize(point));
        mesh.normalsMesh.emplace_back(glm::normalize(point));
    }
    mesh.triangles = triangles;
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(triangles.size())}};
    return mesh;
}

// Smooth shading normals do not move the border: a facet is dark as a whole where its plane has the light behind it.
TEST_F(HardLights, FacetsAreDarkWhereTheyTurnAway) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, icosphere(), testing::translation({0, 1.25, 0}));
    EXPECT_EQ(scene.objects[1].mesh->triangles.size(), 1280u);
    scene.lights = {testing::directionalLight({1, -1, 0})};
    const JudgedPicture picture = judged(scene);
    expectExact(picture);
    const auto signs = scene::facingSigns(scene.objects[1], scene.lights[0]);
    for (const testing::ExactWay& way : testing::kExactWays) {
        const picture::VisibilityImage image = draw(picture, way, true);
        int front = 0, back = 0;
        for (int y = 0; y < picture.size().y; ++y)
            for (int x = 0; x < picture.size().x; ++x) {
                const auto& hit = picture.hit(x, y);
                if (!hit || hit->object != 1 || picture.isTie(x, y)) continue;
                const bool facesLight = signs[hit->triangle] > 0;
                ++(facesLight ? front : back);
                ASSERT_EQ(image.grey(x, y) > 127, facesLight) << x << ", " << y; // convex: nothing else shadows it
            }
        EXPECT_GT(front, 1000);
        EXPECT_GT(back, 1000);
    }
}

/// Linear radiance of every pixel.
std::vector<vec4> radiance(const scene::Scene& scene, const testing::ExactWay& way) {
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(way.technique));
    for (const std::string& setting : way.settings)
        lab::applySettings(slots, {way.technique + "." + setting});
    View view;
    view.camera = scene.camera;
    view.size = {160, 120};
    session.render(slots[0], view);
    return gl::readTexels(slots[0].target.color);
}

TEST_F(HardLights, FourAddUp) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::pointLight({2, 5, 3}), testing::pointLight({-3, 4, 1}),
                    testing::directionalLight({0.5, -1, 0.25}), testing::directionalLight({-0.5, -1, -0.5})};
    for (scene::Light& light : scene.lights)
        light.intensity *= 0.2; // below one in sum
    expectExact(scene);
    for (const testing::ExactWay& way : testing::kExactWays) {
        const std::vector<vec4> all = radiance(scene, way);
        scene::Scene one = scene;
        one.lights.clear();
        const std::vector<vec4> ambient = radiance(one, way);
        std::vector<vec4> sum = ambient;
        std::vector<bool> darkBefore(all.size(), false);
        int counted = 0;
        for (const scene::Light& light : scene.lights) {
            one.lights = {light};
            const std::vector<vec4> single = radiance(one, way);
            for (std::size_t i = 0; i < sum.size(); ++i) {
                const vec4 added = single[i] - ambient[i];
                sum[i] += added;
                counted += added.g > 0 && darkBefore[i]; // the stencil of a light before, had it not been cleared
                darkBefore[i] = darkBefore[i] || added.g == 0;
            }
        }
        double most = 0, mostWithAmbientEachTime = 0;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            most = std::max(most, std::abs(double(all[i].g - sum[i].g)));
            mostWithAmbientEachTime =
                std::max(mostWithAmbientEachTime, std::abs(double(all[i].g - sum[i].g - 3 * ambient[i].g)));
        }
        EXPECT_LE(most, 1.0 / 255) << way.technique;
        EXPECT_GT(mostWithAmbientEachTime, 10.0 / 255);
        EXPECT_GT(counted, 200) << "pixels lit by one light and in the shadow of one before";
    }
}

} // namespace
} // namespace shadowlab
