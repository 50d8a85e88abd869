// Rays to points of the patches from which light comes: their densities, and how much less noise they leave, beside gathers without them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/math/random_pair.h"
#include "techniques/radiosity/display/gather_rays.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "tests/radiosity/lone_mesh.h"
#include "tests/radiosity/prepared.h"
#include "tests/radiosity/quasirandom.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::radiosity {
namespace {

/// A room of 4 x 3 x 4 m, lit by nothing but a spot of light on its ceiling, with a box on its floor.
scene::Scene roomWithSpot() {
    scene::Scene scene = testing::emptyRoom({4, 3, 4});
    scene.materials[0].diffuse = vec3(0.6f);
    testing::addObject(scene, scene::makeBox({0.8, 0.6, 0.8}), testing::translation({2.6, 0.31, 2.2}));
    scene::Light spot = testing::pointLight({1.2, 1.4, 1.5});
    spot.type = scene::LightType::spot;
    spot.directionWorld = {0, 1, 0};
    spot.coneDegrees = 30;
    spot.edgeDegrees = 0;
    spot.intensity = 10;
    scene.lights = {spot};
    scene.camera.positionWorld = {0.4, 1.5, 3.8};
    scene.camera.targetWorld = {2.6, 0.6, 1};
    scene.camera.fovYDegrees = 60;
    return scene;
}

/// Solved, and what a picture of 64 x 36 pixels of it shows.
class SolvedRoom {
public:
    explicit SolvedRoom(scene::Scene scene) : prepared_(std::move(scene), 400) {
        reflected_ = prepared_.balance.irradianceShown();
        for (std::size_t i = 0; i < reflected_.size(); ++i)
            reflected_[i] -= prepared_.sources.fromLights[i];
        View view;
        view.camera = prepared_.snapshot->camera;
        view.size = {64, 36};
        while (!light_.advance(prepared_.snapshot, view, Deadline::max())) {
        }
        guide_ = GatherGuide(prepared_.cache, prepared_.sources, prepared_.balance.radiosity(), dvec3(0));
    }
    [[nodiscard]] const Room& room() const { return prepared_.cache.room(); }
    [[nodiscard]] const GatherGuide& guide() const { return guide_; }

    /// The irradiance of each pixel that shows something, green, W/m^2.
    [[nodiscard]] std::vector<double> gathered(const GatherGuide& guide, std::size_t rays) const {
        static const Openings kNone;
        const GatherSolution solution{prepared_.cache, prepared_.sources, guide, kNone, reflected_, dvec3(0), prepared_.balance.version()};
        std::vector<double> found;
        for (int y = 0; y < light_.size().y; ++y)
            for (int x = 0; x < light_.size().x; ++x)
                if (light_.pointAt({x, y}))
                    found.push_back(gather(solution, light_, {x, y}, {randomPair(pixelKey({x, y})), 0, rays}).irradiance.g / static_cast<double>(rays));
        return found;
    }

    /// Of the same pixels, in the world.
    [[nodiscard]] std::vector<dvec3> places() const {
        std::vector<dvec3> places;
        for (int y = 0; y < light_.size().y; ++y)
            for (int x = 0; x < light_.size().x; ++x)
                if (const trace::SurfacePoint& point = light_.pointAt({x, y})) places.push_back(light_.tracer().positionWorld(point));
        return places;
    }

private:
    testing::Prepared prepared_;
    std::vector<dvec3> reflected_;
    PixelLight light_;
    GatherGuide guide_;
};

const SolvedRoom& solvedRoom() {
    static const SolvedRoom room(roomWithSpot());
    return room;
}

// From what the spot lights itself most of the light comes from all sides; from everywhere else, out of the spot.
TEST(GatherGuide, LightIsUnevenWhereItComesOutOfASmallPlace) {
    const Room& room = solvedRoom().room();
    double uneven = 0, floor = 0, ceiling = 0;
    for (std::uint32_t i = 0; i < room.patches().size(); ++i) {
        const Patch& patch = room.patches()[i];
        const double height = patch.centre.y + room.world().originWorld.y;
        if (height < 0.01) floor += patch.area, uneven += solvedRoom().guide().isUneven(i) ? patch.area : 0;
        if (height > 2.99) ceiling += solvedRoom().guide().isUneven(i) ? patch.area : 0;
    }
    EXPECT_GT(floor, 14);
    EXPECT_GT(uneven, 0.9 * floor);
    EXPECT_EQ(ceiling, 0) << "it sees all that the spot lights";
}

/// A box on a floor under the open sky, and a plate that glows or not.
scene::Scene yardWithPlate(float emission) {
    scene::Scene scene = testing::floorScene();
    scene.materials.emplace_back().emission = vec3(emission);
    scene.materials[1].emits = scene::EmittingSides::both;
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.5, 0}));
    testing::addObject(scene, scene::makeQuad({0.2, 0.2}), testing::translation({0.8, 1, 0})).partMaterials = {1};
    scene.lights = {testing::pointLight({2, 3, 1})};
    return scene;
}

// So that rays are the same whatever the lights, and pictures by each of them add up.
TEST(GatherGuide, UnderTheOpenSkyOnlyWhatGlowsIsChosen) {
    const auto unevenArea = [](const SolvedRoom& yard) {
        double area = 0;
        for (std::uint32_t i = 0; i < yard.room().patches().size(); ++i)
            area += yard.guide().isUneven(i) ? yard.room().patches()[i].area : 0;
        return area;
    };
    EXPECT_EQ(unevenArea(SolvedRoom(yardWithPlate(0))), 0);
    EXPECT_GT(unevenArea(SolvedRoom(yardWithPlate(5))), 1);
}

/// The solid angle of a patch, sr, that nothing hides: by 32 x 32 points of it.
double solidAngle(const Patch& patch, const dvec3& fromCentred) {
    constexpr int kSide = 32;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const dvec3 way = evenPlaceIn(patch.polygon, (i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide) - fromCentred;
        const double distance = glm::length(way);
        sum += std::max(0.0, -glm::dot(way, patch.normal)) / (distance * distance * distance);
    }
    return patch.area * sum / (kSide * kSide);
}

// One over the density with which a direction was chosen, summed over the choices of points of a patch, is the solid angle in which it is seen; and for a ray
// in any direction that meets the point the density is the same.
TEST(GatherGuide, DirectionsAreChosenAsOftenAsTheirDensitySays) {
    const GatherGuide& guide = solvedRoom().guide();
    const Room& room = solvedRoom().room();
    const dvec3 origin = room.world().originWorld;
    constexpr int kChoices = 200'000;
    int rows = 0, patches = 0;
    for (std::uint32_t at = 0; at < room.patches().size(); at += 67) {
        const Patch& here = room.patches()[at];
        if (!guide.isUneven(at)) continue;
        ++rows;
        std::vector<double> angles(room.patches().size(), 0.0);
        std::vector<int> counts(room.patches().size(), 0);
        for (int i = 0; i < kChoices; ++i) {
            const auto x = testing::quasirandom4(i);
            const auto way = guide.choose(at, origin + here.centre, x[0], {x[1], x[2]});
            if (!way) continue;
            ASSERT_GT(way->density, 0);
            const dvec3 point = here.centre + way->distance * way->direction;
            const auto there = std::ranges::find_if(room.patches(), [&](const Patch& patch) {
                return std::abs(patch.plane().height(point)) < 1e-6 && glm::dot(way->direction, patch.normal) < 0 && holds(patch.polygon, point, patch.normal);
            });
            if (there == room.patches().end()) continue; // on an edge
            const auto patch = static_cast<std::uint32_t>(there - room.patches().begin());
            angles[patch] += 1 / way->density / kChoices;
            ++counts[patch];
            if (i % 100 != 0) continue;
            const GatherGuide::Found met{patch, way->distance, -glm::dot(way->direction, there->normal)};
            EXPECT_NEAR(guide.density(at, origin + here.centre, way->direction, met), way->density, 1e-6 * way->density);
        }
        for (std::uint32_t j = 0; j < room.patches().size(); ++j) {
            if (counts[j] < 1000) continue;
            const double angle = solidAngle(room.patches()[j], here.centre);
            EXPECT_NEAR(angles[j], angle, 0.03 * angle) << "a thousand choices, evenly spread, a fifth of them outside the spot";
            ++patches;
        }
    }
    EXPECT_GT(rows, 2);
    EXPECT_GT(patches, 30);
}

/// How much the mean over all pixels, and how much a pixel, is off, in units of that mean.
struct Off {
    double mean = 0, noise = 0;
};
Off off(const std::vector<double>& found, const std::vector<double>& exact) {
    double mean = 0, error = 0, square = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        mean += exact[i];
        error += found[i] - exact[i];
        square += (found[i] - exact[i]) * (found[i] - exact[i]);
    }
    return {error / mean, std::sqrt(square * static_cast<double>(exact.size())) / mean};
}

// Both kinds of rays together find the same light, and with far less noise than those in all directions alone.
void expectLessNoise(const SolvedRoom& room, double most) {
    const std::vector<double> exact = room.gathered(room.guide(), 1024), byChance = room.gathered(GatherGuide{}, 2048);
    ASSERT_GT(exact.size(), 2000u);
    EXPECT_NEAR(off(exact, byChance).mean, 0, 0.01) << "2304 pixels, with a noise of a quarter each at most";
    const Off alone = off(room.gathered(GatherGuide{}, 128), exact), guided = off(room.gathered(room.guide(), 64), exact);
    std::cout << "128 rays in all directions: mean " << 100 * alone.mean << " %, noise " << 100 * alone.noise << " %; 64 and 64 to chosen points: mean "
              << 100 * guided.mean << " %, noise " << 100 * guided.noise << " %\n";
    EXPECT_NEAR(guided.mean, 0, 0.01) << "2304 pixels with a noise of a tenth each";
    EXPECT_LT(guided.noise, most * alone.noise);
}

TEST(GatherGuide, ChosenPointsOfASpotTakeNoiseAway) { expectLessNoise(solvedRoom(), 0.3); }

/// The same room, lit by nothing but a glowing ball of thousands of triangles.
scene::Scene roomWithGlowingBall(const dvec3& radii) {
    scene::Scene scene = roomWithSpot();
    scene.lights.clear();
    scene.materials.emplace_back().emission = vec3(5);
    testing::addObject(scene, scene::makeSphere(1, 48), glm::scale(testing::translation({1.2, 2.2, 1.5}), radii)).partMaterials = {1};
    return scene;
}

TEST(GatherGuide, DirectionsToASimplifiedBallTakeNoiseAway) { expectLessNoise(SolvedRoom(roomWithGlowingBall({0.1, 0.1, 0.1})), 0.2); }
TEST(GatherGuide, PointsOfALongOneTakeNoiseAway) { expectLessNoise(SolvedRoom(roomWithGlowingBall({0.03, 0.03, 0.6})), 0.12); }

/// The same room, lit by nothing but a ring 1 m wide and 6 cm thick.
scene::Scene roomWithRing(const dvec3& middle) {
    scene::Scene scene = roomWithSpot();
    scene.lights.clear();
    scene.materials.emplace_back().emission = vec3(5);
    testing::addObject(scene, scene::makeTorus(0.5, 0.03, {64, 32}), testing::translation(middle)).partMaterials = {1};
    return scene;
}

TEST(GatherGuide, PointsOfARingTakeNoiseAway) { expectLessNoise(SolvedRoom(roomWithRing({2, 2.5, 2})), 0.25); }

// Simplified, a ring folds onto itself, and where it does, the patch that is nearest to a place may be the back of another part, which is dark. Above its middle nothing
// of a ring hides another part, and it brings what its triangles do, each by its closed form.
TEST(GatherGuide, ARingShinesFromAllOfItsSurface) {
    scene::Scene scene = roomWithRing({2, 2.5, 2});
    for (scene::Material& material : scene.materials)
        material.diffuse = vec3(0);
    scene.camera.positionWorld = {2, 2.6, 2};
    scene.camera.targetWorld = {2.01, 3, 2};
    const SolvedRoom room(scene);
    const std::vector<double> found = room.gathered(room.guide(), 256);
    const std::vector<dvec3> places = room.places();
    ASSERT_EQ(found.size(), 64u * 36u);
    const scene::Object& ring = scene.objects.back();
    double truth = 0, sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        sum += found[i];
        truth += 5 * glm::pi<double>() * testing::meshFormFactor(ring, places[i], {0, -1, 0});
    }
    EXPECT_GT(truth / static_cast<double>(found.size()), 0.5);
    EXPECT_NEAR(sum / truth, 1, 0.005) << "by the emission of patches it is too dark";
}

} // namespace
} // namespace shadowlab::radiosity
