// Radiosity in slices of time, as the window draws it: its picture is drawn again only where it would be another one.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using RadiositySlicesTest = testing::GlTest;

/// A slice in which all that is done is the least that each call does.
FrameRequest slice() {
    FrameRequest request;
    request.deadline = Deadline::min();
    return request;
}

scene::Snapshot cornellRoom() {
    return scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

View viewOf(const scene::Snapshot& scene) {
    View view;
    view.camera = scene->camera;
    view.size = {160, 90};
    return view;
}

TEST_F(RadiositySlicesTest, WhatHasNotChangedIsNotDrawnAgain) {
    const scene::Snapshot scene = cornellRoom();
    View view = viewOf(scene);
    picture::Session session(scene);
    picture::Slot slices = picture::Session::makeSlot("radiosity"), whole = picture::Session::makeSlot("radiosity");
    int frames = 0, drawn = 0;
    for (bool isConverged = false; !isConverged; ++frames) {
        const picture::RenderedFrame frame = session.render(slices, view, slice());
        isConverged = frame.converged;
        drawn += !frame.result.passes.empty();
    }
    // Ambient light, the preview, direct light, what patches reflect (before and after the equations are solved), what is gathered.
    EXPECT_GE(drawn, 3);
    EXPECT_LE(drawn, 8);
    EXPECT_GT(frames, 4 * drawn);

    ASSERT_TRUE(session.render(whole, view).converged);
    EXPECT_EQ(gl::readTexels(slices.target.color), gl::readTexels(whole.target.color)) << "bit by bit";

    // Whoever asks for a stage, or stops after a pass, gets it; another eye is another picture.
    FrameRequest asking = slice();
    asking.stopAfter = StageKey{"emission"};
    EXPECT_FALSE(session.render(slices, view, asking).result.passes.empty());
    view.camera.positionWorld.x += 0.05;
    EXPECT_FALSE(session.render(slices, view, slice()).result.passes.empty());
}

/// How many pixels differ by more than a tenth of the brightest one.
std::ptrdiff_t unlike(const std::vector<vec4>& a, const std::vector<vec4>& b) {
    float brightest = 0;
    for (const vec4& texel : b)
        brightest = std::max(brightest, texel.g);
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += std::abs(a[i].g - b[i].g) > 0.1f * brightest;
    return count;
}

// The first direct light is that of blocks of pixels: a sixteenth of the rays, and right but for the edges of shadows.
TEST_F(RadiositySlicesTest, DirectLightComesFirstInBlocksOfPixels) {
    const scene::Snapshot scene = scene::loadScene("sphere-on-plane", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    View view = viewOf(scene);
    view.size = {94, 53}; // no whole number of blocks
    picture::Session session(scene);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("radiosity"));
    lab::applySettings(slots, {"radiosity.patches=4000"}); // enough to be seconds of work
    picture::Slot& slot = slots.front();
    std::vector<std::vector<vec4>> pictures; // with direct light, while patches are not there
    std::vector<int> frames;
    for (int frame = 1; pictures.size() < 2; ++frame) {
        const std::vector<StageKey> passes = session.render(slot, view, slice()).result.passes;
        if (std::ranges::find(passes, "direct", &StageKey::id) == passes.end()) continue;
        ASSERT_EQ(std::ranges::find(passes, "solve", &StageKey::id), passes.end()) << "form factors are not there yet";
        pictures.push_back(gl::readTexels(slot.target.color));
        frames.push_back(frame);
    }
    EXPECT_LT(4 * frames[0], frames[1]) << "a sixteenth of the work, and some that both have in common";
    FrameRequest ambient = slice();
    ambient.stopAfter = StageKey{"emission"};
    session.render(slot, view, ambient);
    const std::vector<vec4> dark = gl::readTexels(slot.target.color);
    EXPECT_GT(unlike(dark, pictures[1]), view.size.x * view.size.y / 2) << "most of it is lit";
    EXPECT_LT(unlike(pictures[0], pictures[1]), view.size.x * view.size.y / 25);
    EXPECT_GT(unlike(pictures[0], pictures[1]), 10) << "or they were not blocks";
}

// A slice may be long: what it shows first is shown before it is over.
TEST_F(RadiositySlicesTest, AFirstPictureEndsItsSlice) {
    const scene::Snapshot scene = cornellRoom();
    picture::Session session(scene);
    picture::Slot slot = picture::Session::makeSlot("radiosity");
    FrameRequest hour;
    hour.deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
    const picture::RenderedFrame first = session.render(slot, viewOf(scene), hour);
    EXPECT_FALSE(first.converged);
    const auto has = [&](const char* pass) { return std::ranges::find(first.result.passes, pass, &StageKey::id) != first.result.passes.end(); };
    EXPECT_TRUE(has("direct"));
    EXPECT_FALSE(has("solve")) << "form factors come later";
    // In an hour all that is left is done: nothing else ends a slice.
    const picture::RenderedFrame next = session.render(slot, viewOf(scene), hour);
    EXPECT_TRUE(next.converged);
    EXPECT_GT(next.result.passes.size(), first.result.passes.size());
}

// In the middle of the work a picture that ends after a pass is drawn into the same target: the whole one has to be drawn again over it.
TEST_F(RadiositySlicesTest, AfterAPartOfThePictureTheWholeIsDrawnAgain) {
    const scene::Snapshot scene = cornellRoom();
    const View view = viewOf(scene);
    picture::Session session(scene);
    picture::Slot slot = picture::Session::makeSlot("radiosity");
    bool isSolved = false;
    for (int notDrawn = 0; !isSolved || notDrawn < 3;) {
        const picture::RenderedFrame frame = session.render(slot, view, slice());
        ASSERT_FALSE(frame.converged) << "there is work left while pixels gather";
        for (const StageKey& pass : frame.result.passes)
            isSolved = isSolved || pass.id == "solve";
        notDrawn = frame.result.passes.empty() ? notDrawn + 1 : 0;
    }
    const std::vector<vec4> before = gl::readTexels(slot.target.color);
    FrameRequest asking = slice();
    asking.stopAfter = StageKey{"display"};
    session.render(slot, view, asking);
    EXPECT_NE(gl::readTexels(slot.target.color), before) << "without direct light";
    EXPECT_FALSE(session.render(slot, view, slice()).result.passes.empty());
}

} // namespace
} // namespace shadowlab
