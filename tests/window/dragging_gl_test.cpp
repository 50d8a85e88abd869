// The mouse drags every light and every object of every scene in the window, whether the picture shows it or not, and undo takes it back.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/lab/object_picking.h"
#include "app/window/gizmo.h"
#include "app/window/panels/panels.h"
#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

constexpr ivec2 kWindow(480, 320);
constexpr float kPixels = 24;

class WindowDraggingTest : public testing::ScreenFixture {};

/// A small window with one picture, whose scene is drawn without shadows: what is tested is the mouse.
struct Hand : testing::Lab {
    explicit Hand(const scene::Snapshot& scene) : Lab(scene, kWindow) {
        ui.shown.panel = false;
        ui.bench.change("", [](lab::Document& d) {
            d.layout = picture::Layout::single;
            d.panes[0].technique = "unshadowed";
        });
        for (int i = 0; i < 3; ++i)
            screen.frame(0.03);
    }
    void to(const dvec2& place, bool down) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {static_cast<float>(place.x), static_cast<float>(place.y)};
        io.MouseDown[0] = down;
        screen.frame(0.03);
    }
    void drag(const dvec2& from, const dvec2& by) {
        to(from, false);
        to(from, true);
        for (int i = 1; i <= 3; ++i)
            to(from + by * (i / 3.0), true);
        to(from + by, false);
    }
    [[nodiscard]] std::map<std::string, dvec2> places() {
        std::map<std::string, dvec2> places;
        for (const window::ShownPane& pane : screen.shownPanes())
            for (const auto& [name, place] : window::handlePlaces(ui, pane, screen.theme()))
                places[name] = place;
        return places;
    }
};

// Under the line in the middle of the still life lie a vase and the table: the mouse takes the line.
TEST_F(WindowDraggingTest, TheSplitLineLiesOverObjects) {
    Hand hand(scene("still-life"));
    window::chooseLayout(hand.ui, picture::Layout::split);
    hand.screen.frame(0.03);
    int dragged = 0;
    for (const double share : {0.2, 0.35, 0.5, 0.65, 0.8}) {
        const window::ShownPane pane = hand.screen.shownPanes().front();
        const dvec2 corner(pane.area.corner), size(pane.area.size);
        const dvec2 place(corner.x + size.x, corner.y + share * size.y);
        const double before = hand.ui.bench.document().split;
        const scene::Snapshot scene = hand.ui.bench.document().scene;
        hand.drag(place, {share < 0.6 ? 20.0 : -20.0, 0});
        EXPECT_GT(std::abs(hand.ui.bench.document().split - before), 0.02) << share;
        EXPECT_EQ(hand.ui.bench.document().scene, scene) << share;
        ++dragged;
    }
    EXPECT_EQ(dragged, 5);
}

TEST_F(WindowDraggingTest, EveryLightAndObjectOfEverySceneFollowsTheMouseAndComesBack) {
    int dragged = 0, outside = 0;
    for (const std::string& name : scene::builtInScenes(context::assetsRoot())) {
        Hand hand(scene(name));
        const lab::Document start = hand.ui.bench.document();
        for (const lab::Handle& handle : lab::handles(*start.scene, scene::objectBounds(*start.scene), start.camera)) {
            hand.ui.selection = handle.what; // of two that lie in one place, this one is meant
            hand.to({0, 0}, false);
            const auto places = hand.places();
            const auto place = places.find(handle.label);
            ASSERT_NE(place, places.end()) << name << ", " << handle.label << " can be taken hold of nowhere";
            const double angle = dragged % 8 * std::numbers::pi / 4;
            const dvec2 by = static_cast<double>(kPixels) * dvec2(std::cos(angle), std::sin(angle));
            hand.drag(place->second, by);
            const std::string what = name + ", " + handle.label + ", direction " + std::to_string(dragged % 8);
            EXPECT_NE(hand.ui.bench.document().scene, start.scene) << what << " stays";
            EXPECT_EQ(hand.ui.bench.document().camera, start.camera) << what << ": the camera moved instead";
            const auto before = lab::pixelOf(start.camera, kWindow, handle.positionWorld);
            const auto after = hand.places().find(handle.label)->second;
            const bool wasOutside = !before || glm::length(place->second - after) < 1e-9 || before->x < 0 || before->y < 0 ||
                                    before->x > kWindow.x || before->y > kWindow.y;
            outside += wasOutside;
            // Within 26 degrees of the mouse's way, and a third of it where the ground is seen nearly edge-on.
            if (!wasOutside) {
                EXPECT_GT(glm::dot(after - place->second, by) / glm::length(by), 0.3 * glm::length(by)) << what;
            }
            hand.ui.bench.undo();
            EXPECT_EQ(hand.ui.bench.document().scene, start.scene) << what << ": undo does not bring it back";
            ++dragged;
        }
    }
    EXPECT_GE(dragged, 60);
    EXPECT_GE(outside, 10) << "lights that no picture shows";
}

// Not only the middle of an object: a place near its edge is as good. On the floor the camera is turned.
TEST_F(WindowDraggingTest, AnyPlaceOfAnObjectIsAHandleAndTheFloorIsNone) {
    Hand hand(scene("still-life"));
    const lab::Document start = hand.ui.bench.document();
    const window::ShownPane pane = hand.screen.shownPanes()[0];
    const std::vector<scene::Bounds> bounds = scene::objectBounds(*start.scene);
    int objects = 0, floors = 0, far = 0;
    for (int y = 10; y < pane.area.size.y; y += 34)
        for (int x = 10; x < pane.area.size.x; x += 34) {
            const dvec2 pixel(x, y), place = pixel + dvec2(pane.area.corner);
            const auto hit = lab::objectAt(*start.scene, bounds, start.camera, pane.area.size, pixel);
            bool nearHandle = false;
            for (const auto& [name, at] : hand.places())
                nearHandle = nearHandle || glm::length(at - place) < 2 * hand.screen.theme().em;
            if (!hit) continue;
            const bool isThing = !lab::isBackdrop(bounds, hit->object);
            if (!isThing && nearHandle) continue;
            hand.ui.selection = {};
            hand.drag(place, {12, 0});
            const lab::Document& now = hand.ui.bench.document();
            if (isThing) {
                EXPECT_NE(now.scene, start.scene) << "an object at " << x << ", " << y;
                EXPECT_EQ(now.camera, start.camera);
                far += !nearHandle;
            } else {
                EXPECT_EQ(now.scene, start.scene) << "the floor at " << x << ", " << y;
                EXPECT_NE(now.camera, start.camera);
            }
            ++(isThing ? objects : floors);
            hand.ui.bench.undo();
            EXPECT_EQ(hand.ui.bench.document().camera, start.camera) << "undo brings the camera back as well";
            EXPECT_EQ(hand.ui.bench.document().scene, start.scene);
        }
    EXPECT_GE(objects, 8);
    EXPECT_GE(far, 4);
    EXPECT_GE(floors, 20);
}

TEST_F(WindowDraggingTest, EscClosesAnOpenListAndArrowsStayInIt) {
    Hand hand(scene("still-life"));
    const scene::Camera camera = hand.ui.bench.document().camera;
    const dvec2 combo(20, 0.5 * window::topBarHeight()); // the choice of scenes
    hand.drag(combo, {0, 0});
    hand.to(combo, false);
    ASSERT_TRUE(hand.screen.isListOpen());
    for (const int key : {GLFW_KEY_LEFT, GLFW_KEY_DOWN, GLFW_KEY_V, GLFW_KEY_J}) {
        hand.ui.keys.push_back({key, false, false, false, false});
        hand.screen.frame(0.03);
        EXPECT_TRUE(hand.screen.ran().empty());
    }
    EXPECT_EQ(hand.ui.bench.document().camera, camera);
    hand.ui.selection = {lab::Selection::Kind::light, 0};
    hand.ui.keys.push_back({GLFW_KEY_ESCAPE, false, false, false, false});
    hand.screen.frame(0.03);
    hand.screen.frame(0.03);
    EXPECT_FALSE(hand.screen.isListOpen());
    EXPECT_EQ(hand.ui.selection.kind, lab::Selection::Kind::light) << "one press of Esc leaves one thing";
    hand.ui.keys.push_back({GLFW_KEY_LEFT, false, false, false, false});
    hand.ui.selection = {};
    hand.screen.frame(0.03);
    EXPECT_NE(hand.ui.bench.document().camera, camera) << "then the arrows turn the camera again";
}

TEST_F(WindowDraggingTest, TheNextLightIsNamedAndFlashes) {
    Hand hand(scene("three-lights"));
    hand.ui.live = true;
    hand.screen.frame(0.03);
    hand.ui.keys.push_back({GLFW_KEY_L, false, false, false, false});
    hand.screen.frame(0.03);
    EXPECT_EQ(hand.ui.bench.document().light, 1);
    std::set<std::vector<std::uint8_t>> seen;
    for (int i = 0; i < 30; ++i) {
        hand.screen.frame(0.03);
        seen.insert(pixels(hand.screen));
    }
    EXPECT_GE(seen.size(), 2u) << "nothing on the screen changes";
}

} // namespace
} // namespace shadowlab
