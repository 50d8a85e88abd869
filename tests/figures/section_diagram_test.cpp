// The figures of shadow volumes, shadow maps and planar shadows: what stands in them, that it is true, and that it can be read.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <optional>
#include <random>

#include "app/figures/pixel_diagram.h"
#include "app/figures/volume/volume_areas.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/volume_probe.h"
#include "tests/figures/written.h"
#include "tests/support/scenes.h"

namespace shadowlab::figures {
namespace {

constexpr ivec2 kSize{320, 180};
const char* const kTechniques[] = {"planar", "shadow-map", "shadow-volume-zpass", "shadow-volume-zfail",
                                   "shadow-volume"};

Probe ask(const scene::Snapshot& scene, const char* technique, ivec2 pixel, const char* param = nullptr,
          const char* value = nullptr) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    if (param) params::setFromText(params::find(slot.params, param, technique), value, technique);
    View view;
    view.camera = scene->camera;
    view.size = kSize;
    return slot.technique->probe(scene, view, pixel, 0);
}

scene::Scene boxes() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.5, 0}));
    testing::addObject(scene, scene::makeBox({0.8, 0.3, 0.8}), testing::translation({0.3, 2, 0.2}));
    testing::addObject(scene, scene::makeQuad({1, 1}), testing::translation({-1.5, 1.2, 0}));
    return scene;
}

struct Named {
    std::string name;
    scene::Snapshot scene;
};

/// Scenes of which each is degenerate in another way.
std::vector<Named> scenes() {
    std::vector<Named> all;
    const auto add = [&](const char* name, const scene::Light& light, const auto& change) {
        scene::Scene scene = boxes();
        scene.lights = {light};
        change(scene);
        all.push_back({name, testing::snapshot(std::move(scene))});
    };
    const auto asItIs = [](scene::Scene&) {};
    scene::Light spot = testing::pointLight({2, 5, 3});
    spot.type = scene::LightType::spot;
    spot.directionWorld = glm::normalize(dvec3(-2, -5, -3));
    spot.coneDegrees = 60;
    add("point", testing::pointLight({2, 5, 3}), asItIs);
    add("directional", testing::directionalLight({0.5, -1, 0.25}), asItIs);
    add("spot", spot, asItIs);
    add("horizon", testing::directionalLight({1, -0.02, 0.1}), asItIs);
    add("far light", testing::pointLight({200, 500, 300}), asItIs);
    add("light at the eye", testing::pointLight({0, 3, 6}), asItIs);
    add("light behind the eye", testing::pointLight({0, 6, 12}), asItIs);
    add("sun along the view", testing::directionalLight({0, -3, -6}), asItIs);
    add("eye in shadow", testing::directionalLight({0, -1, 0.05}), [](scene::Scene& scene) {
        testing::addObject(scene, scene::makeBox({6, 0.2, 6}), testing::translation({0, 5, 5}));
    });
    add("from above", testing::pointLight({0.1, 4, 0.2}), [](scene::Scene& scene) {
        scene.camera.positionWorld = {0, 9, 0.01};
        scene.camera.targetWorld = {0, 0, 0};
        scene.camera.upWorld = {0, 0, -1};
    });
    add("among the casters", testing::pointLight({0.4, 1.4, 0.6}), asItIs);
    return all;
}

// Over every technique and every scene, on a wide sheet and on the narrowest: type is large enough, no label covers another, all stay on
// the sheet.
TEST(SectionDiagramTest, CanBeReadWhateverTheSceneIs) {
    int drawings = 0, narrow = 0, compared = 0;
    const auto expectReadable = [&](const std::string& drawing, double width, const std::string& what) {
        ++drawings;
        EXPECT_EQ(drawing.find("nan"), std::string::npos) << what;
        EXPECT_EQ(drawing.find("inf\""), std::string::npos) << what;
        EXPECT_LT(drawing.size(), 400'000u) << what;
        const std::vector<Written> all = written(drawing);
        EXPECT_GT(all.size(), 10u) << what;
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_GE(all[i].em, 1080.0 / 45) << what << ": " << all[i].text;
            EXPECT_GE(all[i].box.corner.x, 0) << what << ": " << all[i].text;
            EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, width) << what << ": " << all[i].text;
            EXPECT_LE(all[i].box.corner.y + all[i].box.size.y, 1080) << what << ": " << all[i].text;
            for (std::size_t j = 0; j < i; ++j, ++compared)
                EXPECT_FALSE(all[i].box.overlaps(all[j].box))
                    << what << ": " << all[i].text << " covers " << all[j].text;
        }
    };
    for (const Named& named : scenes())
        for (const char* technique : kTechniques)
            for (const ivec2 pixel :
                 {ivec2(160, 90), ivec2(120, 120), ivec2(200, 130), ivec2(90, 150), ivec2(230, 100)}) {
                const std::string what =
                    named.name + ", " + technique + ", " + std::to_string(pixel.x) + "," + std::to_string(pixel.y);
                const Probe probe = ask(named.scene, technique, pixel);
                if (canDraw(probe))
                    expectReadable(pixelDiagram(probe, *named.scene, testFont()).document(), kSheetWidth, what);
                if (technique != std::string_view("shadow-map")) continue;
                const Probe hard = ask(named.scene, technique, pixel, "filter", "hard");
                const double least = leastWidth(hard);
                if (!canDraw(hard) || least == kSheetWidth) continue;
                ++narrow;
                expectReadable(pixelDiagram(hard, *named.scene, testFont(), kSectionHeight, least).document(), least, what + ", narrow");
            }
    std::cout << drawings << " drawings, " << compared << " pairs of labels\n";
    EXPECT_GT(drawings, 150);
    EXPECT_GT(narrow, 20);
    EXPECT_GT(compared, 30'000);
}

/// Triangles of casters that the light shines on, between a place and the light: tried one by one.
int litTrianglesBetween(const scene::Scene& scene, const dvec3& placeWorld, bool all) {
    const dvec4 light = scene::homogeneousPositionWorld(scene.lights[0]);
    const dvec3 way = dvec3(light) - placeWorld * light.w;
    int count = 0;
    for (const scene::Object& object : scene.objects) {
        if (!object.castsShadow) continue;
        const std::vector<std::int8_t> facing = scene::facingSigns(object, scene.lights[0]);
        const dmat4 worldFromMesh = scene::worldFromMesh(object);
        const bool isOpen = object.mesh->triangles.size() == 2;
        for (std::size_t t = 0; t < object.mesh->triangles.size(); ++t) {
            if (facing[t] <= 0 && !isOpen && !all) continue;
            std::array<dvec3, 3> p{};
            for (int i = 0; i < 3; ++i)
                p[static_cast<std::size_t>(i)] =
                    transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[object.mesh->triangles[t][i]])) -
                    placeWorld;
            const dvec3 weights(glm::dot(way, glm::cross(p[1], p[2])), glm::dot(way, glm::cross(p[2], p[0])),
                                glm::dot(way, glm::cross(p[0], p[1])));
            if (!(glm::all(glm::greaterThan(weights, dvec3(0))) || glm::all(glm::lessThan(weights, dvec3(0)))))
                continue;
            const dvec3 meets =
                (weights.x * p[0] + weights.y * p[1] + weights.z * p[2]) / (weights.x + weights.y + weights.z);
            const double share = glm::dot(meets, way) / glm::dot(way, way);
            count += share > 1e-9 && (light.w == 0 || share < 1);
        }
    }
    return count;
}

/// Is the place nearer than that to a border between two counts?
bool isAtBorder(dvec2 place, std::span<const VolumeProbe::CapLine> caps, const PlaneLight& light, double away) {
    for (int i = 0; i < 8; ++i) {
        const double angle = M_PI * i / 4;
        if (countAt(place + away * dvec2(std::cos(angle), std::sin(angle)), caps, light) != countAt(place, caps, light))
            return true;
    }
    return false;
}

bool contains(const CountedArea& area, dvec2 place) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec2 a = area.corners[i], b = area.corners[(i + 1) % 4];
        const double side = (b.x - a.x) * (place.y - a.y) - (b.y - a.y) * (place.x - a.x);
        left += side > 0;
        right += side < 0;
    }
    return left == 0 || right == 0;
}

// The grey areas against triangles between places of the plane and the light, in space.
TEST(VolumeAreasTest, HoldTheCountsOfTheScene) {
    int compared = 0, inside = 0;
    std::mt19937 random(7);
    for (const Named& named : scenes()) {
        const Probe probe = ask(named.scene, "shadow-volume-zfail", {160, 120}, "cull", "false");
        if (!probe.find<VolumeProbe>() || !probe.section) continue;
        PlaneLight light;
        const dvec4 world = scene::homogeneousPositionWorld(named.scene->lights[0]);
        light.isDirection = world.w == 0;
        light.at = light.isDirection ? probe.section->ofDirection(dvec3(world)) : probe.section->of(dvec3(world));
        const drawing::Box within{dvec2(-4), dvec2(8)};
        const std::vector<CountedArea> areas = countedAreas(probe.find<VolumeProbe>()->caps, light, within);
        std::uniform_real_distribution<double> metres(-3.5, 3.5);
        for (int i = 0; i < 400; ++i) {
            const dvec2 place(metres(random), metres(random));
            const dvec3 placeWorld = probe.section->world(place);
            // Volumes end just beyond the scene's box; no statement is made about what lies there.
            if (placeWorld.y < 0.02 || placeWorld.y > 2.1 || std::abs(placeWorld.x) > 4 || std::abs(placeWorld.z) > 4)
                continue;
            if (isAtBorder(place, probe.find<VolumeProbe>()->caps, light, 1e-3)) continue;
            ++compared;
            const int expected = litTrianglesBetween(*named.scene, placeWorld, false);
            EXPECT_EQ(countAt(place, probe.find<VolumeProbe>()->caps, light), expected) << named.name;
            int drawn = 0;
            for (const CountedArea& area : areas)
                if (contains(area, place)) drawn = area.count;
            EXPECT_EQ(drawn, expected) << named.name << ": the area drawn at " << place.x << ", " << place.y;
            inside += expected > 0;
        }
    }
    std::cout << compared << " places, " << inside << " in volumes\n";
    EXPECT_GT(compared, 1000);
    EXPECT_GT(inside, 100);
}

// The numbers on the line: +1 and -1 in the drawing, by the areas that the line passes between them.
TEST(SectionDiagramTest, CrossingsAreThoseOfTheLineAndChangeTheCount) {
    int crossings = 0, labels = 0;
    for (const Named& named : scenes())
        for (int i = 0; i < 40; ++i) {
            const ivec2 pixel(40 + 30 * (i % 8), 40 + 28 * (i / 8));
            const Probe probe = ask(named.scene, "shadow-volume-zfail", pixel, "cull", "false");
            if (!probe.find<VolumeProbe>()) continue;
            const dvec3 eye = probe.geometry[0].fromWorld, point = probe.geometry[0].toWorld,
                        way = glm::normalize(point - eye);
            for (const VolumeProbe::Crossing& crossing : probe.find<VolumeProbe>()->crossings) {
                if (std::isinf(crossing.distance) || crossing.part == VolumeProbe::Part::bottomCap) continue;
                const double step = 1e-4;
                const int before = litTrianglesBetween(*named.scene, eye + (crossing.distance - step) * way, false);
                const int after = litTrianglesBetween(*named.scene, eye + (crossing.distance + step) * way, false);
                const bool alone = std::ranges::count_if(probe.find<VolumeProbe>()->crossings, [&](const auto& other) {
                                       return std::abs(other.distance - crossing.distance) < 2 * step;
                                   }) == 1;
                if (!alone) continue;
                ++crossings;
                EXPECT_EQ(after - before, crossing.sign) << named.name << " at " << crossing.distance;
            }
            if (i % 5 != 0) continue; // a drawing takes longer than a walk
            const std::vector<Written> all = written(pixelDiagram(probe, *named.scene, testFont()).document());
            for (std::size_t i = 0; i < probe.find<VolumeProbe>()->crossings.size() && i < 14; ++i) {
                const std::string sign = probe.find<VolumeProbe>()->crossings[i].sign > 0 ? "+1" : "\u22121",
                                  row = std::to_string(i + 1) + ": " + sign;
                labels += static_cast<int>(std::ranges::count(all, row, &Written::text));
                for (const Written& one : all)
                    if (one.text.starts_with(std::to_string(i + 1) + ": ") && one.text.size() > 3) {
                        EXPECT_TRUE(one.text.starts_with(row)) << named.name << ": " << one.text;
                    }
            }
        }
    std::cout << crossings << " crossings, " << labels << " labels\n";
    EXPECT_GT(crossings, 40);
    EXPECT_GT(labels, 40);
}

/// Metres from the light to the first caster on its ray through a place; for a directional light from far before it.
std::optional<double> firstOnRay(const scene::Scene& scene, const dvec3& placeWorld) {
    const dvec4 light = scene::homogeneousPositionWorld(scene.lights[0]);
    const dvec3 from = light.w == 0 ? placeWorld + 100.0 * dvec3(light) : dvec3(light),
                way = glm::normalize(placeWorld - from);
    std::optional<double> first;
    for (const scene::Object& object : scene.objects)
        for (const uvec3& t : object.mesh->triangles) {
            if (!object.castsShadow) continue;
            const dmat4 worldFromMesh = scene::worldFromMesh(object);
            std::array<dvec3, 3> p{};
            for (int i = 0; i < 3; ++i)
                p[static_cast<std::size_t>(i)] =
                    transformPoint(worldFromMesh, dvec3(object.mesh->positionsMesh[t[i]])) - from;
            const dvec3 weights(glm::dot(way, glm::cross(p[1], p[2])), glm::dot(way, glm::cross(p[2], p[0])),
                                glm::dot(way, glm::cross(p[0], p[1])));
            if (!(glm::all(glm::greaterThan(weights, dvec3(0))) || glm::all(glm::lessThan(weights, dvec3(0)))))
                continue;
            const dvec3 meets =
                (weights.x * p[0] + weights.y * p[1] + weights.z * p[2]) / (weights.x + weights.y + weights.z);
            const double distance = glm::dot(meets, way);
            if (distance > 0 && (!first || distance < *first)) first = distance;
        }
    return first;
}

// Where a texel's depth is drawn, the light's ray through that place first meets the scene. A texel is asked at its centre, beside
// the drawing's plane, and its depth is pushed back by its slope: on a surface seen at 60 degrees, two texels' width per texel
// and three of these together. At an edge the centre may see another surface: so one in five may differ.
TEST(SectionDiagramTest, TexelsEndWhereTheLightFirstMeetsTheScene) {
    int filled = 0, agree = 0, empty = 0, emptyAgree = 0;
    for (const Named& named : scenes()) {
        if (named.name == "horizon") continue; // all slopes are steep
        const Probe probe = ask(named.scene, "shadow-map", {160, 120}, "resolution", "512");
        if (!probe.find<MapProbe>() || !probe.section) continue;
        for (const MapProbe::Cell& cell : probe.find<MapProbe>()->across) {
            const dvec3 place = probe.section->world(0.5 * (cell.stored[0] + cell.stored[1]));
            const auto first = firstOnRay(*named.scene, place);
            if (cell.isEmpty) {
                ++empty;
                emptyAgree += !first;
                continue;
            }
            ++filled;
            const dvec4 light = scene::homogeneousPositionWorld(named.scene->lights[0]);
            const double drawn = light.w == 0 ? 100 : glm::length(place - dvec3(light));
            agree += first && std::abs(*first - drawn) < 6 * probe.find<MapProbe>()->texelMetres;
        }
    }
    std::cout << filled << " filled cells, " << agree << " where the ray meets the scene; " << empty << " empty, "
              << emptyAgree << " where it meets nothing\n";
    EXPECT_GT(filled, 60);
    EXPECT_GT(agree, filled * 4 / 5);
}

TEST(LightSectionTest, HoldsEyeLightAndPointAndFindsAPlaneWhereTheyAreOneLine) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> metres(-5, 5);
    const auto place = [&] { return dvec3(metres(random), metres(random), metres(random)); };
    for (int i = 0; i < 200; ++i) {
        const dvec3 eye = place(), point = place(), light = i % 4 == 0 ? point + 3.0 * (eye - point) : place();
        const LightSection section = lightSection(eye, point, dvec4(light, 1), glm::normalize(place()));
        EXPECT_EQ(section.isChosen, i % 4 == 0);
        for (const dvec3& one : {eye, point, light})
            EXPECT_NEAR(glm::dot(one - section.originWorld, section.normalWorld()), 0, 1e-9);
        EXPECT_NEAR(glm::dot(section.rightWorld, section.upWorld), 0, 1e-12);
        EXPECT_NEAR(glm::length(section.rightWorld), 1, 1e-12);
        EXPECT_LE(section.of(eye).x, 1e-9) << "the eye is on the left";
    }
}

} // namespace
} // namespace shadowlab::figures
