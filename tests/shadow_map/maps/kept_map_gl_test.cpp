// A map that is kept from frame to frame: never a map of something else, and not drawn again while only the eye moves.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using KeptMapTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};

struct Drawn {
    image::Image picture;
    double redrawn = -1, of = -1;
};

Drawn draw(picture::Session& session, picture::Slot& slot) {
    View view;
    view.camera = session.snapshot()->camera;
    view.size = kSize;
    const picture::RenderedFrame frame = session.render(slot, view);
    Drawn drawn{picture::PictureEncoder().encode(slot.target.color, 1)};
    const auto counter = std::ranges::find(frame.result.counters, "maps-redrawn", &Counter::id);
    if (counter != frame.result.counters.end()) drawn.redrawn = counter->built, drawn.of = counter->of;
    return drawn;
}

scene::Scene threeLights() {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::directionalLight({0.5, -1, 0.25}), testing::directionalLight({-0.5, -1, 0.25}),
                    testing::directionalLight({0, -1, -0.5})};
    for (scene::Light& light : scene.lights)
        light.intensity = 0.5;
    return scene;
}

/// The same with a slot that has no map yet.
image::Image fresh(const scene::Scene& scene, const std::vector<std::string>& settings) {
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    lab::applySettings(slots, settings);
    return draw(session, slots[0]).picture;
}

picture::Slot slotWith(const std::vector<std::string>& settings) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    lab::applySettings(slots, settings);
    return std::move(slots[0]);
}

/// Moves the eye by these steps and says how many maps were drawn anew. Every picture is as a fresh slot draws it.
double redrawnOnTheWay(const std::vector<std::string>& settings, const std::vector<double>& steps) {
    scene::Scene scene = threeLights();
    picture::Session session(testing::snapshot(scene));
    picture::Slot slot = slotWith(settings);
    Drawn last = draw(session, slot);
    EXPECT_EQ(last.redrawn, 3);
    double redrawn = 0;
    for (const double x : steps) {
        scene.camera.positionWorld.x = x;
        session.setScene(testing::snapshot(scene));
        const Drawn moved = draw(session, slot);
        EXPECT_EQ(moved.of, 3);
        EXPECT_EQ(moved.picture, fresh(scene, settings));
        EXPECT_NE(moved.picture, last.picture);
        redrawn += moved.redrawn;
        last = moved;
    }
    return redrawn;
}

TEST_F(KeptMapTest, AMovingEyeRedrawsNone) { EXPECT_EQ(redrawnOnTheWay({"shadow-map.fit=scene"}, {1, 2}), 0); }

TEST_F(KeptMapTest, FittedToTheViewItIsRedrawnSeldom) {
    const double redrawn = redrawnOnTheWay({}, {0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0});
    EXPECT_LE(redrawn, 6) << "of 30";
}

TEST_F(KeptMapTest, EveryParameterThatMattersRedrawsIt) {
    const scene::Scene scene = threeLights();
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    draw(session, slots[0]);
    std::vector<std::string> settings;
    for (const std::string setting : {"resolution=256", "slope-bias=0", "rounding-bias=0", "pcf-radius=3",
                                      "filter=hard", "slope-bias=1", "depth-format=16", "resolution=512"}) {
        settings.push_back("shadow-map." + setting);
        lab::applySettings(slots, settings);
        const Drawn changed = draw(session, slots[0]);
        EXPECT_EQ(changed.redrawn, 3) << setting;
        EXPECT_EQ(changed.picture, fresh(scene, settings)) << setting;
        EXPECT_EQ(draw(session, slots[0]).redrawn, 0) << setting;
    }
}

TEST_F(KeptMapTest, WhereMapsWouldTakeTooMuchMemoryTheyShareOneAndTheSamePictureComes) {
    const scene::Scene scene = threeLights();
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    const std::vector<std::string> large = {"shadow-map.resolution=5120"}; // three of them are 79 million texels
    lab::applySettings(slots, large);
    const Drawn first = draw(session, slots[0]), second = draw(session, slots[0]);
    EXPECT_EQ(second.redrawn, 3);
    EXPECT_EQ(second.picture, first.picture);
}

/// Where there is no map, as over a bare floor, every stage is still there: the lecture's pictures are of a map that holds what
/// is seen.
TEST_F(KeptMapTest, StagesNeedNoMapOfTheFramesOwn) {
    scene::Scene floor = testing::floorScene();
    floor.lights = {testing::pointLight({1, 3, 1})};
    std::size_t published = 0;
    for (const scene::Scene& scene : {floor, testing::simpleScene()})
        for (const char* technique : {"shadow-map", "shadow-map-exact", "shadow-map-alias-free"}) {
            picture::Session session(testing::snapshot(scene));
            picture::Slot slot = picture::Session::makeSlot(technique);
            View view;
            view.camera = scene.camera;
            view.size = kSize;
            FrameRequest request;
            for (const StageInfo& stage : slot.info->stages)
                request.stages.push_back({std::string(stage.id), stage.perLight ? 0 : kNoLight});
            const picture::RenderedFrame frame = session.render(slot, view, request);
            EXPECT_EQ(frame.result.stages.size(), request.stages.size()) << technique;
            EXPECT_EQ(gl::takeDebugMessages(), "") << technique;
            published += frame.result.stages.size();
        }
    EXPECT_GE(published, 2u * (14 + 11 + 2));
}

} // namespace
} // namespace shadowlab
