// Light of emitters that is followed along paths, held against integrals over closed forms.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/path_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "tests/radiosity/prepared.h"
#include "tests/radiosity/quasirandom.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/area_lights.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kEmitted = 2 * glm::pi<double>(); ///< W/m^2: a radiance of 2
constexpr double kGap = 0.03, kWidth = 0.6, kHeight = 0.9, kReflected = 0.7;

/// A room of 4 x 3 x 4 m. Objects 0 to 3 and 5 are dull, 4 is the wall at x = 0.
scene::Scene roomOf(double reflectance, double ofWall) {
    scene::Scene scene = emptyRoom({4, 3, 4});
    scene.materials.resize(3);
    scene.materials[0].diffuse = vec3(static_cast<float>(reflectance));
    scene.materials[1].diffuse = vec3(static_cast<float>(ofWall));
    scene.materials[2].diffuse = vec3(0);
    scene.materials[2].emission = vec3(2);
    scene.objects[4].partMaterials = {1};
    return scene;
}

/// Before that wall a panel that shines at it and reflects nothing.
scene::Scene roomWithPanel(double reflectance) {
    scene::Scene scene = roomOf(reflectance, kReflected);
    addObject(scene, scene::makeQuad({kHeight, kWidth}), glm::rotate(translation({kGap, 1.5, 2}), glm::radians(90.0), dvec3(0, 0, 1))).partMaterials = {2};
    return scene;
}
constexpr std::uint32_t kWall = 4, kPanel = 6;

/// A lamp in the place of the panel.
scene::Scene roomWithLamp(double reflectance, const dvec2& size = {kWidth, kHeight}) {
    scene::Scene scene = roomOf(reflectance, kReflected);
    scene.lights.push_back(rectLight({kGap, 1.5, 2}, {0, 0, size.x}, {0, size.y, 0}));
    scene.lights[0].intensity = kEmitted / glm::pi<double>();
    scene::addEmitterSurfaces(scene);
    return scene;
}

/// About its middle, in a space of which x is the panel's own.
Polygon shiningPanel() {
    return {dvec3(0, -kHeight / 2, -kWidth / 2), dvec3(0, -kHeight / 2, kWidth / 2), dvec3(0, kHeight / 2, kWidth / 2), dvec3(0, kHeight / 2, -kWidth / 2)};
}

/// What gets out of the gap after one reflection, W. The wall sends rho E, and of that the panel takes back what it sends to the wall itself, E / M (reciprocity).
double wattsOutOfGap() {
    const Polygon shining = shiningPanel();
    constexpr int kCells = 400;
    constexpr double kHalf = 1.5, kCell = 2 * kHalf / kCells; // beyond it E is less than a ten-thousandth of M
    double watts = 0;
    for (int y = 0; y < kCells; ++y)
        for (int z = 0; z < kCells; ++z) {
            const double factor = pointFormFactor({-kGap, -kHalf + (y + 0.5) * kCell, -kHalf + (z + 0.5) * kCell}, {1, 0, 0}, shining);
            watts += kReflected * kEmitted * factor * (1 - factor) * kCell * kCell;
        }
    return watts;
}

/// Of what arrives at other surfaces than the wall and the panel, W.
double wattsAtOthers(const RoomCache& cache, std::span<const dvec3> irradiance) {
    double watts = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < cache.room().patches().size(); ++i) {
        const Patch& patch = cache.room().patches()[i];
        const std::uint32_t object = cache.room().faceOf(patch).object;
        if (object == kWall || object == kPanel) continue;
        watts += patch.area * irradiance[i].x;
        ++count;
    }
    EXPECT_GT(count, 20u);
    return watts;
}

// Of half a million paths a seventh gets out: chance is 0.4 % of that.
TEST(PathLight, WhatGetsOutOfAGapIsItsIntegral) {
    const double truth = wattsOutOfGap();
    EXPECT_GT(truth, 0.1);
    for (const int patches : {150, 600}) {
        const Prepared room(roomWithPanel(0), patches);
        ASSERT_FALSE(room.cache.pathLight().isEmpty());
        // The other surfaces reflect nothing, so all that reaches them comes by way of the wall; a little of it from patches that are not close to the panel.
        EXPECT_NEAR(wattsAtOthers(room.cache, room.balance.irradiance()) / truth, 1, 0.01) << patches;
        const Prepared byPatches(roomWithPanel(0), patches, RadiosityParams::Direct::patches);
        EXPECT_TRUE(byPatches.cache.pathLight().isEmpty());
        EXPECT_GT(wattsAtOthers(byPatches.cache, byPatches.balance.irradiance()) / truth, 1.05) << patches << ": it is 1.18 with 150 patches, and 1.08 with 600";
    }
}

// What the wall gets straight from the panel is a closed form at each of its points. A cell is met by some ten paths; a sixteenth of a patch has many cells.
TEST(PathLight, CellsKnowHowMuchArrivesWhere) {
    constexpr int kBlocks = 4, kPoints = 12; // on a side
    const Prepared room(roomWithPanel(0), 600);
    const Polygon shining = shiningPanel();
    const PathLight& paths = room.cache.pathLight();
    const dvec3 roomFromPanel = dvec3(kGap, 1.5, 2) - room.cache.room().world().originWorld;
    double ofCells = 0, ofMeans = 0, sum = 0;
    int compared = 0;
    for (std::uint32_t i = 0; i < room.cache.room().patches().size(); ++i) {
        const Patch& patch = room.cache.room().patches()[i];
        if (room.cache.room().faceOf(patch).object != kWall || !paths.hasCells(i)) continue;
        for (int block = 0; block < kBlocks * kBlocks; ++block, ++compared) {
            double found = 0, truth = 0;
            for (int p = 0; p < kPoints * kPoints; ++p) {
                const dvec2 in = dvec2(block % kBlocks, block / kBlocks) + (dvec2(p % kPoints, p / kPoints) + 0.5) / double{kPoints};
                const dvec3 at = evenPlaceIn(patch.polygon, in.x / kBlocks, in.y / kBlocks), fromPanel = at - roomFromPanel;
                found += paths.at(i, at).x;
                truth += kEmitted * pointFormFactor({-kGap, fromPanel.y, fromPanel.z}, {1, 0, 0}, shining);
            }
            ofCells += std::abs(found - truth);
            ofMeans += std::abs(kPoints * kPoints * room.sources.byPaths[i].x - truth);
            sum += truth;
        }
    }
    EXPECT_GT(compared, 500);
    EXPECT_LT(ofCells / sum, 0.06) << "it is 0.033: some ten cells of ten paths each";
    EXPECT_GT(ofMeans / sum, 0.08) << "it is 0.105: the case is too easy";
}

// A lamp takes back as much; without paths it lets it pass.
TEST(PathLight, SoItIsBehindALamp) {
    const double truth = wattsOutOfGap();
    for (const int patches : {150, 600}) {
        const Prepared room(roomWithLamp(0), patches);
        EXPECT_NEAR(wattsAtOthers(room.cache, room.balance.irradiance()) / truth, 1, 0.01) << patches;
        const Prepared byPatches(roomWithLamp(0), patches, RadiosityParams::Direct::patches);
        EXPECT_GT(wattsAtOthers(byPatches.cache, byPatches.balance.irradiance()) / truth, 5) << patches;
    }
}

/// What leaves the floor of that room after one reflection, W, if a ball of that radius rests on it, above the floor's middle: E = M F, of which the ball takes back E F.
double wattsFromBelowABall(double radius) {
    constexpr int kCells = 2000;
    constexpr double kCell = 4.0 / kCells;
    double watts = 0;
    for (int x = 0; x < kCells; ++x)
        for (int z = 0; z < kCells; ++z) {
            const double aside = glm::length(dvec2((x + 0.5) * kCell - 2, (z + 0.5) * kCell - 2)), distance = std::hypot(radius, aside);
            const double factor = std::pow(radius / distance, 3);
            watts += kReflected * kEmitted * factor * (1 - factor) * kCell * kCell;
        }
    return watts;
}

/// That room, with a ball at rest on the floor, which alone reflects.
scene::Scene roomWithBall(double radius) {
    scene::Scene scene = roomOf(0, kReflected);
    scene.objects[4].partMaterials = {0};
    scene.objects[0].partMaterials = {1}; // the floor
    scene.lights.push_back(sphereLight({2, radius, 2}, radius));
    scene.lights[0].intensity = kEmitted / glm::pi<double>();
    return scene;
}

/// What the floor reflects to other surfaces, W.
double reflectedWatts(const Prepared& room) {
    const std::vector<dvec3> arriving = room.balance.irradiance();
    double watts = 0;
    for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
        const Patch& patch = room.cache.room().patches()[i];
        if (room.cache.room().faceOf(patch).object != 0) watts += patch.area * (arriving[i].x - room.sources.fromLights[i].x);
    }
    return watts;
}

TEST(PathLight, SoItIsBelowABall) {
    constexpr double kRadius = 0.25;
    const double truth = wattsFromBelowABall(kRadius);
    scene::Scene scene = roomWithBall(kRadius);
    scene::addEmitterSurfaces(scene);
    for (const int patches : {150, 600}) {
        const Prepared room(scene, patches);
        ASSERT_TRUE(room.cache.followed().any());
        EXPECT_NEAR(reflectedWatts(room) / truth, 1, 0.01) << patches;
    }
}

/// The same by rays, with a plate in the plane x = 2.6 m, 0.6 m high and 1 m wide, that takes in what meets it, but lets the ball's own light pass.
double wattsPastAPlate(double radius) {
    constexpr int kCells = 160, kRays = 256;
    constexpr double kCell = 4.0 / kCells;
    const dvec3 ball(2, radius, 2);
    const auto isTaken = [&](const dvec3& from, const dvec3& direction) {
        const dvec3 aside = glm::cross(ball - from, direction);
        if (glm::dot(ball - from, direction) > 0 && glm::dot(aside, aside) < radius * radius) return true;
        const double way = (2.6 - from.x) / direction.x;
        const dvec3 at = from + way * direction;
        return way > 0 && at.y < 0.6 && std::abs(at.z - 2) < 0.5;
    };
    double watts = 0;
    for (int cell = 0; cell < kCells * kCells; ++cell) {
        const dvec3 from((cell % kCells + 0.5) * kCell, 0, (cell / kCells + 0.5) * kCell);
        int free = 0;
        for (int ray = 0; ray < kRays; ++ray) {
            const auto x = quasirandom4(ray + kRays * cell);
            const double square = x[0], turn = glm::two_pi<double>() * x[1], across = std::sqrt(square);
            free += isTaken(from, {across * std::cos(turn), std::sqrt(1 - square), across * std::sin(turn)}) ? 0 : 1;
        }
        watts += kReflected * kEmitted * std::pow(radius / glm::distance(from, ball), 3) * free / kRays * kCell * kCell;
    }
    return watts;
}

// A second lamp, a plate that stands on the floor beside the ball, sends next to nothing. It hides none of the ball's light from the floor, for lamps cast no shadow, but takes
// in what the floor reflects to it.
TEST(PathLight, LampsCastNoShadowOnWhatIsFollowed) {
    constexpr double kRadius = 0.25;
    scene::Scene scene = roomWithBall(kRadius);
    scene.lights.push_back(rectLight({2.6, 0.3, 2}, {0, 0.6, 0}, {0, 0, 1}));
    scene.lights[1].intensity = 1e-6;
    scene::addEmitterSurfaces(scene);
    const double truth = wattsPastAPlate(kRadius);
    EXPECT_LT(truth, 0.95 * wattsFromBelowABall(kRadius));
    const Prepared room(scene, 600);
    double beyond = 0; // of the ball's light, what arrives there and is followed
    for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
        const Patch& patch = room.cache.room().patches()[i];
        if (room.cache.isFollowed(i) && patch.centre.x + room.cache.room().world().originWorld.x > 2.6) beyond += patch.area * room.sources.fromLights[i].x;
    }
    EXPECT_GT(beyond, 0.1 * truth);
    EXPECT_NEAR(reflectedWatts(room) / truth, 1, 0.02) << "0.95 if the plate hid it";
}

// Where the lamp goes elsewhere, nothing is followed any more, and back there it is as before.
TEST(PathLight, FollowsALampThatMoves) {
    Prepared room(roomWithLamp(0.5, {0.3, 0.3}), 600);
    const std::vector<dvec3> before = room.cache.pathLight().irradiance;
    ASSERT_FALSE(before.empty());
    const auto lampAt = [&](double x) {
        scene::Light lamp = room.snapshot->lights[0];
        lamp.positionWorld.x = x;
        while (!room.cache.advance(scene::withLights(room.snapshot, {lamp}), room.params, Deadline::max())) {
        }
    };
    lampAt(2);
    EXPECT_FALSE(room.cache.followed().any());
    EXPECT_TRUE(room.cache.pathLight().isEmpty());
    lampAt(kGap);
    EXPECT_TRUE(std::ranges::equal(room.cache.pathLight().irradiance, before));
}

// What is emitted is absorbed, in a closed room: paths end on some patch each.
TEST(PathLight, NothingIsLostInAClosedRoom) {
    const Prepared room(roomWithPanel(0.5), 600);
    ASSERT_FALSE(room.cache.pathLight().isEmpty());
    const EnergyBalance& energy = room.balance.energy();
    EXPECT_NEAR(energy.emitted.x, kEmitted * kWidth * kHeight, 1e-6);
    EXPECT_NEAR(energy.closedResidual().x, 0, 0.003) << "what half a million paths leave to chance is a thousandth";
    EXPECT_NEAR(energy.residual().x, 0, 1e-3) << "the equations are solved";
}

// The equations hold for what they have, and paths for the rest.
TEST(PathLight, TheSolutionSolvesTheEquations) {
    const Prepared room(roomWithPanel(0.5), 300);
    const std::vector<dvec3> exchanged = room.balance.exchanged(), arriving = room.balance.irradiance();
    std::size_t apart = 0;
    for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
        EXPECT_NEAR(room.balance.radiosity()[i].x, room.sources.emission[i].x + room.sources.reflectance[i].x * arriving[i].x, 1e-4) << "solved to 1e-6 of the largest radiosity, some 6 W/m^2";
        if (room.cache.isFollowed(i)) {
            ++apart;
            EXPECT_GE(room.balance.radiosity()[i].x, exchanged[i].x);
        } else {
            EXPECT_EQ(room.balance.radiosity()[i], exchanged[i]);
        }
    }
    EXPECT_GT(apart, 2u);
}

// Where nothing is close to it, and its mesh is its own, an emitter is a patch like any other.
TEST(PathLight, InTheMiddleOfARoomNothingIsFollowed) {
    scene::Scene scene = roomWithPanel(0.5);
    scene.objects[kPanel].worldFromObject = glm::rotate(translation({2, 1.5, 2}), glm::radians(90.0), dvec3(0, 0, 1));
    const Prepared room(std::move(scene), 600);
    EXPECT_FALSE(room.cache.followed().any());
    EXPECT_TRUE(room.cache.pathLight().isEmpty());
}

/// Irradiance at the middle of the wall that the axis of a ring meets, W/m^2: the form factors of all triangles that face it. None hides another from there.
double irradianceOnAxis(const scene::Mesh& ring, double distance) {
    double sum = 0;
    for (const uvec3& triangle : ring.triangles) {
        const dvec3 a(ring.positionsMesh[triangle.x]), b(ring.positionsMesh[triangle.y]), c(ring.positionsMesh[triangle.z]);
        const Polygon polygon{a, b, c};
        const dvec3 from(0, distance, 0);
        if (planeOf(polygon).height(from) > 0) sum += kEmitted * pointFormFactor(from, {0, -1, 0}, polygon);
    }
    return sum;
}

// A ring that is simplified to a few edges shines more along its axis than it should.
TEST(PathLight, ASimplifiedRingShinesAsItsMeshDoes) {
    scene::Scene scene = roomOf(0, 0);
    const scene::Mesh ring = scene::makeTorus(0.4, 0.03, {64, 32});
    addObject(scene, ring, glm::rotate(translation({1.5, 1.5, 2}), glm::radians(90.0), dvec3(0, 0, 1))).partMaterials = {2};
    const double truth = irradianceOnAxis(ring, 1.5);
    const auto onAxis = [&](RadiosityParams::Direct direct) { // mean over the patches of the wall at x = 0 within that circle
        constexpr double kRadius = 0.35;
        const Prepared room(scene, 600, direct);
        const std::vector<dvec3> irradiance = room.balance.irradiance();
        double sum = 0, area = 0;
        for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
            const Patch& patch = room.cache.room().patches()[i];
            const dvec3 centre = patch.centre + room.cache.room().world().originWorld;
            if (room.cache.room().faceOf(patch).object != kWall || glm::distance(centre, dvec3(0, 1.5, 2)) > kRadius) continue;
            sum += patch.area * irradiance[i].x;
            area += patch.area;
        }
        EXPECT_GT(area, 0.1);
        return sum / area / truth;
    };
    EXPECT_NEAR(onAxis(RadiosityParams::Direct::pixels), 1, 0.02);
    EXPECT_GT(std::abs(onAxis(RadiosityParams::Direct::patches) - 1), 0.05) << "it is 0.44 too bright";
}

/// An open bowl with a flat bottom, of which one sees both sides.
scene::Mesh bowl() {
    constexpr int kSegments = 24;
    const std::array<dvec2, 5> profile = {dvec2(0, 0), {0.3, 0}, {0.42, 0.2}, {0.5, 0.5}, {0.52, 0.8}}; // radius and height
    const auto place = [&](int segment, std::size_t ring) {
        const double angle = 2 * M_PI * segment / kSegments;
        return dvec3(profile[ring].x * std::cos(angle), profile[ring].y, profile[ring].x * std::sin(angle));
    };
    std::vector<dvec3> corners;
    for (int segment = 0; segment < kSegments; ++segment)
        for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
            const dvec3 a = place(segment, ring), b = place(segment + 1, ring), c = place(segment + 1, ring + 1), d = place(segment, ring + 1);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
    return triangleSoup(corners);
}

// Where contacts cut slivers out of a simplified mesh, a path may end nearest to one of them. Nowhere arrives more than the place of the ceiling sends that gets most.
TEST(PathLight, SliversOfSimplifiedMeshesGetNoMoreThanTheirNeighbours) {
    scene::Scene scene = roomOf(0.7, 0.7);
    addObject(scene, scene::makeBox({1.6, 0.7, 1.2}), translation({2, 0.35, 1.5}));
    addObject(scene, bowl(), translation({2, 0.7, 1.5}));
    addObject(scene, scene::makeSphere(0.15, 48), translation({2, 0.9, 1.5}));
    scene.lights.push_back(sphereLight({2.9, 2.7, 1.8}, 0.15));
    scene::addEmitterSurfaces(scene);
    const Prepared room(std::move(scene), 600);
    ASSERT_TRUE(room.cache.followed().any());
    const double most = 0.7 * glm::pi<double>() * room.snapshot->lights[0].intensity;
    std::size_t slivers = 0, lit = 0;
    for (std::size_t i = 0; i < room.cache.room().patches().size(); ++i) {
        const Patch& patch = room.cache.room().patches()[i];
        slivers += patch.area < 1e-5;
        lit += room.cache.pathLight().irradiance[i].x > 1e-3 * most;
        EXPECT_LT(room.cache.pathLight().irradiance[i].x, most) << patch.area;
    }
    EXPECT_GT(slivers, 3u);
    EXPECT_GT(lit, 30u);
}

} // namespace
} // namespace shadowlab::radiosity
