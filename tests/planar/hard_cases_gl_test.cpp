// The cases that break careless planar shadows, each with the naive version that fails in it.
//   beyond the light        ACasterBeyondTheLight                    naive: clip=false
//   about its height        ACasterThatReachesAboveTheLight          naive: clip=false, divide=true
//   exactly at its height   VerticesExactlyAtTheHeightOfTheLight     naive: divide=true
//   a shadow 4 km long      AVertexAlmostAtTheHeightOfTheLight       naive: divide=true
//   light in the plane      TheLightInThePlane                       naive: clip=false, once=false
//   light behind the plane  TheLightBehindThePlane                   naive: clip=false, once=false
//   caster in the plane     ACasterThatReachesBelowThePlane          naive: clip=false
//   overlapping casters     FacesThatOverlapDarkenOnce               naive: once=false
//   coinciding depths       FarAwayAndAtAGrazingAngle...             naive: stencil=false, offset 0 and 1000
//   a plane that ends       AShadowEndsWhereItsPlaneEnds             naive: stencil=false
//   several planes          ACornerOfARoomWithEachLightType          naive: receivers=1
//   contact                 AShadowBeginsWhereTheCasterStands        naive: stencil=false, offset=1000000
//   the sun                 TheSunIsInfinitelyFarAway                naive: its direction taken for a place
// Soft shadows are in soft_shadows_gl_test.cpp.
// SPDX-License-Identifier: MIT
#include <set>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/planar/on_planes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::addBox;
using testing::expectExactOnPlanes;
using testing::floorUnder;
using testing::OnPlanes;
using testing::onPlanes;
using PlanarHardTest = testing::GlTest;

/// How many pixels differ between two pictures, in any channel.
int differing(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

std::vector<vec4> picture(const scene::Scene& scene, const std::vector<std::string>& settings = {}) {
    return testing::TechniqueSlot("planar", testing::snapshot(scene)).radiance(settings, testing::kPlanarSize);
}

// What lies above the light casts nothing on the floor; flattened all the same, it is an anti-shadow.
TEST_F(PlanarHardTest, ACasterBeyondTheLight) {
    scene::Scene scene = floorUnder({0, 2, 0});
    addBox(scene, {1, 1, 1}, {0, 3.5, 0});
    const OnPlanes sum = onPlanes(scene);
    EXPECT_GT(sum.lit, 10000) << sum;
    EXPECT_EQ(sum.shadowed + sum.wrong(), 0) << sum;
    EXPECT_GT(onPlanes(scene, {"clip=false"}).falseShadow, 500);
    // With something that does cast beside it; and from within the mirrored image.
    addBox(scene, {0.8, 1, 0.8}, {1.5, 0.5, 0});
    expectExactOnPlanes(scene);
    scene.camera.positionWorld = {0.2, 0.4, 0.5};
    scene.camera.targetWorld = {0, 0, -1};
    const OnPlanes within = onPlanes(scene);
    EXPECT_GT(within.lit, 10000) << within;
    EXPECT_EQ(within.wrong(), 0) << within;
    EXPECT_GT(onPlanes(scene, {"clip=false"}).falseShadow, 500);
}

TEST_F(PlanarHardTest, ACasterThatReachesAboveTheLight) {
    scene::Scene scene = floorUnder({1, 2, 0});
    addBox(scene, {0.5, 2, 0.5}, {0, 2, 0});
    expectExactOnPlanes(scene);
    EXPECT_GT(onPlanes(scene, {"clip=false"}).wrong(), 500);
    EXPECT_GT(onPlanes(scene, {"clip=false", "divide=true"}).wrong(), 500);
}

TEST_F(PlanarHardTest, VerticesExactlyAtTheHeightOfTheLight) {
    scene::Scene scene = floorUnder({1, 2, 0});
    addBox(scene, {0.5, 2, 0.5}, {0, 1, 0}); // its top is at 2
    expectExactOnPlanes(scene);
    EXPECT_GT(onPlanes(scene, {"divide=true"}).wrong(), 500) << "vertices at infinity are lost";
    for (const vec4& radiance : picture(scene))
        ASSERT_TRUE(std::isfinite(radiance.r + radiance.g + radiance.b));
}

// The upper edge of the box casts its shadow 4 km away: 0.001 below the light.
TEST_F(PlanarHardTest, AVertexAlmostAtTheHeightOfTheLight) {
    scene::Scene scene = floorUnder({0, 4, 0});
    addBox(scene, {0.25, 3.999, 0.25}, {1, 1.9995, 0});
    expectExactOnPlanes(scene);
    // Beyond the light with one side, near it with the other: divided, the far end folds over.
    scene.objects[1].worldFromObject[0].y = 0.016; // the top rises by 0.004 from one side to the other
    expectExactOnPlanes(scene);
    EXPECT_GT(onPlanes(scene, {"divide=true"}).wrong(), 100);
}

// A ceiling with the light on it, but for a hair on one side: floats cannot tell on which. Below it all is lit, above it none.
TEST_F(PlanarHardTest, TheLightAlmostInACaster) {
    for (const double height : {2 - 1e-7, 2.0, 2 + 1e-7}) {
        scene::Scene scene = floorUnder({0.3, height, 0.2});
        testing::addObject(scene, scene::makeQuad({3, 3}), testing::translation({0, 2, 0}));
        addBox(scene, {0.6, 0.6, 0.6}, {0, 0.3, 0});
        scene.camera.positionWorld = {0, 1.9, 5};
        const OnPlanes sum = onPlanes(scene);
        EXPECT_GT(height > 2 ? sum.shadowed : sum.lit, 10000) << height << ": " << sum;
        EXPECT_EQ(sum.wrong(), 0) << height << ": " << sum;
    }
}

/// All of a scene turned about an axis that is that of nothing in it.
scene::Scene turned(scene::Scene scene) {
    const dvec3 axis = glm::normalize(dvec3(1, 2, 3));
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto turn = [&](const dvec3& v) { // Rodrigues
        return c * v + s * glm::cross(axis, v) + (1 - c) * glm::dot(axis, v) * axis;
    };
    dmat4 turning(1.0);
    for (int column = 0; column < 3; ++column) {
        dvec3 unit(0.0);
        unit[column] = 1;
        turning[column] = dvec4(turn(unit), 0);
    }
    for (scene::Object& object : scene.objects)
        object.worldFromObject = turning * object.worldFromObject;
    for (scene::Light& light : scene.lights)
        light.positionWorld = turn(light.positionWorld);
    scene.camera.positionWorld = turn(scene.camera.positionWorld);
    scene.camera.targetWorld = turn(scene.camera.targetWorld);
    scene.camera.upWorld = turn(scene.camera.upWorld);
    return scene;
}

/// The floor must look as if the light were off, and its planes' shadows be right elsewhere.
void expectFloorUnlit(const scene::Scene& scene) {
    const OnPlanes sum = onPlanes(scene);
    EXPECT_GT(sum.lit, 50) << sum; // a side of a box
    EXPECT_EQ(sum.wrong(), 0) << sum;
    scene::Scene dark = scene;
    dark.lights[0].intensity = 0;
    const std::vector<vec4> with = picture(scene), without = picture(dark);
    const trace::ExactVisibility judge(testing::snapshot(scene));
    int floor = 0;
    for (int y = 0; y < testing::kPlanarSize.y; ++y)
        for (int x = 0; x < testing::kPlanarSize.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x + 0.5, y + 0.5), testing::kPlanarSize);
            if (!hit || hit->object != 0) continue;
            const auto i = static_cast<std::size_t>(y * testing::kPlanarSize.x + x);
            // Under a light in its plane a turned floor may face it by a rounding, and get that much.
            ASSERT_LE(glm::length(vec3(with[i]) - vec3(without[i])), 1e-5f);
            ++floor;
        }
    EXPECT_GT(floor, 10000);
}

TEST_F(PlanarHardTest, TheLightInThePlane) {
    scene::Scene scene = floorUnder({2, 0, 0});
    scene.objects[0].castsShadow = false; // the light is on it: whether that blocks it is a question of rounding
    scene.camera.positionWorld = {4, 3, 4};
    addBox(scene, {1, 1, 1}, {0, 0.5, 0});
    addBox(scene, {0.2, 0.2, 0.2}, {1, 0.25, 0}); // shadows the box
    expectFloorUnlit(scene);
    // Turned, the light is in the plane to within rounding, and the weights of flattened points are those of rounding.
    const scene::Scene oblique = turned(scene);
    expectFloorUnlit(oblique);
    EXPECT_GT(differing(picture(oblique, {"once=false"}), picture(oblique, {"once=false", "clip=false"})), 50);
}

TEST_F(PlanarHardTest, TheLightBehindThePlane) {
    scene::Scene scene = floorUnder({2, -2, 3});
    scene.objects[0].castsShadow = false; // the box is lit through it
    addBox(scene, {1, 1, 1}, {0, 1.5, 0});
    expectFloorUnlit(scene);
    // Blended over the picture, the flattened boxes darken the ambient light of the floor.
    EXPECT_EQ(differing(picture(scene, {"once=false"}), picture(scene)), 0);
    EXPECT_GT(differing(picture(scene, {"once=false", "clip=false"}), picture(scene)), 500);
}

// A frustum of which the lower part is under the floor: half as wide at the floor as at its base, which must not cast.
TEST_F(PlanarHardTest, ACasterThatReachesBelowThePlane) {
    scene::Scene scene = floorUnder({0, 4, 0});
    std::vector<dvec3> corners;
    const auto at = [](int side, bool top) {
        const double half = top ? 0.25 : 1.0, y = top ? 0.5 : -1.0;
        return dvec3(side == 0 || side == 3 ? -half : half, y, side < 2 ? -half : half);
    };
    for (int side = 0; side < 4; ++side) {
        const dvec3 a = at(side, false), b = at((side + 1) % 4, false), c = at((side + 1) % 4, true),
                    d = at(side, true);
        corners.insert(corners.end(), {a, c, b, a, d, c});
    }
    corners.insert(corners.end(), {at(0, true), at(2, true), at(1, true), at(0, true), at(3, true), at(2, true)});
    testing::addObject(scene, testing::triangleSoup(corners));
    scene.camera.positionWorld = {1, 2.5, 2};
    const OnPlanes clipped = onPlanes(scene);
    EXPECT_GT(clipped.lit, 10000);
    EXPECT_EQ(clipped.wrong(), 0) << clipped;
    EXPECT_GT(onPlanes(scene, {"clip=false"}).falseShadow, 500) << "a ring around it";
    // One that is below altogether, and one that does cast.
    addBox(scene, {4, 0.5, 4}, {0, -1.5, 0});
    addBox(scene, {0.3, 0.8, 0.3}, {1, 0.3, 0.5});
    expectExactOnPlanes(scene, 300);
    EXPECT_GT(onPlanes(scene, {"clip=false"}).falseShadow, 500);
}

// Two sheets above one another, and a closed box: of which each has a front and a back.
TEST_F(PlanarHardTest, FacesThatOverlapDarkenOnce) {
    scene::Scene scene = floorUnder({1, 5, 1});
    testing::addObject(scene, scene::makeQuad({1.5, 1.5}), testing::translation({0, 1, 0}));
    testing::addObject(scene, scene::makeQuad({1.5, 1.5}), testing::translation({0.5, 1.5, 0.3}));
    addBox(scene, {0.6, 0.6, 0.6}, {-1.5, 1, 1});
    expectExactOnPlanes(scene);
    const trace::ExactVisibility judge(testing::snapshot(scene));
    const auto levels = [&](const std::vector<std::string>& settings) {
        const std::vector<vec4> seen = picture(scene, settings);
        std::set<float> found;
        int compared = 0;
        for (int y = 0; y < testing::kPlanarSize.y; ++y)
            for (int x = 0; x < testing::kPlanarSize.x; ++x) {
                const auto hit = judge.eyeHit(scene.camera, dvec2(x + 0.5, y + 0.5), testing::kPlanarSize);
                if (!hit || hit->object != 0) continue;
                if (judge.visibility(*hit, scene.camera, 0) != trace::Visibility::shadowed) continue;
                const float green = seen[static_cast<std::size_t>(y * testing::kPlanarSize.x + x)].g;
                // At the very border a pixel may be on either side; all that is in shadow has the ambient light alone, or,
                // blended, less than a hundredth of what the lit floor has more.
                if (green < 0.5f) found.insert(green);
                ++compared;
            }
        EXPECT_GT(compared, 1000);
        return found.size();
    };
    EXPECT_EQ(levels({}), 1u);
    EXPECT_GT(levels({"once=false"}), 3u);
}

// The plane is 20 times as long as the distance, and seen at one degree: depths from a tenth of a metre to ten kilometres.
TEST_F(PlanarHardTest, FarAwayAndAtAGrazingAngleThereIsNoFightForDepth) {
    int fought = 0, pulled = 0;
    for (const double distance : {5.0, 50.0, 500.0, 1000.0}) {
        scene::Scene scene = testing::floorScene();
        scene.objects.clear();
        testing::addObject(scene, scene::makeQuad({20 * distance, 20 * distance}));
        addBox(scene, distance * dvec3(0.1, 0.1, 0.1), {0, 0.05 * distance, 0});
        scene.lights.push_back(testing::directionalLight({-1, -0.15, 0.6}));
        scene.camera.positionWorld = {0, std::tan(M_PI / 180) * distance, distance};
        scene.camera.fovYDegrees = 12;
        scene.camera.near = 0.1;
        expectExactOnPlanes(scene, 300);
        fought += onPlanes(scene, {"stencil=false", "offset=0"}).wrong();
        pulled += onPlanes(scene, {"stencil=false", "offset=1000"}).wrong();
    }
    EXPECT_GT(fought, 500) << "fights with the plane for depth";
    EXPECT_GT(pulled, 100) << "pulled before what stands on the plane";
}

// A table and the floor below: what misses the table falls on the floor, at a place of its own.
TEST_F(PlanarHardTest, AShadowEndsWhereItsPlaneEnds) {
    scene::Scene scene = floorUnder({1, 4, 0.5});
    testing::addObject(scene, scene::makeQuad({2, 1}), testing::translation({0, 1, 0}));
    testing::addObject(scene, scene::makeSphere(0.3, 32), testing::translation({0.9, 1.5, 0}));
    scene.camera.positionWorld = {-1.5, 3, 4};
    expectExactOnPlanes(scene);
    EXPECT_GT(onPlanes(scene, {"stencil=false"}).falseShadow, 50) << "spilled over the edge of the table";
    EXPECT_GT(onPlanes(scene, {"stencil=false", "offset=0"}).falseLit, 5) << "fights with the plane for depth";
}

TEST_F(PlanarHardTest, ACornerOfARoomWithEachLightType) {
    scene::Scene scene = floorUnder({2, 4, 2});
    const dmat4 turnX = glm::dmat4(dvec4(1, 0, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, -1, 0, 0), dvec4(0, 2, -3, 1));
    const dmat4 turnZ = glm::dmat4(dvec4(0, -1, 0, 0), dvec4(1, 0, 0, 0), dvec4(0, 0, 1, 0), dvec4(-3, 2, 0, 1));
    testing::addObject(scene, scene::makeQuad({10, 4}), turnX);
    testing::addObject(scene, scene::makeQuad({4, 10}), turnZ);
    addBox(scene, {1, 2.5, 1}, {-1.5, 1.25, -1.5});
    using enum scene::LightType;
    for (const scene::LightType type : {point, directional, spot, rect, scene::LightType::sphere}) {
        scene.lights[0].type = type;
        scene.lights[0].directionWorld = glm::normalize(dvec3(-1, -1.2, -1));
        expectExactOnPlanes(scene);
        EXPECT_GT(onPlanes(scene, {"receivers=1"}).falseLit, 300) << "one matrix for the ground, none for walls";
    }
}

TEST_F(PlanarHardTest, AShadowBeginsWhereTheCasterStands) {
    scene::Scene scene = floorUnder({2, 4, 1.5});
    addBox(scene, {1, 1, 1}, {0, 0.5, 0});
    scene.camera.positionWorld = {-3, 1.5, -3};
    scene.camera.fovYDegrees = 35;
    expectExactOnPlanes(scene);
    // The unit of glPolygonOffset is the driver's own: Mesa 26 takes half of what Mesa 22 takes. A million of either show.
    EXPECT_GT(onPlanes(scene, {"stencil=false", "offset=1000000"}).wrong(), 50) << "drawn over the caster's foot";
}

TEST_F(PlanarHardTest, TheSunIsInfinitelyFarAway) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::directionalLight({-0.3, -1, -0.2})); // toward (0.3, 1, 0.2)
    addBox(scene, {0.8, 0.5, 0.8}, {0, 0.25, 0});
    addBox(scene, {0.8, 0.3, 0.8}, {1.5, 0.6, 0.8});
    expectExactOnPlanes(scene, 300);
    scene::Scene mistaken = scene;
    mistaken.lights[0] = testing::pointLight({0.3, 1, 0.2});
    EXPECT_GT(onPlanes(mistaken, {}, 0, &scene).wrong(), 500) << "with weight 1 it is a lamp";
}

} // namespace
} // namespace shadowlab
