// What lights bring to patches: closed forms, all the power there is, shadows, and the same numbers however the work is cut.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/direct_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "techniques/radiosity/patches/contacts.h"
#include "techniques/radiosity/patches/polygon_samples.h"
#include "tests/radiosity/lights/lights.h"
#include "tests/radiosity/quasirandom.h"

namespace shadowlab::radiosity {
namespace {

using namespace shadowlab::testing;

constexpr double kPi = glm::pi<double>();

DirectLight directLight(const scene::Light& light, const Room& room) {
    DirectLightBuilder builder(sourceOf(light, room), room.patches, *room.occlusion,
                               std::vector<std::uint8_t>(room.patches.size(), 1));
    EXPECT_TRUE(builder.advance(std::chrono::steady_clock::time_point::max()));
    EXPECT_EQ(builder.done(), 1);
    return builder.take();
}

/// Of the patches that `of` is true of, sum A_i H_i, W.
template <typename Of>
dvec3 power(const DirectLight& light, const Room& room, const Of& of) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < room.patches.size(); ++i)
        if (of(room.patches[i])) sum += room.patches[i].area * light.irradiance[i];
    return sum;
}
dvec3 power(const DirectLight& light, const Room& room) {
    return power(light, room, [](const Patch&) { return true; });
}

TEST(DirectLight, AClosedRoomGetsAllOfIt) {
    const Room room(emptyRoom({3, 2, 4}), 0.5);
    const auto total = [&](const scene::Light& light) { return power(directLight(light, room), room).x; };
    // Vertices are floats: the walls meet to 1e-7 of their size, and what slips through between them is the square of that.
    EXPECT_NEAR(total(pointLight({1.1, 0.7, 2.3})) / (4 * kPi * pointLight({}).intensity), 1, 1e-10);
    EXPECT_NEAR(total(rectLight({1.1, 1.7, 2.3}, {0.5, 0, 0}, {0, 0, 0.25}, 7)) / (kPi * 7 * 0.125), 1, 1e-9);
    // Aslant: the outer integral is then right to 1e-7.
    EXPECT_NEAR(total(rectLight({1.1, 1.4, 2.3}, {0.4, 0.3, 0}, {0, 0, 0.25}, 7)) / (kPi * 7 * 0.125), 1, 1e-7);
    EXPECT_NEAR(total(sphereLight({1.1, 0.7, 2.3}, 0.2, 7)) / (kPi * 7 * 4 * kPi * 0.04), 1, 1e-10);
    // Of a cone of half angle a the power is 2 pi I (1 - cos a), of a smooth edge the integral of its share. A narrow one lies all in
    // one patch, and points of that patch would hardly meet it.
    int cones = 0;
    for (const double degrees : {0.5, 50.0, 120.0, 179.0})
        for (const double edge : {0.0, 0.1, 0.5}) {
            constexpr int kSteps = 100000; // midpoints: right to 1e-10
            double sum = 0;
            for (int i = 0; i < kSteps; ++i) {
                const double half = glm::radians(0.5 * degrees), theta = half * (i + 0.5) / kSteps;
                const double t = edge > 0 ? std::min(1.0, (half - theta) / (2 * edge * half)) : 1;
                sum += t * t * (3 - 2 * t) * std::sin(theta) * half / kSteps;
            }
            // Aslant, and straight down onto the corner of four patches, along whose sides the angle about the axis stands still.
            for (const scene::Light& spot : {spotLight({1.1, 1.9, 2.3}, {0.2, -1, 0.3}, degrees, edge * degrees),
                                             spotLight({1, 1.5, 2}, {0, -1, 0}, degrees, edge * degrees)}) {
                EXPECT_NEAR(total(spot) / (2 * kPi * sum * spot.intensity), 1, edge > 0 ? 1e-7 : 1e-9)
                    << degrees << ' ' << edge;
                ++cones;
            }
        }
    EXPECT_EQ(cones, 24);
    scene::Light red = pointLight({1.1, 0.7, 2.3});
    red.color = vec3(1, 0.5, 0);
    const dvec3 colours = power(directLight(red, room), room);
    EXPECT_EQ(colours.y, 0.5 * colours.x);
    EXPECT_EQ(colours.z, 0);
}

/// A point light at (0, 2, 0) over a floor, and at half the height a screen over x < 0: its shadow is x < 0. Patches are 1/4.
TEST(DirectLight, AScreenHidesHalf) {
    scene::Scene scene = squareScene(2);
    addObject(scene, scene::makeQuad({20, 20}), translation({-10, 1, 0}));
    Room room(scene, 30);
    const auto light = pointLight({0, 2, 0});
    for (const double size : {0.25, 0.4}) { // an edge of the shadow between patches, and through their middles
        room.patches = cutIntoPatches(room.faces, size);
        const DirectLight direct = directLight(light, room);
        int lit = 0, dark = 0, partial = 0;
        for (std::size_t i = 0; i < room.patches.size(); ++i) {
            const Patch& patch = room.patches[i];
            if (patch.face != 0) continue;
            const double x = patch.centre.x + room.originWorld.x;
            const double whole = sourceOf(light, room).meanIrradiance(patch);
            if (std::abs(x) < 0.01) {
                // Half of it; evenly spread lines miss by some of their number.
                EXPECT_NEAR(direct.visible[i], 0.5, 3.0 / 64);
                EXPECT_NEAR(direct.irradiance[i].x, 0.5 * whole, 3.0 / 64 * whole);
                const PatchCells cells(patch.polygon);
                double sum = 0;
                for (std::size_t c = 0; c < PatchCells::kCount; ++c) {
                    const float share = direct.cells[i][c];
                    sum += static_cast<double>(share);
                    EXPECT_EQ(share > 0, cells.pointIn(c, {0.5, 0.5}).x + room.originWorld.x > 0);
                }
                EXPECT_NEAR(sum, 1, 1e-6) << "floats";
                ++partial;
                // One line from the middle sees all or nothing.
                const Blockers blockers = sourceOf(light, room).blockers(patch.polygon, *room.occlusion);
                const auto naive = [&](double aside) {
                    return arrivingAt(patch.centre + dvec3(aside, 0, 0), patch.normal, sourceOf(light, room),
                                      [&](const dvec3& from, const dvec3& to) {
                                          return room.occlusion->isBlocked(blockers, from, to);
                                      })
                        .seenArea;
                };
                EXPECT_EQ(naive(1e-3), 1);
                EXPECT_EQ(naive(-1e-3), 0);
            } else if (x < 0) {
                EXPECT_EQ(direct.visible[i], 0);
                EXPECT_EQ(direct.irradiance[i], dvec3(0.0));
                ++dark;
            } else {
                EXPECT_EQ(direct.visible[i], 1);
                EXPECT_EQ(direct.irradiance[i].x, whole);
                ++lit;
            }
        }
        EXPECT_EQ(lit, dark);
        EXPECT_GT(lit, 9);
        EXPECT_EQ(partial, size == 0.4 ? 5 : 0);
    }
}

/// Half-way up to a lamp of one metre, a screen over x < 0: the patch at x sees of the lamp what lies right of -x.
TEST(DirectLight, PenumbraeOfRectAndSphere) {
    scene::Scene scene = squareScene(2);
    addObject(scene, scene::makeQuad({20, 20}), translation({-10, 1, 0}));
    const Room room(scene, 0.1);
    int compared = 0;
    double worst = 0, worstAtPoint = 0;
    for (const scene::Light& light : {rectLight({0, 2, 0}, {1, 0, 0}, {0, 0, 1}, 5), sphereLight({0, 2, 0}, 0.5, 5)}) {
        const DirectLight direct = directLight(light, room);
        const LightSource source = sourceOf(light, room);
        for (std::size_t i = 0; i < room.patches.size(); i += 7) {
            const Patch& patch = room.patches[i];
            if (patch.face != 0) continue;
            const Blockers blockers = source.blockers(patch.polygon, *room.occlusion);
            double seen = 0, all = 0; // the same by many lines
            constexpr int kLinesOfTruth = 20000;
            for (int line = 0; line < kLinesOfTruth; ++line) {
                const auto x = quasirandom4(line);
                const dvec3 from = placeIn(patch.polygon, x[0], x[1]).point;
                const LightLine way = source.line(from, patch.normal, x[2], x[3]);
                // Where it goes through the screen's plane.
                const double low = from.y, high = way.fromCentred.y, screen = 1 - room.originWorld.y;
                const double x0 = glm::mix(from.x, way.fromCentred.x, (screen - low) / (high - low));
                all += way.weight;
                if (x0 + room.originWorld.x > 0) seen += way.weight;
            }
            worst = std::max(worst, std::abs(direct.visible[i] - seen / all));
            const double right = patch.centre.x + room.originWorld.x;
            const Arriving point =
                arrivingAt(patch.centre, patch.normal, source, [&](const dvec3& from, const dvec3& to) {
                    return room.occlusion->isBlocked(blockers, from, to);
                });
            const double share = std::clamp(0.5 + right, 0.0, 1.0); // of a rect, by area
            if (light.type == scene::LightType::rect)
                worstAtPoint = std::max(worstAtPoint, std::abs(point.seenArea - share));
            EXPECT_LE(point.irradiance.x, source.irradiance(patch.centre, patch.normal));
            compared += direct.visible[i] > 0.02 && direct.visible[i] < 0.98;
        }
    }
    EXPECT_GT(compared, 20);
    EXPECT_LT(worst, 1.0 / 16);        // what as many lines by chance would miss
    EXPECT_LT(worstAtPoint, 1.0 / 10); // and by irradiance is not quite by area
}

TEST(DirectLight, BehindAWallItIsExactlyDark) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({3, 2, 0.1}), translation({1.5, 1, 1.73}));
    Room room(scene, 0.5);
    room.patches = cutAtContacts(room.faces, room.patches);
    int lights = 0;
    for (const scene::Light& light :
         {pointLight({1.1, 1.7, 0.4}), spotLight({1.1, 1.7, 0.4}, {0, -0.2, 1}, 100, 10),
          rectLight({1.1, 1.9, 0.6}, {0.5, 0, 0}, {0, 0, 0.5}, 5), sphereLight({1.1, 1.5, 0.6}, 0.3, 5)}) {
        const DirectLight direct = directLight(light, room);
        int dark = 0, bright = 0;
        for (std::size_t i = 0; i < room.patches.size(); ++i) {
            const double z = room.patches[i].centre.z + room.originWorld.z;
            if (z > 1.77) {
                ASSERT_EQ(direct.irradiance[i], dvec3(0.0)) << lights << ' ' << i;
                ++dark;
            } else {
                bright += direct.irradiance[i].x > 0;
            }
        }
        EXPECT_GT(dark, 100);
        EXPECT_GT(bright, 40);
        ++lights;
    }
    EXPECT_EQ(lights, 4);
    // The sun does not come in: walls, floor and ceiling face inward, and lie between.
    const DirectLight sun = directLight(directionalLight({0.3, -1, 0.2}), room);
    EXPECT_EQ(power(sun, room, [&](const Patch& p) { return p.face < 6; }), dvec3(0.0));
}

/// The sun on a floor with a box: all that the box takes from the floor falls on the box.
TEST(DirectLight, TheShadowOfTheSun) {
    scene::Scene scene = squareScene(6);
    addObject(scene, scene::makeBox({1, 1, 1}), glm::rotate(translation({0.3, 0.8, 0.1}), 0.4, dvec3(0, 1, 0)));
    const Room room(scene, 0.25);
    const scene::Light sun = directionalLight({0.5, -1, 0.3});
    const DirectLight direct = directLight(sun, room);
    const double through = 36 * sun.intensity * glm::dot(-sun.directionWorld, dvec3(0, 1, 0));
    int partial = 0, dark = 0;
    for (std::size_t i = 0; i < room.patches.size(); ++i) {
        if (room.patches[i].face != 0) continue;
        partial += direct.visible[i] > 0 && direct.visible[i] < 1;
        dark += direct.visible[i] == 0;
    }
    EXPECT_GT(partial, 15);
    EXPECT_GT(dark, 5);
    // Some thirty patches of 1/16 m^2 of which each is wrong by 1/64 of itself or so.
    EXPECT_NEAR(power(direct, room).x / through, 1, 1e-3);
}

/// Surfaces that receive no shadow are lit through everything, yet not from behind; what casts none is not in the way.
TEST(DirectLight, ReceivesAndCasts) {
    scene::Scene scene = squareScene(2);
    addObject(scene, scene::makeQuad({20, 20}), translation({0, 1, 0}));
    for (const bool casts : {true, false}) {
        scene.objects[1].castsShadow = casts;
        const Room room(scene, 0.5);
        for (const std::uint8_t receives : {0, 1})
            for (const double height : {2.0, -2.0}) {
                DirectLightBuilder builder(sourceOf(pointLight({0.1, height, 0.2}), room), room.patches,
                                           *room.occlusion, std::vector<std::uint8_t>(room.patches.size(), receives));
                EXPECT_TRUE(builder.advance(std::chrono::steady_clock::time_point::max()));
                const DirectLight direct = builder.take();
                int floor = 0;
                for (std::size_t i = 0; i < room.patches.size(); ++i)
                    if (room.patches[i].face == 0) {
                        EXPECT_EQ(direct.visible[i], height > 0 && !(casts && receives) ? 1 : 0);
                        EXPECT_EQ(direct.irradiance[i].x > 0, direct.visible[i] > 0);
                        ++floor;
                    }
                EXPECT_EQ(floor, 16);
            }
    }
}

/// A million metres away: the same, for lights go to centred space in double.
TEST(DirectLight, FarFromTheOrigin) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({0.6, 1, 0.6}), translation({1.5, 0.5, 2}));
    scene.lights = {pointLight({1.25, 1.5, 1.75}), rectLight({0.5, 1.75, 2.5}, {0.5, 0, 0}, {0, 0, 0.5}, 5)};
    const scene::Scene away = moved(scene, {1048576, 0, -1048576});
    const Room here(scene, 0.5), there(away, 0.5);
    for (std::size_t l = 0; l < 2; ++l) {
        const DirectLight a = directLight(scene.lights[l], here), b = directLight(away.lights[l], there);
        ASSERT_EQ(a.irradiance.size(), b.irradiance.size());
        double worst = 0;
        for (std::size_t i = 0; i < a.irradiance.size(); ++i)
            worst = std::max(worst, std::abs(a.irradiance[i].x - b.irradiance[i].x));
        EXPECT_LT(worst, 1e-8); // of some ten W/m^2, at 1e-10 m, which is what doubles resolve there
    }
}

TEST(DirectLight, TheSameInSlicesAndForAnyNumberOfThreads) {
    scene::Scene scene = emptyRoom({3, 2, 4});
    addObject(scene, scene::makeBox({0.6, 1, 0.6}), glm::rotate(translation({1.5, 0.5, 2}), 0.3, dvec3(0, 1, 0)));
    const Room room(scene, 0.3);
    const scene::Light light = rectLight({0.8, 1.7, 2.3}, {0.5, 0, 0}, {0, 0.1, 0.5}, 5);
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    std::vector<DirectLight> all;
    for (const char* threads : {"1", "2", "3"}) {
        ::setenv("SHADOWLAB_THREADS", threads, 1);
        all.push_back(directLight(light, room));
        DirectLightBuilder sliced(sourceOf(light, room), room.patches, *room.occlusion,
                                  std::vector<std::uint8_t>(room.patches.size(), 1));
        int slices = 1;
        for (double last = 0; !sliced.advance(std::chrono::steady_clock::now()); ++slices) {
            EXPECT_GT(sliced.done(), last);
            last = sliced.done();
        }
        EXPECT_GT(slices, 100);
        all.push_back(sliced.take());
    }
    before ? ::setenv("SHADOWLAB_THREADS", kept.c_str(), 1) : ::unsetenv("SHADOWLAB_THREADS");
    for (const DirectLight& one : all) {
        EXPECT_EQ(one.irradiance, all.front().irradiance);
        EXPECT_EQ(one.visible, all.front().visible);
    }
    EXPECT_GT(std::ranges::count_if(all.front().visible, [](double v) { return v > 0 && v < 1; }), 30);
}

} // namespace
} // namespace shadowlab::radiosity
