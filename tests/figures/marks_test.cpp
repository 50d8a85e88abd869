// Where the marks of a figure are: read out of the SVG and held against the scene, of scenes made up by random numbers. The figure's
// scale is not known here; eye, light and point give it, and everything else must fit.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <regex>

#include "app/figures/pixel_diagram.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/figures/written.h"
#include "tests/support/brute_force.h"
#include "tests/support/scenes.h"

namespace shadowlab::figures {
namespace {

constexpr ivec2 kSize{320, 180};

/// Centres of the circles of a class.
std::vector<dvec2> marks(const std::string& drawing, const std::string& name) {
    const std::regex circle("<circle class=\"" + name + "\" cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\"");
    std::vector<dvec2> all;
    for (auto it = std::sregex_iterator(drawing.begin(), drawing.end(), circle); it != std::sregex_iterator(); ++it)
        all.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
    return all;
}

/// Boxes that hang, stand and lean in the air, and a light among them or above.
scene::Scene madeUp(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    const auto metres = [&](double low, double high) { return low + (high - low) * share(random); };
    scene::Scene scene = testing::floorScene();
    const int boxes = 2 + static_cast<int>(random() % 4);
    for (int i = 0; i < boxes; ++i) {
        const dmat4 turned = glm::rotate(testing::translation({metres(-2, 2), metres(0.6, 2.5), metres(-2, 2)}),
                                         metres(0, 6), glm::normalize(dvec3(share(random), 1, share(random))));
        testing::addObject(scene, scene::makeBox({metres(0.3, 1.2), metres(0.3, 1), metres(0.3, 1.2)}), turned);
    }
    scene.camera.positionWorld = {metres(-3, 3), metres(1, 5), metres(4, 8)};
    scene.camera.targetWorld = {metres(-0.5, 0.5), 0.3, metres(-0.5, 0.5)};
    scene.lights = {testing::pointLight({metres(-3, 3), metres(2, 6), metres(-3, 4)})};
    return scene;
}

Probe ask(const scene::Snapshot& scene, const char* technique, ivec2 pixel) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    if (technique != std::string("shadow-map"))
        params::setFromText(params::find(slot.params, "cull", technique), "false", technique);
    View view;
    view.camera = scene->camera;
    view.size = kSize;
    return slot.technique->probe(scene, view, pixel, 0);
}

// Coordinates are written with two digits, so a mark is off by up to 0.007 pixels, and a distance of two by twice that.
constexpr double kWritten = 0.03;

TEST(MarksTest, EyeLightPointAndCrossingsLieWhereTheSceneHasThem) {
    std::mt19937 random(77);
    int figures = 0, crossings = 0, counted = 0, checked = 0, covers = 0;
    double worst = 0, worstCrossing = 0, worstCover = 0;
    for (int i = 0; i < 40; ++i) {
        const scene::Snapshot scene = testing::snapshot(madeUp(random));
        const std::vector<testing::WorldTriangle> triangles = testing::allTriangles(*scene);
        const dvec3 eye = scene->camera.positionWorld, light = scene->lights[0].positionWorld;
        for (const char* technique : {"shadow-volume-zfail", "shadow-map", "planar"}) {
            const ivec2 pixel(40 + static_cast<int>(random() % 240), 60 + static_cast<int>(random() % 110));
            const dvec3 way = testing::eyeWay(scene->camera, dvec2(pixel) + 0.5, kSize);
            const auto first = testing::firstOn(triangles, eye, way, 0, [](const auto&) { return true; });
            if (!first || !first->isClear) continue;
            const dvec3 point = eye + first->along * way;
            const Probe probe = ask(scene, technique, pixel);
            if (!canDraw(probe) || !probe.section) continue;
            const std::string drawing = pixelDiagram(probe, *scene, testFont()).document();
            // The map's figure has the point twice: in the whole, and enlarged.
            const std::vector<dvec2> eyes = marks(drawing, "eye"), lights = marks(drawing, "light"),
                                     points = marks(drawing, "point");
            ASSERT_EQ(points.size(), technique == std::string("shadow-map") ? 2u : 1u);
            if (eyes.size() != 1 || lights.size() != 1) continue; // one of them is far away: an arrow points to it
            ++figures;
            const double scale = glm::length(eyes[0] - points[0]) / glm::length(eye - point);
            for (const auto& [drawn, metres] :
                 {std::pair(glm::length(lights[0] - points[0]), glm::length(light - point)),
                  std::pair(glm::length(lights[0] - eyes[0]), glm::length(light - eye))}) {
                ++checked;
                // The scale itself is off by as much as the mark that it is taken from.
                const double tolerance = kWritten * (1 + metres / glm::length(eye - point));
                worst = std::max(worst, std::abs(drawn - scale * metres));
                EXPECT_NEAR(drawn, scale * metres, tolerance) << technique << " " << i;
            }
            EXPECT_LT(eyes[0].x, points[0].x + 1e-9) << "the eye is on the left";
            // Each crossing lies on the eye's line, where the number of volumes changes: one step before and one behind it.
            const auto volumesAt = [&](const dvec3& place) {
                int count = 0;
                for (const testing::WorldTriangle& one : triangles) {
                    if (!scene->objects[one.object].castsShadow) continue;
                    const auto hit = meets(one, place, light - place);
                    const bool faces = glm::dot(one.normal(), light - one.cornersWorld[0]) > 0;
                    const bool isOpen = scene->objects[one.object].mesh->triangles.size() == 2;
                    count += hit && hit->inside > 0 && hit->along > 1e-9 && hit->along < 1 && (faces || isOpen);
                }
                return count;
            };
            for (const dvec2& mark : marks(drawing, "crossing")) {
                ++crossings;
                const dvec2 along = glm::normalize(points[0] - eyes[0]), from = mark - eyes[0];
                const double aside = std::abs(along.x * from.y - along.y * from.x);
                worstCrossing = std::max(worstCrossing, aside);
                EXPECT_LT(aside, 2 * kWritten) << i;
                const double metres = glm::dot(from, along) / scale, step = 3 * kWritten / scale;
                // Where several faces lie within a mark's own rounding the count may come back to what it was.
                const bool alone = std::ranges::count_if(marks(drawing, "crossing"), [&](const dvec2& other) {
                                       return glm::length(other - mark) < 12 * kWritten;
                                   }) == 1;
                if (!alone) continue;
                if ((eye + (metres - step) * way).y < 0) continue; // volumes end somewhere below the floor
                ++counted;
                EXPECT_NE(volumesAt(eye + (metres - step) * way), volumesAt(eye + (metres + step) * way))
                    << i << " at " << metres << " m";
            }
            // What covers the point lies on the light's line, and on a triangle of a caster.
            for (const dvec2& mark : marks(drawing, "cover")) {
                ++covers;
                const dvec2 along = (lights[0] - points[0]) / scale; // of the drawing, in metres
                const double share = glm::dot((mark - points[0]) / scale, along) / glm::dot(along, along);
                double nearest = 1e300;
                for (const testing::WorldTriangle& one : triangles) {
                    const auto hit = meets(one, point, light - point);
                    if (hit && hit->inside > -1e-9) nearest = std::min(nearest, std::abs(hit->along - share));
                }
                worstCover = std::max(worstCover, nearest * glm::length(light - point) * scale);
                EXPECT_LT(nearest * glm::length(light - point) * scale, 3 * kWritten) << i;
            }
        }
    }
    std::cout << figures << " figures, " << checked << " lengths off by " << worst << " px at most; " << crossings
              << " crossings (" << counted << " above the floor) off the line by " << worstCrossing << " px, " << covers
              << " covers off by " << worstCover << " px\n";
    EXPECT_GT(figures, 60);
    EXPECT_GT(crossings, 60);
    EXPECT_GT(counted, 20);
    EXPECT_GT(covers, 10);
}

struct DrawnLine {
    dvec2 from, to;
};

/// All strokes that are no outlines of filled areas, and no leader of a label.
std::vector<DrawnLine> drawnLines(const std::string& drawing) {
    static const std::regex path(R"re(<path d="([^"]*)"([^>]*)/>)re"), point(R"re(([ML])([-0-9.]+) ([-0-9.]+))re");
    std::vector<DrawnLine> all;
    for (auto it = std::sregex_iterator(drawing.begin(), drawing.end(), path); it != std::sregex_iterator(); ++it) {
        const std::string way = (*it)[1], rest = (*it)[2];
        if (rest.find("fill=") != std::string::npos || rest.find("#8c8c8c") != std::string::npos) continue;
        dvec2 last(0.0);
        for (auto p = std::sregex_iterator(way.begin(), way.end(), point); p != std::sregex_iterator(); ++p) {
            const dvec2 here(std::stod((*p)[2]), std::stod((*p)[3]));
            if ((*p)[1] == "L") all.push_back({last, here});
            last = here;
        }
    }
    return all;
}

/// Does the line pass through the box? By its signed distances to the corners, and its ends.
bool passes(const DrawnLine& line, const drawing::Box& box) {
    double low = 0, high = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = line.to[axis] - line.from[axis], start = box.corner[axis] - line.from[axis],
                     end = start + box.size[axis];
        if (way == 0 && (start > 0 || end < 0)) return false;
        if (way == 0) continue;
        low = std::max(low, std::min(start / way, end / way));
        high = std::min(high, std::max(start / way, end / way));
    }
    return low < high;
}

// A label keeps away from all lines where there is a free place near by. Where there is none, it has a white rim.
TEST(MarksTest, LinesDoNotRunThroughLabels) {
    std::mt19937 random(5);
    int labels = 0, crossed = 0, figures = 0;
    for (int i = 0; i < 25; ++i) {
        const scene::Snapshot scene = testing::snapshot(madeUp(random));
        for (const char* technique : {"planar", "shadow-volume-zfail", "shadow-map"}) {
            const ivec2 pixel(40 + static_cast<int>(random() % 240), 60 + static_cast<int>(random() % 110));
            const Probe probe = ask(scene, technique, pixel);
            if (!canDraw(probe)) continue;
            const std::string drawing = pixelDiagram(probe, *scene, testFont()).document();
            const std::vector<DrawnLine> lines = drawnLines(drawing);
            ++figures;
            for (const Written& one : written(drawing)) {
                // The field is on the left, between heading and legend.
                const bool inField = one.box.corner.x + one.box.size.x < 1040 && one.box.corner.y > 80 &&
                                     one.box.corner.y + one.box.size.y < 1000;
                // Numbers of areas are meant to lie in what they count, under the lines.
                if (!inField || one.em > 25) continue;
                ++labels;
                const bool isCrossed =
                    std::ranges::any_of(lines, [&](const DrawnLine& line) { return passes(line, one.box); });
                crossed += isCrossed;
                if (isCrossed) std::cout << "crossed: " << technique << " " << i << ": " << one.text << "\n";
            }
        }
    }
    std::cout << figures << " figures, " << labels << " labels, " << crossed << " of them crossed by a line\n";
    EXPECT_GT(labels, 200);
    EXPECT_LE(crossed, labels / 50) << "only where everything near is full of lines";
}

} // namespace
} // namespace shadowlab::figures
