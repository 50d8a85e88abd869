// Distributed ray tracing as the session drives it: slices, stages, and what stays the same.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/half_plane.h"

namespace shadowlab {
namespace {

using DistributedTest = testing::GlTest;

constexpr ivec2 kSize{96, 54};

scene::Snapshot builtIn(const char* name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

struct Drawing {
    explicit Drawing(scene::Snapshot snapshot, const std::vector<std::string>& settings) : session(snapshot) {
        slots.push_back(picture::Session::makeSlot("ray-traced"));
        std::vector<std::string> full;
        for (const std::string& setting : settings)
            full.push_back("ray-traced." + setting);
        lab::applySettings(slots, full);
        view.camera = snapshot->camera;
        view.size = kSize;
    }
    std::vector<vec4> texels() { return gl::readTexels(slots[0].target.color); }
    picture::Session session;
    std::vector<picture::Slot> slots;
    View view;
};

TEST_F(DistributedTest, SlicesGiveTheSameBytesAsOneRun) {
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"samples=3"}, {"samples=2", "soft-shadows=analytic"}, {}, {"structure=none"}}) {
        Drawing whole(builtIn("billiards"), settings), sliced(builtIn("billiards"), settings);
        // Closed forms take their time, and so do the default's many rays: what is tested is where a slice ends.
        if (settings != std::vector<std::string>{"samples=3"}) whole.view.size = sliced.view.size = kSize / 3;
        EXPECT_TRUE(whole.session.render(whole.slots[0], whole.view).converged);
        int slices = 0;
        bool converged = false;
        double last = -1;
        while (!converged && slices < 100000) {
            FrameRequest request;
            request.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(2);
            const auto frame = sliced.session.render(sliced.slots[0], sliced.view, request);
            converged = frame.converged;
            if (frame.prepared == 1) {
                EXPECT_GE(frame.drawn, std::min(last, frame.drawn));
            }
            last = frame.drawn;
            ++slices;
        }
        EXPECT_TRUE(converged);
        EXPECT_GT(slices, 2);
        const std::vector<vec4> expected = whole.texels(), found = sliced.texels();
        EXPECT_GT(std::ranges::count_if(expected, [](const vec4& v) { return v.r > 0.01f; }), 100);
        EXPECT_EQ(found, expected);
    }
}

TEST_F(DistributedTest, RestartsWhenSomethingChangesAndShowsTheFirstPictureMeanwhile) {
    Drawing first(builtIn("billiards"), {}), many(builtIn("billiards"), {"samples=1000"});
    first.session.render(first.slots[0], first.view);
    FrameRequest moving;
    moving.refine = false; // hands are at work
    const auto frame = many.session.render(many.slots[0], many.view, moving);
    EXPECT_FALSE(frame.converged);
    EXPECT_EQ(frame.drawn, 1); // of the first picture
    EXPECT_EQ(many.texels(), first.texels());
    // Some samples, then another camera: the first picture of that one.
    FrameRequest slice;
    slice.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(400);
    many.session.render(many.slots[0], many.view, slice);
    EXPECT_NE(many.texels(), first.texels());
    many.view.camera.positionWorld.x += 0.1;
    first.view.camera.positionWorld.x += 0.1;
    many.session.render(many.slots[0], many.view, moving);
    first.session.render(first.slots[0], first.view);
    EXPECT_EQ(many.texels(), first.texels());
}

TEST_F(DistributedTest, OneSampleIsOneRayThroughEverything) {
    // Whatever else is set: with one sample nothing is left to chance.
    Drawing plain(builtIn("billiards"), {}), set(builtIn("billiards"), {"pattern=random", "aperture=0.2", "focus=1",
                                                                        "shutter=3", "seed=5", "interreflection=true"});
    plain.session.render(plain.slots[0], plain.view);
    set.session.render(set.slots[0], set.view);
    EXPECT_EQ(plain.texels(), set.texels());
}

TEST_F(DistributedTest, SharesOfTheLightAreThoseOfAreaSampledAndExact) {
    for (const char* setting : {"soft-shadows=analytic", "samples=64"}) {
        Drawing drawing(testing::snapshot(testing::halfPlaneUnderSquareLight()), {setting});
        drawing.view.size = testing::kHalfPlaneView.size;
        FrameRequest request;
        request.stages = {{"visibility", 0}, {"penumbra", 0}};
        const auto frame = drawing.session.render(drawing.slots[0], drawing.view, request);
        const std::vector<vec4> texels = gl::readTexels(picture::findStage(frame, {"visibility", 0}).texture);
        const ivec2 size = drawing.view.size;
        int partly = 0;
        double squares = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const double worldX = (x + 0.5 - size.x / 2.0) / testing::kHalfPlaneView.pixelsPerMetre;
                const double expected = std::clamp(0.5 + worldX, 0.0, 1.0);
                const double found = texels[static_cast<std::size_t>(y * size.x + x)].r;
                squares += (found - expected) * (found - expected);
                partly += expected > 0 && expected < 1 ? 1 : 0;
            }
        EXPECT_GE(partly, 200);
        // Jittered 8 x 8: one column of cells is cut, 8 cells of at most 1/4 variance each: sqrt(2) / 64. Exact: float.
        EXPECT_LT(std::sqrt(squares / partly), setting[0] == 's' && setting[1] == 'o' ? 1e-6 : 0.0222);
    }
}

TEST_F(DistributedTest, StagesAreThereForEveryLight) {
    Drawing drawing(builtIn("billiards"), {"samples=2"});
    FrameRequest request;
    request.stages = {{"penumbra", 0}, {"penumbra", 1}, {"visibility", 1}, {"samples-per-pixel", kNoLight}};
    const auto frame = drawing.session.render(drawing.slots[0], drawing.view, request);
    EXPECT_TRUE(frame.converged);
    const auto counts = gl::readTexels(picture::findStage(frame, {"samples-per-pixel", kNoLight}).texture);
    EXPECT_EQ(std::ranges::count_if(counts, [](const vec4& v) { return v.r == 2.0f; }), kSize.x * kSize.y);
}

} // namespace
} // namespace shadowlab
