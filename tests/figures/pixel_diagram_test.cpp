// The drawings of a pixel ray: what stands in them, and that it can be read.
// SPDX-License-Identifier: MIT
#include "app/figures/pixel_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "app/context/assets.h"
#include "app/figures/drawing_plane.h"
#include "app/figures/panels.h"
#include "app/figures/rays/shown_tree.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/figures/written.h"

namespace shadowlab::figures {
namespace {

struct Asked {
    scene::Snapshot scene;
    Probe probe;
};

Asked ask(const char* name, ivec2 pixel, const char* depth = "10", const char* cutoff = "0.002") {
    Asked asked{scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}), {}};
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    params::setFromText(params::find(slot.params, "depth", "ray-traced"), depth, "ray-traced");
    params::setFromText(params::find(slot.params, "cutoff", "ray-traced"), cutoff, "ray-traced");
    View view;
    view.camera = asked.scene->camera;
    asked.probe = slot.technique->probe(asked.scene, view, pixel, 0);
    return asked;
}

int count(const std::string& text, const std::string& what) {
    int found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++found;
    return found;
}

TEST(PixelDiagramTest, HasEverySurfaceRayAndVector) {
    const Asked asked = ask("mirror-and-glass", {500, 420});
    const std::string drawing = pixelDiagram(asked.probe, *asked.scene, testFont()).document();
    const ShownTree shown = shownTree(asked.probe);
    const std::vector<Written> all = written(drawing);
    const auto times = [&](const std::string& text) { return std::ranges::count(all, text, &Written::text); };
    int surfaces = 0, rays = 0;
    for (const int ray : shown.rays) {
        const Probe::Node& node = asked.probe.tree[static_cast<std::size_t>(ray)];
        if (!node.surface.empty()) {
            ++surfaces;
            EXPECT_GE(times(node.surface), 1) << node.surface << " in the paths";
            EXPECT_EQ(times(node.surface + "  " + node.object), 1) << "in the tree";
        }
        if (!node.sign.empty() && node.segment >= 0) {
            ++rays;
            EXPECT_GE(times(node.sign), 1) << node.sign << " in the paths";
            EXPECT_TRUE(
                std::ranges::any_of(all, [&](const Written& w) { return w.text.starts_with(node.sign + "   "); }))
                << node.sign << " in the tree";
        }
    }
    EXPECT_GE(surfaces, 4);
    EXPECT_GE(rays, 6);
    // Of the tree: a box for each shown ray's end, as many edges, one of them from the pixel; and the sheet's own two
    // rectangles, the pixel's square, and the clip.
    EXPECT_EQ(count(drawing, "<rect"), static_cast<int>(shown.rays.size()) + 3);
    for (const char* letter : {"u", "V", "N", "R", "T", "L", "H"}) // R and T are indices of I as well, which are smaller
        EXPECT_EQ(std::ranges::count_if(all, [&](const Written& w) { return w.text == letter && w.em >= kText; }), 2) << letter << ": at its arrow, and in the table";
    for (const char* title :
         {"Paths of pixel rays", "Ray-tracing tree", "Vectors at S1, glass ball", "projection plane"})
        EXPECT_EQ(times(title), 1) << title;
}

// Also where glass makes hundreds of rays: what is left out is said.
TEST(PixelDiagramTest, LabelsAreReadableAndCoverNoOther) {
    int compared = 0, drawings = 0, limited = 0;
    struct Looked {
        const char* scene;
        ivec2 first, step, end;
    };
    for (const Looked& looked : {Looked{"mirror-and-glass", {130, 260}, {170, 150}, {1280, 700}},
                                 Looked{"mirror-and-glass", {420, 370}, {31, 29}, {520, 470}}, // the glass ball
                                 Looked{"still-life", {130, 260}, {230, 190}, {1280, 700}},
                                 Looked{"three-lights", {130, 260}, {230, 190}, {1280, 700}}})
        for (int x = looked.first.x; x < looked.end.x; x += looked.step.x)
            for (int y = looked.first.y; y < looked.end.y; y += looked.step.y) {
                const Asked asked = ask(looked.scene, {x, y}, "12", "0");
                if (asked.probe.tree.empty()) continue;
                const std::string drawing = pixelDiagram(asked.probe, *asked.scene, testFont()).document();
                ++drawings;
                if (shownTree(asked.probe).leftOut > 0) {
                    ++limited;
                    EXPECT_NE(drawing.find("left out:"), std::string::npos);
                }
                EXPECT_EQ(drawing.find("nan"), std::string::npos);
                EXPECT_EQ(drawing.find("inf"), std::string::npos);
                const std::vector<Written> all = linesOf(written(drawing));
                for (std::size_t i = 0; i < all.size(); ++i) {
                    EXPECT_GE(all[i].box.corner.x, 0) << looked.scene << " " << x << "," << y << ": " << all[i].text;
                    EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, 1920) << all[i].text;
                    for (std::size_t j = 0; j < i; ++j, ++compared)
                        EXPECT_FALSE(all[i].box.overlaps(all[j].box))
                            << looked.scene << " " << x << "," << y << ": " << all[i].text << " covers " << all[j].text;
                }
            }
    std::cout << drawings << " drawings, " << limited << " of them limited, " << compared << " pairs of labels\n";
    EXPECT_GT(drawings, 30);
    EXPECT_GT(limited, 3);
    EXPECT_GT(compared, 10'000);
}

TEST(ShownTreeTest, KeepsTheLargestSharesEachWithAllItComesFrom) {
    const Asked asked = ask("mirror-and-glass", {500, 420}, "12", "0");
    const ShownTree shown = shownTree(asked.probe);
    ASSERT_GT(shown.leftOut, 10);
    std::size_t rays = 0;
    for (const Probe::Node& node : asked.probe.tree)
        rays += node.light < 0;
    EXPECT_EQ(shown.rays.size() + static_cast<std::size_t>(shown.leftOut), rays);
    for (const int ray : shown.rays) {
        const int parent = asked.probe.tree[static_cast<std::size_t>(ray)].parent;
        EXPECT_TRUE(parent < 0 || shown.shows(parent));
    }
    EXPECT_LT(shown.largestLeftOut, 0.1);
}

TEST(DrawingPlaneTest, HoldsTheIncomingTheReflectedAndTheRefractedRay) {
    const Asked asked = ask("mirror-and-glass", {500, 420});
    int checked = 0;
    for (const DrawingPlane& plane : {planeOfIncidence(asked.probe), planeWithNormalUp(asked.probe)}) {
        EXPECT_NEAR(glm::dot(plane.rightWorld, plane.upWorld), 0, 1e-12);
        for (const Probe::Vector& vector : asked.probe.vectors) {
            if (std::string("uVNRT").find(vector.label) == std::string::npos) continue;
            EXPECT_NEAR(glm::length(plane.ofDirection(vector.directionWorld)), 1, 1e-9) << vector.label;
            ++checked;
        }
        EXPECT_LT(plane.of(asked.probe.geometry.front().fromWorld).x, 0) << "the eye is on the left";
    }
    EXPECT_EQ(checked, 10);
}

TEST(DrawingPlaneTest, CutPassesTheFirstSurface) {
    const Asked asked = ask("mirror-and-glass", {500, 420});
    const DrawingPlane plane = planeOfIncidence(asked.probe);
    const std::vector<dvec2> segments = cut(*asked.scene, plane);
    ASSERT_GT(segments.size(), 100u);
    // S1 lies on the cut: some segment passes it.
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < segments.size(); i += 2) {
        const dvec2 way = segments[i + 1] - segments[i];
        const double t =
            glm::length(way) > 0 ? glm::clamp(-glm::dot(segments[i], way) / glm::dot(way, way), 0.0, 1.0) : 0;
        nearest = std::min(nearest, glm::length(segments[i] + t * way));
    }
    EXPECT_LT(nearest, 1e-6) << "positions are floats of about a metre";
}

TEST(LabelsTest, FindAFreePlaceOrSayThatThereIsNone) {
    drawing::Drawing drawing({200, 100});
    drawing::Labels labels(testFont(), {{0, 0}, {200, 100}});
    int placed = 0;
    while (placed < 100 && labels.place(drawing, {100, 50}, "label", {.size = 24}))
        ++placed;
    EXPECT_GE(placed, 3);
    EXPECT_LT(placed, 12) << "more do not fit beside one another";
}

TEST(LabelsTest, MayBeFormulas) {
    drawing::Drawing drawing({400, 300});
    drawing::Labels labels(drawing::FormulaFonts{testFont(), testBoldFont()}, {{0, 0}, {400, 300}});
    ASSERT_TRUE(labels.place(drawing, {200, 150}, "plane $n_f = 2$", {.size = 24}));
    std::string all;
    for (const drawing::Mark& mark : drawing.marks())
        if (const auto* line = std::get_if<drawing::TextLine>(&mark)) all += line->text;
    EXPECT_EQ(all, "plane nf=2");
}

// Of two ways to a free place the line to a label takes the one on which nothing lies.
TEST(LabelsTest, LinesToLabelsKeepAwayFromOtherLines) {
    drawing::Drawing drawing({600, 400});
    drawing::Labels labels(testFont(), {{0, 0}, {600, 400}});
    labels.avoid({{200, 120}, {200, 160}});     // no room near the place
    labels.avoid({180, 100}, {420, 100});       // above, left and right of it is a line
    labels.avoid({180, 100}, {180, 300});
    labels.avoid({420, 100}, {420, 300});
    ASSERT_TRUE(labels.place(drawing, {300, 200}, "named", {.size = 24}));
    int leaders = 0;
    for (const drawing::Mark& mark : drawing.marks())
        if (const auto* line = std::get_if<drawing::Line>(&mark)) {
            ++leaders;
            EXPECT_GT(line->points[1].y, 200) << "downward";
            EXPECT_GT(glm::length(line->points[1] - line->points[0]), 15) << "no speck";
        }
    EXPECT_EQ(leaders, 1);
}

TEST(SvgTest, EscapesWhatComesFromFiles) {
    drawing::Drawing drawing({10, 10});
    drawing.text({0, 0}, "a<b & \"c\"\n", {});
    const std::string document = drawing.document("t");
    EXPECT_NE(document.find("a&lt;b &amp; &quot;c&quot; "), std::string::npos);
}

} // namespace
} // namespace shadowlab::figures
