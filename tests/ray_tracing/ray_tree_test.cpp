// The tree of a pixel ray, on scenes with a known answer: mirrors that face each other, the image in a mirror against the
// scene on its other side, rooms of even radiance.
// SPDX-License-Identifier: MIT
#include "tests/ray_tracing/tree_of.h"

#include <glm/gtc/matrix_transform.hpp>

namespace shadowlab::ray_tracing {
namespace {

using testing::addMaterial;
using testing::addObject;
using testing::TracedScene;
using testing::translation;

scene::Scene emptyScene() {
    scene::Scene scene;
    scene.materials.emplace_back();
    return scene;
}

dmat4 upright(const dvec3& offset) { // a quad's +y turned to +z
    return glm::rotate(translation(offset), glm::radians(90.0), dvec3(1, 0, 0));
}

constexpr double kRho = 0.75, kApart = 2;
constexpr double kToLamp = 0.3; // how far the lamp is to the side of the eye

/// Two mirrors that face each other, a small lamp in the middle; the eye is in the middle, too.
scene::Scene facingMirrors() {
    scene::Scene scene = emptyScene();
    const std::uint32_t mirror = addMaterial(scene, kRho, 0);
    addObject(scene, scene::makeQuad({64, 64}), mirror, upright({0, 0, 0}));
    addObject(scene, scene::makeQuad({64, 64}), mirror, upright({0, 0, kApart}));
    addObject(scene, scene::makeQuad({0.02, 0.02}), addMaterial(scene, 0, 0, 1.5, 0, 1), upright({kToLamp, 0, 1}));
    return scene;
}

TEST(RayTree, MirrorsThatFaceEachOtherShowImagesInARow) {
    const TracedScene traced(facingMirrors());
    const dvec3 eyeWorld(0, 0, 1);
    for (int k = 1; k <= 8; ++k) {
        const dvec3 imageWorld(kToLamp, 0, 1 - k * kApart); // of the lamp, by k mirrors one after the other
        const RayTree tree = traced.tree(eyeWorld, imageWorld, {.depth = 16});
        ASSERT_EQ(tree.nodes().size(), static_cast<std::size_t>(k + 1));
        double length = 0;
        for (const TreeNode& node : tree.nodes())
            length += node.distance;
        EXPECT_EQ(tree.nodes().back().end, RayEnd::lightSource);
        EXPECT_NEAR(length, std::hypot(kToLamp, k * kApart), 1e-12) << k;
        EXPECT_NEAR(tree.root().intensity.x, std::pow(kRho, k), 1e-12) << k;
        EXPECT_NEAR(tree.root().reflectedIntensity.x, std::pow(kRho, k - 1), 1e-12);
        EXPECT_EQ(tree.levels(), k + 1);
    }
}

TEST(RayTree, EveryRayIsAttenuatedByItsOwnWay) {
    const TracedScene traced(facingMirrors());
    TreeSettings settings{.depth = 4};
    settings.attenuation = {0.5, 0.25, 0.125};
    const auto left = [](double d) { return 1 / (0.5 + 0.25 * d + 0.125 * d * d); };
    const RayTree tree = traced.tree({0, 0, 1}, {kToLamp, 0, -1}, settings);
    const double way = 0.5 * std::hypot(kToLamp, kApart); // to the mirror; and as far back
    EXPECT_NEAR(tree.root().intensity.x, left(way) * kRho * left(way), 1e-12);
}

TEST(RayTree, EndsAtItsDepthAndWhereItAddsTooLittle) {
    scene::Scene scene = facingMirrors();
    scene.background = vec3(0.5f);
    const TracedScene traced(scene);
    const dvec3 eyeWorld(0, 0, 1), straightWorld(0, 0, 0.5); // to and fro for ever
    for (const int depth : {1, 3, 16}) {
        const RayTree tree = traced.tree(eyeWorld, straightWorld, {.depth = depth});
        EXPECT_EQ(tree.levels(), depth + 1);
        EXPECT_EQ(tree.nodes().back().end, RayEnd::depth);
        EXPECT_NEAR(tree.root().intensity.x, 0.5 * std::pow(kRho, depth + 1), 1e-12);
    }
    const RayTree tree = traced.tree(eyeWorld, straightWorld, {.depth = 16, .cutoff = 0.4});
    EXPECT_EQ(tree.levels(), 4) << "0.75, 0.5625, 0.42, and no 0.32";
    EXPECT_EQ(tree.nodes().back().end, RayEnd::cutoff);
    EXPECT_NEAR(tree.root().intensity.x, 0.5 * std::pow(kRho, 4), 1e-12);
    const RayTree none = traced.tree(eyeWorld, straightWorld, {.depth = 0});
    EXPECT_EQ(none.nodes().size(), 1u);
    EXPECT_EQ(none.root().end, RayEnd::depth);
    EXPECT_EQ(none.root().intensity, dvec3(0));
}

TEST(RayTree, AReflectingLightGoesOnAndAnotherEnds) {
    for (const double reflectivity : {0.0, 0.5}) {
        scene::Scene scene = emptyScene();
        scene.background = vec3(3);
        addObject(scene, scene::makeQuad({4, 4}), addMaterial(scene, reflectivity, 0, 1.5, 0, 2), dmat4(1));
        const TracedScene traced(scene);
        const RayTree tree = traced.tree({0.1, 1, 0.2}, {0, 0, 0}, {.depth = 4});
        EXPECT_EQ(tree.root().end, reflectivity > 0 ? RayEnd::splits : RayEnd::lightSource);
        EXPECT_NEAR(tree.root().intensity.x, 2 + reflectivity * 3, 1e-12);
    }
}

/// Things of every kind, no light but an even background of one.
scene::Scene furnace() {
    scene::Scene scene = emptyScene();
    scene.background = vec3(1);
    addObject(scene, scene::makeSphere(1, 48), addMaterial(scene, 0.04, 0.96), translation({-1.2, 1, 0}));
    addObject(scene, scene::makeSphere(0.5, 48), addMaterial(scene, 0, 1, 1), translation({-1.2, 1.2, 0}));
    addObject(scene, scene::makeTorus(0.8, 0.3, {48, 24}), addMaterial(scene, 0.3, 0.7, 1.33), translation({1, 1, 0}));
    addObject(scene, scene::makeBox({0.8, 0.8, 0.8}), addMaterial(scene, 0, 1, 1.8, 2), translation({0, 0.7, 1}));
    addObject(scene, scene::makeQuad({8, 8}), addMaterial(scene, 1, 0), dmat4(1));
    addObject(scene, scene::makeQuad({8, 8}), addMaterial(scene, 1, 0), upright({0, 2, -3}));
    return scene;
}

/// Calls check(tree) for a grid of rays from an eye before the scene.
template <typename Check>
int forRays(const TracedScene& traced, const TreeSettings& settings, const Check& check) {
    int trees = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const RayTree tree =
                traced.tree({0.3, 2.5, 6}, {-3 + 6 * (x + 0.5) / 40, -0.5 + 4 * (y + 0.5) / 30, 0}, settings);
            if (tree.nodes().empty()) continue;
            check(tree);
            ++trees;
        }
    return trees;
}

TEST(RayTree, AWhiteFurnaceIsWhite) {
    const TracedScene traced(furnace());
    int totals = 0;
    for (const Fresnel fresnel : {Fresnel::exact, Fresnel::schlick, Fresnel::constant}) {
        const int trees = forRays(traced, {.depth = 8, .cutoff = 1e-3, .fresnel = fresnel}, [&](const RayTree& tree) {
            EXPECT_NEAR(tree.root().intensity.x, 1, 1e-12);
            for (const TreeNode& node : tree.nodes())
                totals += node.end == RayEnd::noTransmission;
        });
        EXPECT_GT(trees, 800);
    }
    EXPECT_GT(totals, 500) << "total reflection is a part of it";
}

TEST(RayTree, AClosedRoomOfMirrorsShinesEvenly) {
    // Walls that shine with 1 - rho and mirror rho: the sum over all bounces is 1, of the first d ones 1 - rho^d.
    scene::Scene scene = emptyScene();
    addObject(scene, scene::makeBox({2, 3, 4}), addMaterial(scene, kRho, 0, 1.5, 0, 1 - static_cast<float>(kRho)),
              dmat4(1));
    const TracedScene traced(scene);
    for (const int depth : {1, 5, 16})
        for (int i = 0; i < 50; ++i) {
            const dvec3 toward(std::cos(i), std::sin(0.7 * i), std::sin(i));
            const RayTree tree = traced.tree({0.1, -0.2, 0.3}, dvec3(0.1, -0.2, 0.3) + toward, {.depth = depth});
            ASSERT_EQ(tree.levels(), depth + 1);
            EXPECT_NEAR(tree.root().intensity.x, 1 - std::pow(kRho, depth + 1), 1e-12);
        }
}

/// A lit scene before the plane z = 0, all of it at z > 0.
scene::Scene litScene() {
    scene::Scene scene = testing::moved(testing::simpleScene(), {0, 0, 8});
    scene.materials[0].specular = vec3(0.2f);
    scene.background = vec3(0.2f, 0.3f, 0.4f);
    return scene;
}

TEST(RayTree, AMirrorShowsTheSceneFromItsOtherSide) {
    const TracedScene plain(litScene());
    scene::Scene withMirror = litScene();
    addObject(withMirror, scene::makeQuad({64, 64}), addMaterial(withMirror, 1, 0), upright({0, 0, 0}));
    const TracedScene mirrored(withMirror);
    // Odd numbers, so that no ray passes exactly through an edge.
    const dvec3 eyeWorld(0.5137, 4.0211, 15), behindWorld(0.5137, 4.0211, -15);
    int same = 0, shadowed = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 60; ++x) {
            const dvec3 onMirrorWorld(-1.5 + 4 * (x + 0.5) / 60, 0.6 + 1.5 * (y + 0.5) / 60, 0);
            const dvec3 beyondWorld = 2.0 * onMirrorWorld - behindWorld;
            const RayTree image = mirrored.tree(eyeWorld, onMirrorWorld, {.depth = 2});
            // From behind the plane, where no mirror stands.
            const RayTree direct = plain.tree(behindWorld, beyondWorld, {.depth = 2});
            ASSERT_FALSE(image.nodes().empty());
            if (direct.nodes().empty()) continue;
            // The eye itself sees what stands between it and the mirror: another ray.
            if (image.root().end != RayEnd::splits) continue;
            ASSERT_EQ(image.nodes().size(), 2u);
            EXPECT_EQ(image.nodes()[1].point.primitive, direct.root().point.primitive);
            // Light and halfway vector come through the same doubles, but for a last rounding each.
            EXPECT_NEAR(glm::length(image.root().intensity - direct.root().intensity), 0, 1e-12);
            EXPECT_NEAR(image.nodes()[0].distance + image.nodes()[1].distance, direct.root().distance, 1e-12);
            ++same;
            shadowed += direct.lightsOf(direct.root())[0].visibility == trace::Visibility::shadowed;
        }
    EXPECT_GT(same, 1000);
    EXPECT_GT(shadowed, 20);
}

TEST(RayTree, StaysTheSameAMillionMetresAway) {
    scene::Scene scene = furnace();
    scene.background = vec3(0.1f, 0.2f, 0.4f);
    scene.materials[0].diffuse = vec3(0.5f);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), translation({2.5, 0.5, 1}));
    scene.lights.push_back(testing::pointLight({1, 5, 3}));
    const dvec3 offset(1e6, -1e6, 1e6);
    const TracedScene here(scene), there(testing::moved(scene, offset));
    int trees = 0, different = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const dvec3 eyeWorld(0.3, 2.5, 6), targetWorld(-3 + 6 * (x + 0.5) / 80, -0.5 + 4 * (y + 0.5) / 60, 0);
            const TreeSettings settings{.depth = 6, .cutoff = 0.01};
            const RayTree a = here.tree(eyeWorld, targetWorld, settings);
            const RayTree b = there.tree(eyeWorld + offset, targetWorld + offset, settings);
            if (a.nodes().empty() || b.nodes().empty()) continue;
            ++trees;
            different += glm::length(a.root().intensity - b.root().intensity) > 1e-6;
        }
    EXPECT_GT(trees, 2000);
    // The eye is 1.2e-10 m off there: a ray that passes an edge so closely goes another way. None is expected.
    EXPECT_LE(different, 2);
}

// Beside the place where a ray is reflected stands a wall, nearer than any epsilon.
TEST(RayTree, NoRaySlipsThroughAWallBesideItsStart) {
    scene::Scene scene = emptyScene();
    addObject(scene, scene::makeQuad({4, 4}), addMaterial(scene, 1, 0), dmat4(1));
    constexpr double kThin = 1e-6;
    addObject(scene, scene::makeBox({kThin, 1, 1}), addMaterial(scene, 0, 0, 1.5, 0, 1),
              translation({1.5 * kThin, 0, 0}));
    const TracedScene traced(scene);
    const dvec3 eyeWorld(-1, 1, 0.1), targetWorld(0, 0, 0.1);
    const RayTree tree = traced.tree(eyeWorld, targetWorld, {.depth = 2});
    ASSERT_EQ(tree.nodes().size(), 2u);
    EXPECT_EQ(tree.nodes()[1].end, RayEnd::lightSource);
    EXPECT_NEAR(tree.root().intensity.x, 1, 1e-12);
    // A ray that starts a little further on, as is usual, starts behind the wall.
    const TreeNode& wall = tree.nodes()[1];
    EXPECT_FALSE(traced.tracer().nextPoint(wall.fromCentred + 1e-4 * wall.u, trace::kNoPrimitive, wall.u));
}

TEST(RayTree, OfFacesInOnePlaneTheLaterIsSeenDirectlyAndInAMirror) {
    for (const bool redFirst : {false, true}) {
        scene::Scene scene = emptyScene();
        const std::uint32_t red = addMaterial(scene, 0, 0, 1.5, 0, 1), green = addMaterial(scene, 0, 0, 1.5, 0, 2);
        addObject(scene, scene::makeQuad({4, 4}), addMaterial(scene, 1, 0), translation({0, 3, 0}));
        addObject(scene, scene::makeQuad({4, 4}), redFirst ? red : green, dmat4(1));
        addObject(scene, scene::makeQuad({4, 4}), redFirst ? green : red, dmat4(1));
        const TracedScene traced(scene);
        const double expected = redFirst ? 2 : 1;
        for (int i = 0; i < 100; ++i) {
            const dvec3 eyeWorld(0.01 * i - 0.5, 1, 0.3), downWorld(0.3, 0, 0.007 * i), upWorld(0.2, 3, 0.004 * i);
            EXPECT_EQ(traced.tree(eyeWorld, downWorld, {.depth = 2}).root().intensity.x, expected);
            EXPECT_EQ(traced.tree(eyeWorld, upWorld, {.depth = 2}).root().intensity.x, expected);
        }
    }
}

// Coarse things with smooth normals: near their rims these point far away from the triangles.
TEST(RayTree, RaysStayOnTheirSideOfTheTriangle) {
    scene::Scene scene = emptyScene();
    const std::uint32_t glass = addMaterial(scene, 0.04, 0.96);
    addObject(scene, scene::makeSphere(1, 8), glass, translation({-1.2, 1, 0}));
    addObject(scene, scene::makeTorus(0.8, 0.4, {8, 6}), glass, translation({1, 1, 0}));
    const TracedScene traced(scene);
    int splits = 0, bentByTheTriangle = 0;
    forRays(traced, {.depth = 4, .cutoff = 1e-3}, [&](const RayTree& tree) {
        for (const TreeNode& node : tree.nodes()) {
            if (node.end != RayEnd::splits) continue;
            ++splits;
            const dvec3 flatWorld = traced.surfaces().geometricNormalWorld(node.point);
            if (node.reflection >= 0) {
                EXPECT_GT(glm::dot(node.reflectedWorld, flatWorld), 0);
                bentByTheTriangle += glm::dot(reflected(node.u, node.normalWorld), flatWorld) <= 0;
            }
            if (node.refractedWorld != dvec3(0)) {
                EXPECT_LT(glm::dot(node.refractedWorld, flatWorld), 0);
            }
        }
    });
    EXPECT_GT(splits, 1000);
    EXPECT_GT(bentByTheTriangle, 10) << "the case never came up";
}

TEST(RayTree, ItsVectorsAreThoseOfTheLecture) {
    scene::Scene scene = emptyScene();
    addObject(scene, scene::makeBox({8, 2, 8}), addMaterial(scene, 0.04, 0.96), translation({0, -1, 0}));
    scene.lights.push_back(testing::pointLight({1, 3, 0.5}));
    const TracedScene traced(scene);
    const RayTree tree = traced.tree({-1, 2, 0}, {0.1, 0, 0.2}, {.depth = 2});
    const TreeNode& root = tree.root();
    const dvec3 V = -root.u, N = root.normalWorld, L = tree.lightsOf(root)[0].towardWorld;
    EXPECT_NEAR(glm::length(N - dvec3(0, 1, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::dot(root.reflectedWorld, N), glm::dot(V, N), 1e-15);
    EXPECT_NEAR(glm::length(root.reflectedWorld + V - 2 * glm::dot(V, N) * N), 0, 1e-15);
    EXPECT_NEAR(glm::length(glm::cross(root.refractedWorld, N)), glm::length(glm::cross(V, N)) / 1.5, 1e-15);
    EXPECT_NEAR(glm::length(L - glm::normalize(dvec3(1, 3, 0.5) - dvec3(0.1, 0, 0.2))), 0, 1e-15);
    EXPECT_NEAR(glm::length(tree.lightsOf(root)[0].halfwayWorld - glm::normalize(L + V)), 0, 1e-15);
}

} // namespace
} // namespace shadowlab::ray_tracing
