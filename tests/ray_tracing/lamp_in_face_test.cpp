// Lamps that lie exactly in a face: the room is lit as by a lamp one millimetre before the face, whichever way its light is found.
// SPDX-License-Identifier: MIT
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/ray_tracing/sampling/sample_numbers.h"
#include "tests/radiosity/scene_room.h"
#include "tests/ray_tracing/tree_of.h"
#include "tests/support/area_lights.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::TracedScene;
using testing::translation;

// A lamp one millimetre nearer lights a point two metres away by up to a thousandth more; the task allows 0.5 % of the radiance.
constexpr double kMostError = 0.005;

/// A cube of 2 m with a corner at the origin, turned as a whole, and a lamp of 0.7 x 0.5 m that far before its upper side.
scene::Scene litRoom(const dmat4& turn, double gap) {
    scene::Scene scene = testing::emptyRoom({2, 2, 2});
    for (scene::Object& object : scene.objects)
        object.worldFromObject = turn * object.worldFromObject;
    scene::Light lamp =
        testing::rectLight(transformPoint(turn, dvec3(0.9, 2 - gap, 1.1)), transformDirection(turn, dvec3(0.7, 0, 0)),
                           transformDirection(turn, dvec3(0, 0, 0.5)));
    lamp.intensity = 10;
    scene.lights = {lamp};
    scene::addEmitterSurfaces(scene);
    return scene;
}

/// The same with a shining quad in the place of the lamp.
scene::Scene roomWithEmitter(const dmat4& turn, double gap, bool isFirst) {
    scene::Scene scene = testing::emptyRoom({2, 2, 2});
    const std::uint32_t shining = testing::addMaterial(scene, 0, 0, 1.5, 0, 10);
    scene.materials[shining].emits = scene::EmittingSides::front;
    testing::addObject(scene, scene::makeQuad({0.7, 0.5}), shining,
                       translation({0.9, 2 - gap, 1.1}) * glm::rotate(dmat4(1), glm::radians(180.0), dvec3(1, 0, 0)));
    if (isFirst) std::rotate(scene.objects.begin(), scene.objects.end() - 1, scene.objects.end());
    for (scene::Object& object : scene.objects)
        object.worldFromObject = turn * object.worldFromObject;
    return scene;
}

/// The mean radiance, over so many samples, of some places on floor and walls as they are seen from the middle of the room. Numbers
/// are the same for every room: of two nearly equal ones the noise is nearly equal, too.
std::vector<double> radiances(const scene::Scene& scene, const dmat4& turn, const TreeSettings& settings, int samples) {
    const TracedScene traced(scene);
    const AnalyticLights analytic(traced.tracer());
    const dvec3 eye = traced.centred(transformPoint(turn, dvec3(1, 1, 1)));
    std::vector<double> found;
    for (const dvec3& place : {dvec3(0.8, 0, 1.2), dvec3(0.1, 0, 0.2), dvec3(0, 1, 1.1), dvec3(0, 1.9, 0.7),
                               dvec3(1.3, 1.8, 0), dvec3(2, 0.4, 1.5), dvec3(1.9, 1.97, 2)}) {
        const dvec3 u = glm::normalize(traced.centred(transformPoint(turn, place)) - eye);
        const trace::SurfacePoint first = traced.tracer().nextPoint(eye, trace::kNoPrimitive, u);
        double sum = 0;
        for (int i = 0; i < samples; ++i) {
            const SampleNumbers numbers({samples, SamplePattern::Spread::lowDiscrepancy, 1, 3},
                                        {static_cast<int>(found.size()), 0}, static_cast<std::uint32_t>(i));
            RayTree tree;
            tree.trace({traced.surfaces(), trace::MovingScene(traced.tracer()), 0, &numbers, &analytic}, settings, eye,
                       u, first, {});
            sum += tree.root().intensity.x;
        }
        found.push_back(sum / samples);
    }
    return found;
}

void expectAlike(const std::vector<double>& in, const std::vector<double>& before, const char* how) {
    ASSERT_EQ(in.size(), before.size());
    double sumIn = 0, sumBefore = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
        EXPECT_GT(before[i], 0.005) << how << " place " << i;
        sumIn += in[i], sumBefore += before[i];
    }
    EXPECT_NEAR(sumIn / sumBefore, 1, kMostError) << how;
}

/// As it stands, lying on each side, and turned so that no number of the file is round.
std::vector<dmat4> turns() {
    const auto about = [](double degrees, const dvec3& axis) {
        return glm::rotate(dmat4(1), glm::radians(degrees), axis);
    };
    return {dmat4(1), about(90, {1, 0, 0}), about(-90, {0, 0, 1}),
            translation({3.3, -7.7, 1.9}) * about(33, {1, 0, 0}) * about(21, {0, 1, 0.3})};
}

TEST(LampInFace, LightsTheRoomAsOneAMillimetreBeforeIt) {
    for (const dmat4& turn : turns()) {
        TreeSettings sampled;
        sampled.areaLights = AreaLights::sampled;
        TreeSettings analytic;
        analytic.areaLights = AreaLights::analytic;
        TreeSettings traced = sampled;
        traced.interreflection = true;
        traced.depth = 4;
        for (const auto& [settings, samples, how] :
             {std::tuple(sampled, 256, "sampled"), std::tuple(analytic, 1, "analytic"),
              std::tuple(traced, 512, "path-traced")}) {
            const auto in = radiances(litRoom(turn, 0), turn, settings, samples);
            const auto before = radiances(litRoom(turn, 1e-3), turn, settings, samples);
            expectAlike(in, before, how);
            if (settings.interreflection) continue; // one other hit of a ray is seen at a place, not in the sum
            for (std::size_t i = 0; i < in.size(); ++i)
                EXPECT_NEAR(in[i] / before[i], 1, i < 3 ? kMostError : 0.06)
                    << how << " place " << i; // walls near the lamp
        }
    }
}

TEST(LampInFace, AnEmitterShinesAsOneAMillimetreBeforeIt) {
    TreeSettings settings;
    settings.interreflection = true;
    settings.depth = 3;
    constexpr int kSamples =
        16384; // some hundred of which flip at the emitter's edge: less than a thousandth of the sum
    for (const dmat4& turn : turns())
        for (const bool isFirst : {true, false})
            expectAlike(radiances(roomWithEmitter(turn, 0, isFirst), turn, settings, kSamples),
                        radiances(roomWithEmitter(turn, 1e-3, isFirst), turn, settings, kSamples), "emitter");
}

/// The share of the lamp that the middle of the floor sees.
double shareSeen(const scene::Scene& scene) {
    const TracedScene traced(scene);
    const trace::AreaVisibility area(traced.tracer(), 0);
    return area.share(testing::surfacePointAt(traced.tracer(), 0, {1, 0, 1}));
}

TEST(LampInFace, AFaceBeforeTheLampHidesIt) {
    EXPECT_EQ(shareSeen(litRoom(dmat4(1), 0)), 1);
    EXPECT_EQ(shareSeen(litRoom(dmat4(1), 1e-9)), 1);
    EXPECT_EQ(shareSeen(litRoom(dmat4(1), -1e-9)), 0) << "a nanometre behind the ceiling";
}

// 548.8 is no float: the vertices lie 1.2e-5 below the lamp, or above it.
TEST(LampInFace, NumbersOfAMeshMayBeRounded) {
    scene::Scene scene = testing::emptyRoom({2, 2, 2});
    scene.objects.erase(scene.objects.begin() + 1);
    const double height = 548.8;
    EXPECT_NE(static_cast<double>(static_cast<float>(height)), height);
    testing::addObject(scene, testing::triangleSoup({{0, height, 0}, {556, height, 0}, {556, height, 559.2}}));
    scene::Light lamp = testing::rectLight({340, height, 210}, {130, 0, 0}, {0, 0, 105});
    scene.lights = {lamp};
    const std::vector<std::int8_t> signs = scene::facingSigns(scene, scene.lights[0]);
    EXPECT_EQ(signs.back(), 0);
    const TracedScene traced(scene);
    EXPECT_EQ(traced.tracer().castersFor(0).back(), 0);
    EXPECT_EQ(traced.tracer().castersFor(trace::SceneTracer::kAnyLight).back(), 1);
    scene.lights[0].positionWorld.y += 1e-3;
    EXPECT_EQ(TracedScene(scene).tracer().castersFor(0).back(), 1) << "a millimetre is no rounding";
}

// A panel over a floor shines down alone; as a tube of light it shines up, too.
TEST(Emission, LeavesTheFrontOrBothSides) {
    scene::Scene scene = testing::floorScene();
    const std::uint32_t shining = testing::addMaterial(scene, 0, 0, 1.5, 0, 6);
    scene.materials[shining].emits = scene::EmittingSides::front;
    testing::addObject(scene, scene::makeQuad({1, 1}), shining,
                       translation({0, 2, 0}) * glm::rotate(dmat4(1), glm::radians(180.0), dvec3(1, 0, 0)));
    const auto seenFrom = [&](double height) {
        const TracedScene traced(scene);
        return traced.tree({0.1, height, 0.2}, {0.1, 2, 0.2}, {}).root().intensity.x;
    };
    EXPECT_EQ(seenFrom(1), 6);
    EXPECT_EQ(seenFrom(3), 0);
    scene.materials[shining].emits = scene::EmittingSides::both;
    EXPECT_EQ(seenFrom(1), 6);
    EXPECT_EQ(seenFrom(3), 6);
    scene.materials[shining].emits = scene::EmittingSides::front;
    scene.objects[1].worldFromObject[0] *= -1.0; // mirrored, it still faces down
    EXPECT_EQ(seenFrom(1), 6);
    EXPECT_EQ(seenFrom(3), 0);
}

} // namespace
} // namespace shadowlab::ray_tracing
