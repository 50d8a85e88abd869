// Solids in solids, overlapping solids, and an eye inside of them: which indices of refraction a ray meets, and that it leaves
// a stack of parallel slabs as it came.
// SPDX-License-Identifier: MIT
#include "tests/ray_tracing/tree_of.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::addMaterial;
using testing::addObject;
using testing::TracedScene;
using testing::translation;

// Deep enough for every stack here, and every branch is followed.
const TreeSettings kAll{.depth = 8};

/// Between two heights, wide enough to be endless.
void addSlab(scene::Scene& scene, double lower, double upper, double ior, int priority) {
    const std::uint32_t material = addMaterial(scene, 0, 1, ior, priority);
    addObject(scene, scene::makeBox({64, upper - lower, 64}), material, translation({0, 0.5 * (lower + upper), 0}));
}

/// By how much a slab shifts a ray that comes at 45 degrees: t sin(a - b) / cos b.
double shiftOf(double thickness, double ior) {
    const double a = std::asin(std::sqrt(0.5)), b = std::asin(std::sqrt(0.5) / ior);
    return thickness * std::sin(a - b) / std::cos(b);
}

const dvec3 kEyeWorld(-3, 3, 0), kTargetWorld(0, 0, 0); // 45 degrees

double shiftAt(const TracedScene& traced, const TreeNode& last) {
    const dvec3 originWorld = traced.tracer().world().originWorld + last.fromCentred;
    const dvec3 u = glm::normalize(kTargetWorld - kEyeWorld);
    return glm::length(glm::cross(originWorld - kEyeWorld, u));
}

TEST(NestedMedia, ASlabShiftsARayAndDoesNotTurnIt) {
    for (const bool mirrored : {false, true})
        for (const double offset : {0.0, 1e6}) {
            scene::Scene scene;
            scene.materials.emplace_back();
            addSlab(scene, -0.5, 0.5, 1.5, 0);
            if (mirrored) scene.objects[0].worldFromObject[0][0] = -1; // its triangles turn inside out
            const dvec3 moved(offset, -offset, offset);
            const TracedScene traced(testing::moved(scene, moved));
            const RayTree tree = traced.tree(kEyeWorld + moved, kTargetWorld + moved, kAll);
            const auto chain = testing::refractions(tree);
            ASSERT_EQ(chain.size(), 3u);
            EXPECT_EQ(chain[2].end, RayEnd::nothingHit);
            // A millionth of a metre in a million: coordinates there have steps of 1.2e-10.
            EXPECT_NEAR(glm::length(chain[2].u - chain[0].u), 0, offset == 0 ? 1e-12 : 1e-9);
            const dvec3 across = traced.tracer().world().originWorld + chain[2].fromCentred - kEyeWorld - moved;
            EXPECT_NEAR(glm::length(glm::cross(across, chain[0].u)), 0.3291423082, offset == 0 ? 1e-9 : 1e-8);
            EXPECT_NEAR(shiftOf(1, 1.5), 0.3291423082, 1e-10);
        }
}

/// Three slabs that reach into one another, the lower index of refraction in the middle.
scene::Scene overlappingSlabs() {
    scene::Scene scene;
    scene.materials.emplace_back();
    addSlab(scene, 0, 1, 1.5, 2);
    addSlab(scene, -1, 0.25, 1.33, 1);  // a quarter of it is in the first, which wins
    addSlab(scene, -2, -0.875, 1.8, 3); // wins over the second
    return scene;
}

const double kOverlappingShift = shiftOf(1, 1.5) + shiftOf(0.875, 1.33) + shiftOf(1.125, 1.8);

TEST(NestedMedia, WhereSlabsOverlapTheHigherPriorityCounts) {
    const TracedScene traced(overlappingSlabs());
    const auto chain = testing::refractions(traced.tree(kEyeWorld, kTargetWorld, kAll));
    ASSERT_EQ(chain.size(), 5u) << "four surfaces are really there";
    const double iors[] = {1, 1.5, 1.33, 1.8, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(chain[i].iorHere, iors[i]) << i;
        EXPECT_EQ(chain[i].iorBeyond, iors[i + 1]) << i;
    }
    EXPECT_NEAR(glm::length(chain[4].u - chain[0].u), 0, 1e-12);
    EXPECT_NEAR(shiftAt(traced, chain[4]), kOverlappingShift, 1e-9);
}

// What a tracer without priorities makes of it: every surface lies between its own solid and empty space.
TEST(NestedMedia, WithoutPrioritiesTheWayIsAnother) {
    const TracedScene traced(overlappingSlabs());
    dvec3 u = glm::normalize(kTargetWorld - kEyeWorld), last(0.0);
    const Surfaces& surfaces = traced.surfaces();
    trace::SurfacePoint point = traced.tracer().nextPoint(traced.centred(kEyeWorld), trace::kNoPrimitive, u);
    int surfacesMet = 0;
    for (; point; point = traced.tracer().nextPoint(point, u)) {
        const double ior = surfaces.mediumOf(point).ior;
        const auto bent = refracted(u, surfaces.geometricNormalWorld(point), surfaces.isEntered(point) ? 1 / ior : ior);
        ASSERT_TRUE(bent);
        u = *bent;
        last = traced.tracer().positionWorld(point);
        ++surfacesMet;
    }
    EXPECT_EQ(surfacesMet, 6);
    const double shift = glm::length(glm::cross(last - kEyeWorld, glm::normalize(kTargetWorld - kEyeWorld)));
    EXPECT_GT(std::abs(shift - kOverlappingShift), 0.01);
}

/// Balls one in the other: glass, water in it, and a bubble in the water; the eye looks through their common middle.
scene::Scene ballsInBalls(int waterPriority) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeSphere(1, 64), addMaterial(scene, 0, 1, 1.5, 0), dmat4(1));
    addObject(scene, scene::makeSphere(0.6, 64), addMaterial(scene, 0, 1, 1.33, waterPriority), dmat4(1));
    addObject(scene, scene::makeSphere(0.3, 64), addMaterial(scene, 0, 1, 1, 1), dmat4(1));
    return scene;
}

std::vector<double> iorsAlong(const TracedScene& traced, const dvec3& eyeWorld) {
    // Aside of the middle, where the vertices of the poles and of the seam are not met.
    const auto chain =
        testing::refractions(traced.tree(eyeWorld, {0.011, 0.017, 0.013}, {.depth = 12, .cutoff = 1e-3}));
    std::vector<double> iors;
    for (const TreeNode& node : chain)
        if (node.end == RayEnd::splits) iors.push_back(node.iorHere);
    iors.push_back(chain.back().media.ior());
    EXPECT_EQ(chain.back().end, RayEnd::nothingHit);
    return iors;
}

TEST(NestedMedia, BallsInBalls) {
    // Of equal priority the inner ball counts, being entered last.
    for (const int priority : {0, 1}) {
        const TracedScene traced(ballsInBalls(priority));
        EXPECT_EQ(iorsAlong(traced, {0.1, 0.2, 4}), (std::vector<double>{1, 1.5, 1.33, 1, 1.33, 1.5, 1}));
    }
    // Of lower priority than the glass around it the water is not there; the bubble is.
    const TracedScene traced(ballsInBalls(-1));
    EXPECT_EQ(iorsAlong(traced, {0.1, 0.2, 4}), (std::vector<double>{1, 1.5, 1, 1.5, 1}));
}

TEST(NestedMedia, TheEyeInside) {
    const TracedScene traced(ballsInBalls(0));
    EXPECT_EQ(iorsAlong(traced, {0.1, 0.1, 0.8}), (std::vector<double>{1.5, 1.33, 1, 1.33, 1.5, 1}));
    EXPECT_EQ(iorsAlong(traced, {0.1, 0.1, 0.45}), (std::vector<double>{1.33, 1, 1.33, 1.5, 1}));
    EXPECT_EQ(iorsAlong(traced, {0.01, 0.02, 0.1}), (std::vector<double>{1, 1.33, 1.5, 1}));
    EXPECT_EQ(traced.surfaces().mediaAround(traced.centred({0, 3, 0})).ior(), 1);
}

TEST(NestedMedia, LeavingWhatWasNeverEnteredIsLeavingIt) {
    DielectricStack stack;
    const Medium glass{7, 0, 1.5}, water{8, -1, 1.33};
    const Crossing out = stack.crossing(glass, false);
    EXPECT_EQ(out.iorHere, 1.5);
    EXPECT_EQ(out.iorBeyond, 1);
    EXPECT_TRUE(out.isReal);
    stack.cross(glass, false);
    EXPECT_EQ(stack.ior(), 1);
    stack.cross(glass, true);
    EXPECT_FALSE(stack.crossing(water, true).isReal);
    stack.cross(water, true);
    EXPECT_EQ(stack.ior(), 1.5);
    EXPECT_EQ(stack.crossing(glass, false).iorBeyond, 1.33);
    stack.cross(glass, false);
    EXPECT_EQ(stack.ior(), 1.33);
    EXPECT_TRUE(stack.holds(water));
    EXPECT_FALSE(stack.holds(glass));
}

TEST(NestedMedia, ASheetDoesNotBend) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({8, 8}), addMaterial(scene, 0, 1), dmat4(1));
    const TracedScene traced(scene);
    const auto chain = testing::refractions(traced.tree(kEyeWorld, kTargetWorld + dvec3(0.1, 0, 0.2), kAll));
    ASSERT_EQ(chain.size(), 2u);
    EXPECT_EQ(chain[1].u, chain[0].u);
    EXPECT_EQ(chain[1].media.ior(), 1);
    EXPECT_NEAR(chain[0].weights.reflected + chain[0].weights.transmitted, 1, 1e-15);
    EXPECT_GT(chain[0].weights.reflected, 0.04);
}

} // namespace
} // namespace shadowlab::ray_tracing
