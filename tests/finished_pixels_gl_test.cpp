// The two roads to a picture (techniques/shading_passes.h; of ray tracing: techniques/ray_tracing/finished_picture.h) give the same
// one: radiance in floats, encoded at the end, and finished pixels drawn at once.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/colored.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/levels_apart.h"
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
    bool manyLights = technique != "shadow-map" && technique != "shadow-map-exact" && technique != "shadow-map-alias-free";
};

/// Every program that shades: each counting rule, each layout of maps, filters with and without depths drawn first.
const std::vector<Variant>& variants() {
    static const std::vector<Variant> all = {
        {"unshadowed", {}},
        {"shadow-volume-zpass", {}},
        {"shadow-volume-zpass", {"eye-correction=true", "repair=true"}},
        {"shadow-volume-zfail", {}},
        {"shadow-volume-zfail", {"counter=float"}},
        {"shadow-volume-zpass", {"volume-end=infinity"}},
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
        {"planar", {}},
        {"planar", {"stencil=false"}},
        {"planar", {"cull=false"}},
        {"ray-traced", {}},
        {"ray-traced", {"samples=4"}},
    };
    return all;
}

View viewOf(const scene::Scene& scene, ivec2 size) {
    View view;
    view.camera = scene.camera;
    view.size = size;
    return view;
}

/// Draws scenes with a variant on both roads, one scene after the other: what is kept of one must not show in the next.
class Compared {
public:
    int scenes = 0; ///< drawn by the short road
    std::size_t pixels = 0, oneApart = 0, farApart = 0, shadowed = 0;

    explicit Compared(const Variant& variant) {
        for (const std::string& technique : {variant.technique, std::string("unshadowed")})
            slots_.push_back(picture::Session::makeSlot(technique));
        std::vector<std::string> full;
        for (const std::string& setting : variant.settings)
            full.push_back("1:" + variant.technique + "." + setting);
        lab::applySettings(slots_, full);
    }

    void compare(const scene::Snapshot& snapshot, const View& view) {
        picture::Session session(snapshot);
        const std::vector<StageKey> passes = distinct(session.render(slots_[0], view).result.passes);
        const image::Image byRadiance = encoded(slots_[0], *snapshot);
        session.render(slots_[1], view);
        const image::Image lit = encoded(slots_[1], *snapshot);
        gl::FinishedPicture finished;
        FrameRequest request;
        request.finished = &finished;
        const Frame::Result drawn = session.render(slots_[0], view, request).result;
        if (!drawn.isFinished) return;
        ++scenes;
        // Whoever steps through the passes takes them from any frame that was drawn.
        EXPECT_EQ(distinct(drawn.passes), passes) << slots_[0].info->id << " in " << snapshot->name;
        const image::Image atOnce = picture::PictureEncoder::read(finished.color);
        const auto [corner, size] = drawnRegion(view);
        for (int y = corner.y; y < corner.y + size.y; ++y)
            for (int x = corner.x; x < corner.x + size.x; ++x) {
                const int apart = testing::levelsApart(byRadiance.at(x, y), atOnce.at(x, y));
                ++pixels;
                oneApart += apart == 1;
                farApart += apart > kMostLevels;
                shadowed += testing::levelsApart(lit.at(x, y), atOnce.at(x, y)) > kMostLevels;
            }
        EXPECT_EQ(farApart, 0u) << slots_[0].info->id << " in " << snapshot->name << ", the " << scenes << "th scene, "
                                << snapshot->lights.size() << " lights";
    }

    void compareAll(const std::vector<scene::Snapshot>& snapshots, ivec2 size) {
        for (const scene::Snapshot& snapshot : snapshots)
            compare(snapshot, viewOf(*snapshot, size));
    }

private:
    [[nodiscard]] image::Image encoded(const picture::Slot& slot, const scene::Scene& scene) const {
        return encoder_.encode(slot.target.color, scene.exposure);
    }

    /// Each once, in the order of their first run.
    static std::vector<StageKey> distinct(const std::vector<StageKey>& passes) {
        std::vector<StageKey> once;
        for (const StageKey& pass : passes)
            if (std::ranges::find(once, pass) == once.end()) once.push_back(pass);
        return once;
    }

    std::vector<picture::Slot> slots_; ///< the variant, and no shadows
    picture::PictureEncoder encoder_;
};

class FinishedPixels : public testing::GlTest {};

TEST_F(FinishedPixels, AreThoseOfRadianceInEveryBuiltInScene) {
    const scene::LoadOptions options = loadOptions();
    std::vector<scene::Snapshot> snapshots;
    for (const std::string& name : scene::builtInScenes(options.assetsRoot))
        snapshots.push_back(scene::loadScene(name, options));
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compareAll(snapshots, {192, 120});
        // Ten of the thirteen scenes have one light, one of these a leaf with holes.
        const int scenes = variant.manyLights ? 12 : 9;
        EXPECT_GE(compared.scenes, scenes) << variant.technique;
        EXPECT_GE(compared.pixels, static_cast<std::size_t>(scenes) * 192 * 120);
        if (variant.technique != "unshadowed") {
            EXPECT_GE(compared.shadowed, 10'000u) << variant.technique;
        }
        EXPECT_LT(static_cast<double>(compared.oneApart), kMostOneApart * static_cast<double>(compared.pixels)) << variant.technique;
    }
}

TEST_F(FinishedPixels, AreThoseOfRadianceInRandomScenes) {
    std::vector<scene::Snapshot> snapshots;
    for (unsigned number = 0; number < 20; ++number) {
        scene::Scene scene = testing::randomScene(number);
        scene.lights.resize(1);
        for (scene::Object& object : scene.objects)
            if (object.emitterOfLight > 0) object.emitterOfLight = -1;
        snapshots.push_back(testing::snapshot(scene));
    }
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compareAll(snapshots, {96, 64});
        EXPECT_GE(compared.scenes, 15) << variant.technique;
    }
}

/// A scene with further lights, a quarter of a metre beside those that it has.
scene::Snapshot withLights(scene::Scene scene, std::size_t count) {
    for (std::size_t i = 0; scene.lights.size() < count; ++i) {
        scene::Light light = scene.lights[i];
        light.name += " again";
        light.color /= static_cast<float>(count);
        light.positionWorld += dvec3(0.25, 0, -0.25);
        light.directionWorld = glm::normalize(light.directionWorld + dvec3(0.05, 0, -0.05));
        scene.lights.push_back(light);
    }
    scene.revisions.lights = scene::newRevision(); // what techniques keep of the scene as it was is not of this one
    return testing::snapshot(scene);
}

TEST_F(FinishedPixels, OfManyLightsAreThoseOfRadiance) {
    std::vector<scene::Snapshot> snapshots;
    for (unsigned number = 0; number < 20; ++number)
        snapshots.push_back(withLights(testing::randomScene(number), 2 + number % 4));
    for (const std::size_t lights : {9, 32}) // the bits of one more than eight, and of all, in channels
        snapshots.push_back(withLights(*scene::loadScene("sphere-on-plane", loadOptions()), lights));
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compareAll(snapshots, {96, 64});
        if (variant.manyLights) {
            EXPECT_GE(compared.scenes, 15) << variant.technique;
        }
    }
}

TEST_F(FinishedPixels, OfImagesAndColoursOfVerticesAreThoseOfRadiance) {
    const scene::Scene one = testing::coloredScene();
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compare(testing::snapshot(one), viewOf(one, {192, 120}));
        compared.compare(withLights(one, 3), viewOf(one, {192, 120}));
        EXPECT_EQ(compared.scenes, variant.manyLights ? 2 : 1) << variant.technique;
    }
}

// One colour in shadow is drawn over the lit picture, and nowhere on the background, on which a volume without an end is counted.
TEST_F(FinishedPixels, OfOneColourInShadowAreThoseOfRadiance) {
    std::vector<scene::Snapshot> snapshots;
    for (unsigned number = 0; number < 20; ++number) {
        scene::Scene scene = testing::randomScene(number);
        scene.lights.resize(1);
        scene.background = {0.2f, 0.6f, 0.9f};
        scene::Material material;
        material.diffuse = {0.7f, 0.6f, 0.5f};
        scene.materials.assign(scene.materials.size(), material);
        for (scene::Object& object : scene.objects) {
            object.emitterOfLight = -1;
            object.receivesShadow = true;
        }
        if (number % 4 == 0) scene.objects.back().receivesShadow = false; // two colours
        snapshots.push_back(testing::snapshot(scene));
    }
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compareAll(snapshots, {96, 64});
        EXPECT_GE(compared.scenes, 15) << variant.technique;
        if (variant.technique != "unshadowed") {
            EXPECT_GE(compared.shadowed, 1'000u) << variant.technique;
        }
    }
}

TEST_F(FinishedPixels, OfAPartAreThoseOfTheWhole) {
    const scene::Snapshot snapshot = scene::loadScene("still-life", loadOptions());
    View view = viewOf(*snapshot, {320, 200});
    view.region = {{101, 20}, {150, 163}};
    for (const Variant& variant : variants()) {
        Compared compared(variant);
        compared.compare(snapshot, view);
        EXPECT_EQ(compared.pixels, 150u * 163) << variant.technique;
    }
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
    session.setScene(withLights(*scene::loadScene("sphere-on-plane", loadOptions()), 33));
    EXPECT_FALSE(session.render(slot, view, plain).result.isFinished) << "more lights than a picture has bits";
}

} // namespace
} // namespace shadowlab
