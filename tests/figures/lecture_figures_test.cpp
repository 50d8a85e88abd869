// The figures of shadow maps and shadow volumes that are drawn alone: that they can be read at every size of a slide, whatever the
// scene, and that what stands in them is true.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include "app/figures/figures.h"
#include "app/figures/volume/caster_solid.h"
#include "app/figures/volume/volume_sketch.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/volume_probe.h"
#include "tests/figures/written.h"
#include "tests/support/scenes.h"

namespace shadowlab::figures {
namespace {

constexpr ivec2 kSize{320, 180};
/// A whole slide, and halves of one beside words.
const dvec2 kRooms[] = {{1920, 860}, {1170, 800}, {930, 800}};

struct Asked {
    scene::Snapshot scene;
    std::string technique;
    View view;
    Probe probe;
    [[nodiscard]] FigureSource source(dvec2 size) const {
        return {probe, technique, *scene, view, scene->lights.empty() ? kNoLight : 0, testFont(), testBoldFont(), size};
    }
};

using Settings = std::vector<std::pair<const char*, const char*>>;

Asked ask(const scene::Snapshot& scene, const std::string& technique, ivec2 pixel, const Settings& settings = {}) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    for (const auto& [param, value] : settings)
        params::setFromText(params::find(slot.params, param, technique), value, technique);
    Asked asked{scene, technique, {}, {}};
    asked.view.camera = scene->camera;
    asked.view.size = kSize;
    asked.probe = slot.technique->probe(scene, asked.view, pixel, scene->lights.empty() ? kNoLight : 0);
    return asked;
}

scene::Snapshot deckScene() {
    return scene::loadScene((context::assetsRoot() / "decks/scenes/floating-ball.json").string(),
                            {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

scene::Snapshot boxes(const scene::Light& light) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.9, 0}));
    testing::addObject(scene, scene::makeBox({0.8, 0.3, 0.8}), testing::translation({0.3, 2, 0.2}));
    testing::addObject(scene, scene::makeQuad({1, 1}), testing::translation({-1.5, 1.2, 0}));
    scene.lights = {light};
    return testing::snapshot(std::move(scene));
}

struct Named {
    std::string name;
    scene::Snapshot scene;
};
std::vector<Named> scenes() {
    return {{"deck", deckScene()},
            {"point", boxes(testing::pointLight({2, 5, 3}))},
            {"sun", boxes(testing::directionalLight({0.5, -1, 0.25}))},
            {"far light", boxes(testing::pointLight({200, 500, 300}))},
            {"light among the casters", boxes(testing::pointLight({0.4, 1.55, 0.6}))},
            {"light at the eye", boxes(testing::pointLight({0, 3, 6}))}};
}

/// The number after the words; none where they are not there.
std::vector<double> numbersAfter(const std::vector<Written>& all, const std::string& words) {
    std::vector<double> numbers;
    for (const Written& one : all) {
        const std::size_t at = one.text.find(words);
        if (at == std::string::npos) continue;
        std::string rest = one.text.substr(at + words.size());
        if (rest.starts_with("\u2212")) rest = "-" + rest.substr(std::string("\u2212").size());
        const std::size_t power = rest.find("\u00b710");
        if (power == std::string::npos) numbers.push_back(std::stod(rest));
    }
    return numbers;
}

/// The signs of a formula stand as close to one another as Formula sets them: formula_test.cpp looks after that.
bool isOfFormula(const Written& one) { return one.text.size() <= 4 && one.em != drawing::kLetter && !one.text.starts_with("+"); }

TEST(LectureFiguresTest, CanBeReadAtEverySizeWhateverTheSceneIs) {
    std::map<std::string, int> drawn;
    int compared = 0, refused = 0;
    for (const Named& named : scenes())
        for (const char* technique : {"planar", "shadow-map", "shadow-volume-zpass", "shadow-volume-zfail"})
            for (const ivec2 pixel : {ivec2(160, 70), ivec2(150, 130), ivec2(210, 110), ivec2(120, 90)}) {
                const Asked asked = ask(named.scene, technique, pixel);
                for (const Figure& figure : figures()) {
                    if (figure.name == "pixel") continue;
                    for (const dvec2& room : kRooms) {
                        const std::string what = named.name + ", " + technique + ", " + std::string(figure.name) +
                                                 " at " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) +
                                                 ", " + std::to_string(room.x);
                        std::string drawing;
                        try {
                            drawing = figure.draw(asked.source(room)).document();
                        } catch (const Error& why) {
                            ++refused;
                            EXPECT_EQ(why.status(), ExitStatus::badInput) << what;
                            EXPECT_EQ(std::string(why.what()).find('\n'), std::string::npos) << what;
                            continue;
                        }
                        ++drawn[std::string(figure.name)];
                        EXPECT_EQ(drawing.find("nan"), std::string::npos) << what;
                        EXPECT_EQ(drawing.find("inf\""), std::string::npos) << what;
                        const std::vector<Written> all = linesOf(written(drawing));
                        for (std::size_t i = 0; i < all.size(); ++i) {
                            EXPECT_GE(all[i].em, 1080.0 / 45) << what << ": " << all[i].text;
                            EXPECT_GE(all[i].box.corner.x, 0) << what << ": " << all[i].text;
                            EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, room.x) << what << ": " << all[i].text;
                            EXPECT_LE(all[i].box.corner.y + all[i].box.size.y, room.y) << what << ": " << all[i].text;
                            for (std::size_t j = 0; j < i; ++j, ++compared)
                                EXPECT_FALSE(!(isOfFormula(all[i]) && isOfFormula(all[j])) &&
                                             all[i].box.overlaps(all[j].box))
                                    << what << ": " << all[i].text << " covers " << all[j].text;
                        }
                    }
                }
            }
    std::cout << compared << " pairs of labels, " << refused << " refused";
    for (const auto& [name, times] : drawn)
        std::cout << ", " << name << " " << times;
    std::cout << '\n';
    EXPECT_GT(compared, 10'000);
    for (const char* name :
         {"shadow-ray", "projection", "cameras", "passes", "count", "polygon", "edge", "extrusion", "volume"})
        EXPECT_GT(drawn[name], 20) << name;
}

// Both products, from the corners as they stand in the scene. Four digits are written: alike to half of the last one.
TEST(PolygonFigureTest, WritesTheSignsAndProductsOfTheScene) {
    int polygons = 0;
    for (const Named& named : scenes())
        for (int x = 90; x < 250; x += 10)
            for (const int y : {35, 50, 65, 80, 95, 110}) {
                const Asked asked = ask(named.scene, "shadow-volume-zfail", {x, y});
                if (!asked.probe.find<VolumeProbe>() || asked.probe.find<VolumeProbe>()->casters.empty()) continue;
                const CasterSolid solid = casterSolid(asked.source(kRooms[0]), false);
                if (!solid.caster->isPicked) continue;
                const std::vector<Written> all =
                    linesOf(written(findFigure("polygon").draw(asked.source(kRooms[0])).document()));
                const std::vector<double> products = numbersAfter(all, "N \u00b7 L = ");
                if (products.empty()) continue; // a power of ten
                // The picked triangle, as the facts name it.
                const auto fact = std::ranges::find(asked.probe.facts, "triangle", &Probe::Fact::label);
                ASSERT_NE(fact, asked.probe.facts.end());
                const auto triangle = static_cast<std::size_t>(fact->numbers[0]);
                const scene::Object& object = named.scene->objects[solid.caster->object];
                const dmat4 worldFromMesh = scene::worldFromMesh(object);
                std::array<dvec3, 3> c{};
                for (int i = 0; i < 3; ++i)
                    c[static_cast<std::size_t>(i)] = transformPoint(
                        worldFromMesh, dvec3(object.mesh->positionsMesh[object.mesh->triangles[triangle][i]]));
                const dvec3 normal = glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
                const dvec4 light = scene::homogeneousPositionWorld(named.scene->lights[0]);
                const double product = glm::dot(normal, dvec3(light) - light.w * c[0]);
                EXPECT_NEAR(products[0], product, 6e-4 * std::abs(product) + 1e-9)
                    << named.name << " " << x << "," << y;
                if (products.size() > 1) {
                    EXPECT_LE(std::min(products[0], products[1]), 0) << named.name;
                    EXPECT_GT(std::max(products[0], products[1]), 0) << named.name;
                }
                ++polygons;
            }
    std::cout << polygons << " polygons\n";
    EXPECT_GT(polygons, 30);
}

// The outline edge has one polygon on either side, the other edge has not; and both lists of signs are those of the numbers.
TEST(EdgeFigureTest, TellsOutlinesFromOtherEdges) {
    int outlines = 0;
    for (const Named& named : scenes())
        for (int x = 90; x < 250; x += 10)
            for (const int y : {35, 50, 65, 80, 95, 110}) {
                const Asked asked = ask(named.scene, "shadow-volume-zfail", {x, y});
                if (!asked.probe.find<VolumeProbe>() || asked.probe.find<VolumeProbe>()->casters.empty()) continue;
                std::string drawing;
                try {
                    drawing = findFigure("edge").draw(asked.source(kRooms[1])).document();
                } catch (const Error&) {
                    continue; // a sheet has no edge between two polygons
                }
                const std::vector<Written> all = linesOf(written(drawing));
                const std::vector<double> first = numbersAfter(all, "N1 \u00b7 L = "), second = numbersAfter(all, "N2 \u00b7 L = ");
                if (first.size() != second.size() || first.empty()) continue;
                EXPECT_GT(first[0], 0) << named.name;
                EXPECT_LE(second[0], 0) << named.name;
                if (first.size() > 1) {
                    EXPECT_EQ(first[1] > 0, second[1] > 0) << named.name;
                }
                EXPECT_EQ(std::ranges::count(all, "this edge is an outline", &Written::text), 1);
                ++outlines;
            }
    std::cout << outlines << " outlines\n";
    EXPECT_GT(outlines, 20);
}

// P' lies on the light's line through P, beyond it, at the distance that was asked for; or at infinity in that direction.
TEST(ExtrusionFigureTest, WritesThePointThatTheTechniqueExtrudes) {
    int extruded = 0;
    for (const Named& named : scenes())
        for (const char* d : {"0.4", "1.5"})
            for (int x = 90; x < 250; x += 15) {
                const Asked asked =
                    ask(named.scene, "shadow-volume-zfail", {x, 60}, {{"volume-end", "distance"}, {"extrusion", d}});
                if (!asked.probe.find<VolumeProbe>() || asked.probe.find<VolumeProbe>()->casters.empty()) continue;
                const CasterSolid solid = casterSolid(asked.source(kRooms[1]), false);
                for (std::size_t v = 0; v < solid.verticesWorld.size(); ++v) {
                    const dvec3 p = solid.verticesWorld[v], end(solid.caster->extrudedWorld[v]);
                    EXPECT_NEAR(glm::length(end - p), std::stod(d), 1e-9);
                    EXPECT_NEAR(glm::dot(glm::normalize(end - p), glm::normalize(solid.toLight(p))), -1, 1e-12);
                }
                const std::vector<double> written_ = numbersAfter(
                    linesOf(written(findFigure("extrusion").draw(asked.source(kRooms[1])).document())), "|P\u2032 \u2212 P| = ");
                ASSERT_EQ(written_.size(), 1u) << named.name;
                EXPECT_NEAR(written_[0], std::stod(d), 1e-4);
                ++extruded;
            }
    EXPECT_GT(extruded, 15);
    const Asked endless = ask(deckScene(), "shadow-volume-zfail", {125, 50}, {{"volume-end", "infinity"}});
    const std::vector<Written> all = written(findFigure("extrusion").draw(endless.source(kRooms[1])).document());
    EXPECT_TRUE(std::ranges::any_of(all, [](const Written& one) { return one.text == "P\u2032 at infinity"; }));
}

// Each place of the curve is on a receiver, and on the light's line past the outline; on one flat floor the curve is closed.
TEST(VolumeFigureTest, TheCurveIsWhereTheVolumeCutsTheReceivers) {
    const scene::Snapshot scene = boxes(testing::pointLight({1, 6, 1.5}));
    const Asked asked = ask(scene, "shadow-volume-zfail", {160, 90});
    const CasterSolid solid = casterSolid(asked.source(kRooms[0]), true);
    const VolumeSketch sketch(asked.source(kRooms[0]), solid, {{0, 0}, {1920, 700}});
    const std::vector<dvec3>& curve = sketch.curveWorld();
    ASSERT_GT(curve.size(), 20u);
    const dvec3 light(solid.lightWorld);
    std::map<std::array<long, 3>, int> ends;
    for (const dvec3& place : curve) {
        double least = 1e300; // from the outline to the line between light and place
        for (const VolumeProbe::Caster::SilhouetteEdge& edge : solid.caster->outline) {
            const dvec3 &a = solid.verticesWorld[edge.a], b = solid.verticesWorld[edge.b];
            const dvec3 normal = glm::normalize(glm::cross(a - light, b - light));
            const dvec3 inPlane = glm::cross(normal, glm::normalize(place - light));
            const double sideA = glm::dot(inPlane, a - light), sideB = glm::dot(inPlane, b - light);
            if (sideA * sideB <= 1e-9) least = std::min(least, std::abs(glm::dot(normal, place - light)));
        }
        EXPECT_LT(least, 1e-6);
        ++ends[{std::lround(place.x * 1e6), std::lround(place.y * 1e6), std::lround(place.z * 1e6)}];
    }
    const auto odd = std::ranges::count_if(ends, [](const auto& one) { return one.second % 2 != 0; });
    std::cout << curve.size() / 2 << " pieces, " << odd << " loose ends\n";
    EXPECT_EQ(odd, 0);
}

TEST(CountFigureTest, WritesTheCountsOfTheProbe) {
    int counted = 0;
    for (const Named& named : scenes())
        for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail"})
            for (int x = 60; x < 280; x += 40)
                for (const int y : {80, 120, 150}) {
                    const Asked asked = ask(named.scene, technique, {x, y});
                    if (!asked.probe.find<VolumeProbe>()) continue;
                    const std::string drawing = findFigure("count").draw(asked.source(kRooms[2])).document();
                    const VolumeProbe& volume = *asked.probe.find<VolumeProbe>();
                    const bool isPass = std::string(technique) == "shadow-volume-zpass";
                    const int fronts = isPass ? volume.frontsBefore : volume.frontsBeyond,
                              backs = isPass ? volume.backsBefore : volume.backsBeyond;
                    const std::vector<Written> all = written(drawing);
                    EXPECT_TRUE(std::ranges::any_of(all, [&](const Written& one) {
                        return one.text == (fronts == backs ? ": illuminated" : ": in shadow");
                    })) << named.name;
                    EXPECT_TRUE(std::ranges::any_of(all, [&](const Written& one) {
                        return one.text == std::to_string(fronts);
                    })) << named.name;
                    ++counted;
                }
    EXPECT_GT(counted, 80);
}

// Eye, light and point are where they are: the triangle that they make has the shape of the one in the scene.
TEST(CamerasFigureTest, HasEyeLightAndPointInTheirPlacesAndBothDepths) {
    int drawn = 0;
    for (const Named& named : scenes())
        for (int x = 60; x < 280; x += 40) {
            const Asked asked = ask(named.scene, "shadow-map", {x, 120});
            if (!asked.probe.find<MapProbe>()) continue;
            const Diagram figure = findFigure("cameras").draw(asked.source(kRooms[0]));
            std::map<std::string, dvec2> places;
            for (const drawing::Mark& mark : figure.drawing.marks())
                if (const auto* circle = std::get_if<drawing::Circle>(&mark); circle && !circle->name.empty())
                    places[circle->name] = circle->centre;
            const std::vector<Written> all = written(figure.document());
            const std::vector<double> z = numbersAfter(all, "z(u,v) = ");
            if (!z.empty()) {
                EXPECT_NEAR(z[0], asked.probe.find<MapProbe>()->pointMetres, 6e-4 * asked.probe.find<MapProbe>()->pointMetres);
            }
            if (!places.contains("eye") || !places.contains("light") || !places.contains("point")) continue;
            const dvec3 eye = asked.probe.geometry[0].fromWorld, point = asked.probe.geometry[0].toWorld,
                        light = asked.probe.geometry[1].toWorld;
            const double onSheet =
                glm::length(places["eye"] - places["point"]) / glm::length(places["light"] - places["point"]);
            EXPECT_NEAR(onSheet, glm::length(eye - point) / glm::length(light - point), 1e-6) << named.name;
            ++drawn;
        }
    EXPECT_GT(drawn, 10);
}

TEST(PassesFigureTest, CountsTheTrianglesOfTheScene) {
    const scene::Snapshot scene =
        scene::loadScene("three-lights", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const Asked asked = ask(scene, "shadow-map", {160, 90});
    ASSERT_EQ(asked.probe.passes.size(), 7u) << "2 N + 1 for three lights";
    const std::uint64_t pawn = scene->objects[1].mesh->triangles.size(), all = pawn + 2;
    EXPECT_EQ(asked.probe.passes[0].triangles, all);
    for (std::size_t i = 1; i < 7; i += 2) {
        EXPECT_EQ(asked.probe.passes[i].id, "depth");
        EXPECT_EQ(asked.probe.passes[i].triangles, pawn) << "nothing lies under the floor: it casts no shadow";
        EXPECT_EQ(asked.probe.passes[i + 1].id, "light");
        EXPECT_GE(asked.probe.passes[i + 1].triangles, all);
    }
    const std::vector<Written> written_ = linesOf(written(findFigure("passes").draw(asked.source(kRooms[0])).document()));
    const auto says = [&](std::string_view words) {
        return std::ranges::any_of(written_, [&](const Written& one) { return one.text.find(words) != std::string::npos; });
    };
    EXPECT_TRUE(says("N = 3 lights:"));
    EXPECT_TRUE(says("N + 1 = 4 renderings"));
    EXPECT_TRUE(says("4. from the eye")) << "as many bars as the heading says";
    EXPECT_FALSE(says("5. "));
    EXPECT_TRUE(says("2N + 1")) << "what the program itself draws is explained";
}

TEST(LectureFiguresTest, SayWhatIsMissingInOneLine) {
    const scene::Snapshot scene = deckScene();
    const Asked background = ask(scene, "shadow-volume-zfail", {2, 2}), map = ask(scene, "shadow-map", {160, 70}),
                lit = ask(scene, "shadow-volume-zfail", {60, 150});
    ASSERT_TRUE(lit.probe.find<VolumeProbe>());
    ASSERT_TRUE(lit.probe.find<VolumeProbe>()->casters.empty()) << "a lit place of the floor";
    const auto said = [](const Asked& asked, const char* figure) -> std::string {
        try {
            (void)findFigure(figure).draw(asked.source(kRooms[0]));
        } catch (const Error& why) {
            return why.what();
        }
        return "";
    };
    for (const char* figure : {"shadow-ray", "projection", "polygon", "edge", "extrusion", "volume", "count", "cameras", "passes"})
        EXPECT_EQ(said(background, figure), "the pixel shows the background; choose another") << figure;
    for (const char* figure : {"polygon", "edge", "extrusion", "volume"}) {
        EXPECT_NE(said(map, figure).find("shadow-map makes no shadow volumes"), std::string::npos) << figure;
        EXPECT_NE(said(lit, figure).find("shows no caster"), std::string::npos) << figure;
    }
    EXPECT_NE(said(lit, "cameras").find("asks no shadow map"), std::string::npos);
    EXPECT_NE(said(lit, "passes").find("does not tell how often"), std::string::npos);
}

// A thing has one colour in drawings and in pictures, and what is seen together has different ones.
TEST(FigureColoursTest, PartsOfAVolumeAreColouredAsTheOutsideViewColoursThem) {
    const Asked asked = ask(deckScene(), "shadow-volume-zfail", {210, 119}, {{"construction", "lecture"}});
    int caps = 0, others = 0, facing = 0;
    for (const drawing::Mark& mark : findFigure("volume").draw(asked.source(kRooms[0])).drawing.marks())
        if (const auto* line = std::get_if<drawing::Line>(&mark); line && line->isClosed && !line->fill.empty()) {
            caps += line->fill == drawing::colorText(look::kTopCap);
            others += line->fill == drawing::colorText(look::kOtherLight);
            facing += line->fill == drawing::colorText(look::kTowardLight) || line->fill == drawing::colorText(look::kAwayFromLight);
        }
    EXPECT_GE(caps, 5);
    EXPECT_GE(others, 5);
    EXPECT_EQ(facing, 0) << "these are the colours of the two sides, which no part of a volume has";

    const vec3 together[] = {look::kTopCap,    look::kVolumeSide, look::kBottomCap, look::kSilhouette,   look::kNearClipPyramid,
                             look::kDepthPass, look::kDepthFail,  look::kEye,       look::kChosenLight, look::kAwayFromLight};
    int pairs = 0;
    for (std::size_t i = 0; i < std::size(together); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs)
            EXPECT_GT(glm::length(together[i] - together[j]), 0.1f) << i << ", " << j;
    EXPECT_EQ(pairs, 45);
}

} // namespace
} // namespace shadowlab::figures
