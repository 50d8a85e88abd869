// The two roads to a picture (techniques/shading_passes.h) give the same one: radiance in floats, encoded at the end, and finished
// pixels drawn at once.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

// Floats of 16 bits keep 11 digits: a sum in them is off by 1/2048 at most for each term, and a level of 255 near white is 1/115 of the
// light there, near black more than 1/77 of it. Two terms then move a value by a tenth of a level, across one border between levels: of
// three channels one is so in three pixels of ten at most.
constexpr int kMostLevels = 1;
constexpr double kMostOneApart = 0.3;

scene::LoadOptions loadOptions() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }

struct Variant {
    std::string technique;
    std::vector<std::string> settings;
};

/// Every program that shades: each counting rule, each layout of maps, filters with and without depths drawn first.
const std::vector<Variant>& variants() {
    static const std::vector<Variant> all = {
        {"unshadowed", {}},
        {"shadow-volume-zpass", {}},
        {"shadow-volume-zpass", {"eye-correction=true", "repair=true"}},
        {"shadow-volume-zfail", {}},
        {"shadow-volume-zfail", {"counter=float"}},
        {"shadow-volume", {}},
        {"shadow-volume", {"two-sided=false"}},
        {"shadow-map", {"filter=hard"}},
        {"shadow-map", {"filter=hard", "cull=false"}},
        {"shadow-map", {"filter=pcf", "pcf-radius=3"}},
        {"shadow-map", {"filter=pcss"}},
        {"shadow-map", {"filter=vsm"}},
        {"shadow-map", {"filter=hard", "light-samples=4"}},
        {"shadow-map-exact", {}},
        {"shadow-map-alias-free", {}},
    };
    return all;
}

struct Compared {
    int scenes = 0; ///< drawn by the short road
    std::size_t pixels = 0, oneApart = 0, farApart = 0, shadowed = 0;
};

class FinishedPixels : public testing::GlTest {
protected:
    static View viewOf(const scene::Scene& scene, ivec2 size) {
        View view;
        view.camera = scene.camera;
        view.size = size;
        return view;
    }
    static int distance(image::Color8 a, image::Color8 b) {
        return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    }

    void compare(const scene::Snapshot& snapshot, const Variant& variant, const View& view, Compared& compared) {
        picture::Session session(snapshot);
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot(variant.technique));
        std::vector<std::string> full;
        for (const std::string& setting : variant.settings)
            full.push_back(variant.technique + "." + setting);
        lab::applySettings(slots, full);

        session.render(slots[0], view);
        const image::Image byRadiance = encoder_->encode(slots[0].target.color, snapshot->exposure);
        gl::FinishedPicture finished;
        FrameRequest request;
        request.finished = &finished;
        const picture::RenderedFrame rendered = session.render(slots[0], view, request);
        if (!rendered.result.isFinished) return;
        ++compared.scenes;
        const image::Image atOnce = picture::PictureEncoder::read(finished.color);
        picture::Slot unshadowed = picture::Session::makeSlot("unshadowed");
        session.render(unshadowed, view);
        const image::Image lit = encoder_->encode(unshadowed.target.color, snapshot->exposure);

        const auto [corner, size] = drawnRegion(view);
        for (int y = corner.y; y < corner.y + size.y; ++y)
            for (int x = corner.x; x < corner.x + size.x; ++x) {
                const int apart = distance(byRadiance.at(x, y), atOnce.at(x, y));
                ++compared.pixels;
                compared.oneApart += apart == 1;
                compared.farApart += apart > kMostLevels;
                compared.shadowed += distance(lit.at(x, y), atOnce.at(x, y)) > kMostLevels;
            }
        EXPECT_EQ(compared.farApart, 0u) << variant.technique << " in " << snapshot->name;
    }

    void TearDown() override {
        encoder_.reset(); // before it is counted what is left
        GlTest::TearDown();
    }

    std::optional<picture::PictureEncoder> encoder_{std::in_place};
};

TEST_F(FinishedPixels, AreThoseOfRadianceInEveryBuiltInScene) {
    const scene::LoadOptions options = loadOptions();
    for (const Variant& variant : variants()) {
        Compared compared;
        for (const std::string& name : scene::builtInScenes(options.assetsRoot)) {
            const scene::Snapshot snapshot = scene::loadScene(name, options);
            compare(snapshot, variant, viewOf(*snapshot, {192, 120}), compared);
        }
        // Ten of the thirteen scenes have one light, one of these a leaf with holes.
        EXPECT_GE(compared.scenes, 9) << variant.technique;
        EXPECT_GE(compared.pixels, 9u * 192 * 120);
        if (variant.technique != "unshadowed") EXPECT_GE(compared.shadowed, 10'000u) << variant.technique;
        EXPECT_LT(static_cast<double>(compared.oneApart), kMostOneApart * static_cast<double>(compared.pixels)) << variant.technique;
    }
}

TEST_F(FinishedPixels, AreThoseOfRadianceInRandomScenes) {
    for (const Variant& variant : variants()) {
        Compared compared;
        for (unsigned number = 0; number < 20; ++number) {
            scene::Scene scene = testing::randomScene(number);
            scene.lights.resize(1);
            for (scene::Object& object : scene.objects)
                if (object.emitterOfLight > 0) object.emitterOfLight = -1;
            compare(testing::snapshot(scene), variant, viewOf(scene, {96, 64}), compared);
        }
        EXPECT_GE(compared.scenes, 15) << variant.technique;
    }
}

TEST_F(FinishedPixels, OfAPartAreThoseOfTheWhole) {
    const scene::Snapshot snapshot = scene::loadScene("still-life", loadOptions());
    View view = viewOf(*snapshot, {320, 200});
    view.region = {{101, 20}, {150, 163}};
    Compared compared;
    for (const Variant& variant : variants())
        compare(snapshot, variant, view, compared);
    EXPECT_EQ(compared.scenes, static_cast<int>(variants().size()));
}

TEST_F(FinishedPixels, AreNotDrawnWhereMoreIsWanted) {
    picture::Session session(scene::loadScene("still-life", loadOptions()));
    picture::Slot slot = picture::Session::makeSlot("shadow-volume");
    const View view = viewOf(*session.snapshot(), {96, 64});
    gl::FinishedPicture finished;
    FrameRequest plain, stage, step;
    plain.finished = stage.finished = step.finished = &finished;
    stage.stages = {{"stencil", 0}};
    step.stopAfter = StageKey{"volumes", 0};
    EXPECT_TRUE(session.render(slot, view, plain).result.isFinished);
    EXPECT_FALSE(session.render(slot, view, stage).result.isFinished);
    EXPECT_FALSE(session.render(slot, view, step).result.isFinished);
    session.setScene(scene::loadScene("three-lights", loadOptions()));
    EXPECT_FALSE(session.render(slot, view, plain).result.isFinished);
}

} // namespace
} // namespace shadowlab
