// Figures that stand side by side are compared by eye: they have one scale, and eye and light in the same places. And of the
// figures of a single segment: what lies on it lies there in the scene, and arrows end on what they name.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "app/figures/volume/facing_panel.h"
#include "techniques/probed/plane_probe.h"
#include "tests/figures/figure_of.h"

namespace shadowlab::figures {
namespace {

constexpr dvec2 kHalf{930, 800};
// Places of one plane through eye, light and ball, pixels of 1280 x 720: in the shadow, before it and behind it.
constexpr ivec2 kShadowed{871, 504}, kBefore{998, 619}, kBehind{786, 427};

FigureOf ball(const char* technique, ivec2 pixel, std::vector<Setting> settings = {}) {
    return {(context::assetsRoot() / "decks/scenes/floating-ball.json").string(), technique, pixel, std::move(settings)};
}

Diagram drawLimited(const FigureOf& asked, const char* figure, double mostPixelsPerMetre) {
    return findFigure(figure).draw(
        {asked.probe, asked.technique, *asked.scene, asked.view, asked.light, testFont(), testBoldFont(), kHalf, mostPixelsPerMetre});
}

/// The middle of the only circle of that name.
std::optional<dvec2> circle(const Diagram& figure, const std::string& name) {
    std::optional<dvec2> found;
    for (const drawing::Mark& mark : figure.drawing.marks())
        if (const auto* one = std::get_if<drawing::Circle>(&mark); one && one->name == name) {
            EXPECT_FALSE(found) << "two of " << name;
            found = one->centre;
        }
    return found;
}

bool writes(const Diagram& figure, const std::string& words) {
    return std::ranges::any_of(linesOf(written(figure.document())),
                               [&](const Written& line) { return line.text.find(words) != std::string::npos; });
}

/// The heads of arrows: their tips.
std::vector<dvec2> tips(const Diagram& figure) {
    std::vector<dvec2> all;
    for (const drawing::Mark& mark : figure.drawing.marks())
        if (const auto* one = std::get_if<drawing::Line>(&mark);
            one && one->isClosed && one->points.size() == 3 && one->stroke.width == 0)
            all.push_back(one->points[0]);
    return all;
}

double besideLine(dvec2 at, dvec2 from, dvec2 to) {
    const dvec2 way = glm::normalize(to - from), off = at - from;
    return std::abs(way.x * off.y - way.y * off.x);
}

TEST(SideBySideTest, SectionsOfOnePlaneHaveOneScaleAndEyeAndLightInTheSamePlaces) {
    int compared = 0;
    for (const auto& [figure, technique, other] :
         {std::tuple("shadow-ray", "shadow-volume-zfail", kBefore), std::tuple("count", "shadow-volume-zpass", kBehind),
          std::tuple("count", "shadow-volume-zfail", kBefore)}) {
        const FigureOf left = ball(technique, kShadowed), right = ball(technique, other);
        const double least = std::min(left.draw(figure, kHalf).pixelsPerMetre, right.draw(figure, kHalf).pixelsPerMetre);
        ASSERT_GT(least, 0) << figure;
        const Diagram a = drawLimited(left, figure, least), b = drawLimited(right, figure, least);
        EXPECT_EQ(a.pixelsPerMetre, least) << figure;
        EXPECT_EQ(b.pixelsPerMetre, least) << figure;
        for (const char* name : {"eye", "light"}) {
            const auto first = circle(a, name), second = circle(b, name);
            ASSERT_TRUE(first && second) << figure << ", " << name;
            // The pixels lie in one plane to half a pixel of 1280: that many pixels of the drawing at the most.
            EXPECT_LT(glm::length(*first - *second), 8) << figure << ", " << name;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 6);
}

TEST(SideBySideTest, PanelsOfPolygonsKeepALimitAndStandAtTheBottom) {
    const FigureOf asked = ball("shadow-volume-zfail", {480, 173});
    const CasterSolid solid = casterSolid(
        {asked.probe, asked.technique, *asked.scene, asked.view, asked.light, testFont(), testBoldFont(), kHalf}, false);
    const drawing::Box area{{0, 0}, {560, 700}};
    FacingPanel panel(solid, 0, area);
    const double own = panel.pixelsPerMetre();
    ASSERT_GT(own, 0);
    panel.limitScale(0.5 * own);
    EXPECT_NEAR(panel.pixelsPerMetre(), 0.5 * own, 1e-9 * own);
    drawing::Drawing drawing(area.size);
    panel.draw(drawing, testFont());
    double lowest = 0;
    for (const drawing::Mark& mark : drawing.marks())
        if (const auto* surface = std::get_if<drawing::Line>(&mark))
            for (const dvec2& at : surface->points)
                lowest = std::max(lowest, at.y);
    // 52 pixels of margin; strokes and heads of arrows reach a little beyond what they mark.
    EXPECT_NEAR(lowest, 700 - 52, 8);
}

TEST(ShadowRayFigureTest, TheSegmentEndsOnWhatItMeetsFirst) {
    int met = 0;
    for (const char* technique : {"planar", "shadow-map", "shadow-volume-zfail"}) {
        const Diagram shadowed = ball(technique, kShadowed).draw("shadow-ray", kHalf),
                      lit = ball(technique, kBefore).draw("shadow-ray", kHalf);
        EXPECT_TRUE(writes(shadowed, "meets the ball: in shadow")) << technique;
        EXPECT_TRUE(writes(lit, "meets nothing: illuminated")) << technique;
        EXPECT_FALSE(circle(lit, "blocker")) << technique;
        const auto point = circle(shadowed, "point"), light = circle(shadowed, "light"), blocker = circle(shadowed, "blocker");
        ASSERT_TRUE(point && light && blocker) << technique;
        EXPECT_LT(besideLine(*blocker, *point, *light), 1e-6) << technique;
        // The light is 3.1 m above the floor. The ball, of radius 0.45 m, hangs with its centre at 1.2 m: its lower half is met first.
        const double height = 3.1 * (point->y - blocker->y) / (point->y - light->y);
        EXPECT_GT(height, 1.2 - 0.45) << technique;
        EXPECT_LT(height, 1.2) << technique;
        const std::vector<dvec2> heads = tips(shadowed);
        EXPECT_TRUE(std::ranges::any_of(heads, [&](dvec2 tip) { return glm::length(tip - *blocker) < 1; })) << technique;
        ++met;
    }
    EXPECT_EQ(met, 3);
}

TEST(ProjectionFigureTest, LightObjectAndProjectionLieOnOneLine) {
    const FigureOf asked = ball("planar", kShadowed);
    const Diagram figure = asked.draw("projection", {1170, 860});
    const auto projected = circle(figure, "point"), light = circle(figure, "light"), caster = circle(figure, "cover");
    ASSERT_TRUE(projected && light && caster);
    EXPECT_LT(besideLine(*caster, *projected, *light), 0.5) << "a drawing has no finer lines";
    EXPECT_LT(caster->y, projected->y);
    EXPECT_GT(caster->y, light->y);
    // Drawn without the eye, the light's way fills the height of the room.
    EXPECT_GT(projected->y - light->y, 0.75 * 860);
    EXPECT_TRUE(writes(figure, "N \u00b7 P\u2032 + D = 0"));
}

} // namespace
} // namespace shadowlab::figures
