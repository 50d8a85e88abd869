// The stage shadow-outline: a line where the shadow really ends, whatever the technique says, and nothing else changed.
// SPDX-License-Identifier: MIT
#include "app/picture/stages/shadow_outline.h"

#include "app/lab/pane.h"
#include "app/lab/settings.h"
#include "app/picture/derived_stages.h"
#include "app/picture/outside/shape_painter.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/levels_apart.h"
#include "tests/support/plane_view.h"
#include "tests/support/scenes.h"

namespace shadowlab::picture {
namespace {

constexpr ivec2 kSize{960, 720}; ///< lines are two pixels wide

struct Drawn {
    image::Image plain; ///< the technique's own picture
    Panel panel;
};

Drawn drawn(const scene::Snapshot& snapshot, const std::string& technique, const std::vector<std::string>& settings,
            ivec2 size = kSize, const Region& region = {}) {
    Session session(snapshot);
    std::vector<Slot> slots;
    slots.push_back(Session::makeSlot(technique));
    lab::applySettings(slots, settings);
    View view;
    view.camera = snapshot->camera;
    view.size = size;
    view.region = region;
    const StageKey key{"shadow-outline", 0};
    FrameRequest request;
    request.stages = neededFor(key);
    const PictureEncoder encoder;
    const RenderedFrame rendered = session.render(slots[0], view, request);
    Drawn drawn;
    drawn.plain = encoder.encode(slots[0].target.color, snapshot->exposure);
    drawn.panel = derivedPanel(session, slots[0], rendered, encoder, {key, view, {}, nullptr});
    return drawn;
}

image::Color8 lineColor() {
    const vec3& c = look::kTrueOutline;
    return {image::srgbFromLinear(c.r), image::srgbFromLinear(c.g), image::srgbFromLinear(c.b), 255};
}

template <typename Visit>
void forEachPixel(ivec2 size, const Visit& visit) {
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            visit(x, y);
}

int pixelsOfLine(const image::Image& picture) {
    int pixels = 0;
    forEachPixel({picture.width, picture.height}, [&](int x, int y) { pixels += picture.at(x, y) == lineColor(); });
    return pixels;
}

struct Misplaced {
    int line = 0;    ///< pixels of the line's colour
    int missing = 0; ///< that lie on the curve and are not of that colour
    int stray = 0;   ///< that lie far from it and have changed
};
/// `shift`: as if the line had been drawn so much elsewhere.
Misplaced against(const testing::EllipseInPicture& ellipse, const Drawn& drawn, ivec2 shift) {
    const ivec2 size(drawn.plain.width, drawn.plain.height);
    // Half the line's width, and its rim's; smoothed by half a pixel to both sides. A tenth for what a chord cuts off.
    const double half = lineWidth(size.y) / 3, rim = 2 * half;
    Misplaced found;
    forEachPixel(size, [&](int x, int y) {
        const double distance = std::abs(ellipse.distancePx(dvec2(x, y) + 0.5 + dvec2(shift)));
        const bool isLine = drawn.panel.picture.at(x, y) == lineColor();
        found.line += isLine;
        found.missing += distance < half - 0.6 && !isLine;
        found.stray += distance > rim + 0.6 && drawn.panel.picture.at(x, y) != drawn.plain.at(x, y);
    });
    return found;
}

using ShadowOutline = testing::GlTest;

TEST_F(ShadowOutline, IsDrawnWhereTheConicIsAndNowhereElse) {
    const ivec2 size{1280, 720};
    const testing::SphereShadow shadow = testing::sphereShadow(size, 256);
    const Drawn picture = drawn(testing::snapshot(shadow.scene), "ray-traced", {}, size);
    const Misplaced found = against(shadow.ellipse, picture, ivec2(0));
    EXPECT_GT(found.line, 1000); // of an outline of 1500 pixels, whose line is two wide
    EXPECT_EQ(found.missing, 0);
    EXPECT_EQ(found.stray, 0);
    for (const ivec2& shift : {ivec2(1, 0), ivec2(0, 1)}) { // what the same test says to a line that is a pixel off
        const Misplaced shifted = against(shadow.ellipse, picture, shift);
        EXPECT_GT(shifted.missing + shifted.stray, 200);
    }
}

// A pixel that the line covers all but for a hundredth keeps so much of what is below: white stays white, black is this much darker.
constexpr int kAllButCovered = 3;

TEST_F(ShadowOutline, IsTheSameOverAnyTechnique) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    const Drawn exact = drawn(snapshot, "ray-traced", {});
    ASSERT_GT(pixelsOfLine(exact.panel.picture), 300);
    EXPECT_EQ(pixelsOfLine(exact.plain), 0) << "nothing in the scene has the line's colour";
    const std::vector<std::pair<std::string, std::vector<std::string>>> others = {
        {"shadow-map", {"shadow-map.resolution=64"}}, {"unshadowed", {}}, {"planar", {}}};
    for (const auto& [technique, settings] : others) {
        const Drawn other = drawn(snapshot, technique, settings);
        int differing = 0, compared = 0;
        forEachPixel(kSize, [&](int x, int y) {
            differing += other.plain.at(x, y) != exact.plain.at(x, y);
            const image::Color8 here = exact.panel.picture.at(x, y), there = other.panel.picture.at(x, y);
            if (here != lineColor() && there != lineColor()) return;
            EXPECT_LE(testing::levelsApart(here, there), kAllButCovered);
            ++compared;
        });
        EXPECT_GT(compared, 300);
        EXPECT_GT(differing, 100) << technique << " must be wrong here, else this shows nothing";
        EXPECT_EQ(other.panel.display.key[0].label, exact.panel.display.key[0].label);
    }
}

TEST_F(ShadowOutline, LiesOnTheShadowsEdgeOfATechniqueThatIsRight) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    const std::vector<judge::OutlineSegment>& outline = session.outline(view, 0);
    Slot slot = Session::makeSlot("shadow-volume-zfail");
    FrameRequest request;
    request.stages = {{"visibility", 0}};
    const VisibilityImage answers = readVisibility(findStage(session.render(slot, view, request), {"visibility", 0}));
    int ends = 0, onAnEdge = 0;
    for (const judge::OutlineSegment& segment : outline) {
        // An end lies between the centres of two pixels, one of them lit: below and right of `corner`, half a pixel off.
        const dvec2 fromCentres = segment.from - 0.5;
        const ivec2 low(glm::floor(fromCentres + 1e-9)), high(glm::ceil(fromCentres - 1e-9));
        ++ends;
        onAnEdge += answers.grey(low.x, low.y) != answers.grey(high.x, high.y);
    }
    EXPECT_GT(ends, 300);
    EXPECT_GE(onAnEdge, ends - 2); // ties
}

TEST_F(ShadowOutline, IsDrawnAndMeasuredInItsRegionOnly) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    const Region right{{kSize.x / 2, 0}, {kSize.x / 2, kSize.y}};
    const Drawn all = drawn(snapshot, "ray-traced", {}), half = drawn(snapshot, "ray-traced", {}, kSize, right);
    int inside = 0;
    forEachPixel(kSize, [&](int x, int y) {
        const bool isLine = half.panel.picture.at(x, y) == lineColor();
        const bool expected = x >= kSize.x / 2 && all.panel.picture.at(x, y) == lineColor();
        EXPECT_EQ(isLine, expected) << x << ' ' << y;
        inside += isLine;
    });
    EXPECT_GT(inside, 50);
    EXPECT_LT(inside, pixelsOfLine(all.panel.picture));
    EXPECT_NE(all.panel.display.key[0].label, half.panel.display.key[0].label);
}

TEST_F(ShadowOutline, SaysSoWhereNoShadowEnds) {
    scene::Scene scene = testing::floorScene();
    scene.lights = {testing::pointLight({0, 4, 0})};
    const Drawn picture = drawn(testing::snapshot(scene), "shadow-map", {});
    EXPECT_EQ(picture.panel.picture, picture.plain);
    ASSERT_EQ(picture.panel.display.key.size(), 1u);
    EXPECT_EQ(picture.panel.display.key[0].label, "no shadow of 'point' ends here");
}

// So that a pane can hold it while things move. Times are printed, not judged: the machine may be at work elsewhere.
TEST_F(ShadowOutline, IsFoundOnceForAllThatShowTheSameView) {
    scene::Scene scene = testing::simpleScene();
    const auto snapshot = testing::snapshot(scene);
    Session session(snapshot);
    View view;
    view.camera = snapshot->camera;
    view.size = {1280, 720};
    session.truthAtCentres(view, 0); // builds the tree
    const auto timed = [&] {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_GT(session.outline(view, 0).size(), 500u);
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    };
    const double first = timed(), second = timed();
    std::cout << "outline of 1280x720: " << first << " ms, once more: " << second << " ms\n";
    EXPECT_LT(second, first / 10);
}

// A tree for the rays of a large scene takes a while: the window is asked again and again meanwhile, and waits for nothing.
TEST_F(ShadowOutline, ComesToAPaneWhenItsTimeWasEnough) {
    scene::Scene scene = testing::simpleScene();
    testing::addObject(scene, scene::makeSphere(0.3, 256), testing::translation({0, 2, 0}));
    Session session(testing::snapshot(scene));
    const PictureEncoder encoder;
    lab::PaneRequest request;
    request.state = {"shadow-map", {"shadow-outline"}, {}};
    request.snapshot = session.snapshot();
    request.view.camera = scene.camera;
    request.view.size = {160, 120};
    lab::Pane pane;
    int updates = 0;
    double progress = 0;
    do {
        EXPECT_FALSE(pane.picture().texture) << "not before it is done";
        EXPECT_TRUE(pane.update(session, encoder, request, {.deadline = Deadline()}));
        EXPECT_GE(pane.progress(), progress);
        progress = pane.progress();
        ASSERT_EQ(pane.failure(), "");
    } while (++updates < 10'000 && progress < 1);
    EXPECT_GE(updates, 3);
    ASSERT_TRUE(pane.picture().texture);
    EXPECT_TRUE(pane.showsTheEyesView());
    EXPECT_NE(pane.picture().display.key[0].label.find("'point' really ends"), std::string::npos);
    EXPECT_FALSE(pane.update(session, encoder, request, {.deadline = Deadline()})) << "nothing is left to do";
}

} // namespace
} // namespace shadowlab::picture
