// Pictures with mirrors and glass: what trees change, and what they leave as it was.
// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "app/context/assets.h"
#include "app/picture/picture.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using TreesTest = testing::GlTest;
using Settings = std::vector<std::pair<std::string, std::string>>;

constexpr ivec2 kSize{240, 135};

struct Drawn {
    image::Image picture;
    std::vector<std::uint8_t> visibility;
};

Drawn draw(const scene::Snapshot& snapshot, const char* technique, const Settings& settings) {
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot(technique);
    for (const auto& [id, value] : settings)
        params::setFromText(params::find(slot.params, id, technique), value, technique);
    View view;
    view.camera = snapshot->camera;
    view.size = kSize;
    FrameRequest request;
    request.stages = {{"visibility", 0}};
    const auto frame = session.render(slot, view, request);
    return {picture::PictureEncoder().encode(slot.target.color, 1.0f),
            picture::readVisibility(picture::findStage(frame, {"visibility", 0})).greyAlpha};
}

scene::Snapshot builtIn() {
    return scene::loadScene("mirror-and-glass", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

/// The same scene, nothing mirrored and nothing transparent.
scene::Snapshot withoutOptics(const scene::Snapshot& snapshot) {
    auto scene = std::make_shared<scene::Scene>(*snapshot);
    for (scene::Material& material : scene->materials)
        material.reflectivity = material.transparency = 0;
    scene->revisions.materials = scene::newRevision();
    return scene;
}

int differentPixels(const image::Image& a, const image::Image& b) {
    int different = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        different += !std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                                 a.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 4,
                                 b.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    return different;
}

TEST_F(TreesTest, WithoutDepthMirrorsAndGlassAreAsInOtherTechniques) {
    const scene::Snapshot shiny = builtIn(), plain = withoutOptics(shiny);
    const Drawn traced = draw(shiny, "ray-traced", {{"depth", "0"}});
    EXPECT_EQ(traced.picture, draw(plain, "ray-traced", {}).picture);
    const Drawn drawn = draw(shiny, "shadow-volume-zfail", {});
    EXPECT_EQ(drawn.picture, draw(plain, "shadow-volume-zfail", {}).picture) << "drawn ones know nothing of either";

    // The two differ where an edge of a thing or of a shadow passes a pixel's centre, nowhere else: both have the same
    // neighbours there. Sums are rounded to half floats here and there, hence 1/255.
    int compared = 0, different = 0, largest = 0;
    const auto at = [](const image::Image& image, int x, int y, int c) {
        return static_cast<int>(image.rgba[static_cast<std::size_t>(4 * (y * kSize.x + x) + c)]);
    };
    for (int y = 1; y + 1 < kSize.y; ++y)
        for (int x = 1; x + 1 < kSize.x; ++x) {
            int contrast = 0, difference = 0;
            for (int c = 0; c < 3; ++c) {
                for (const ivec2 step : {ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1)})
                    contrast = std::max(contrast, std::abs(at(traced.picture, x, y, c) -
                                                           at(traced.picture, x + step.x, y + step.y, c)));
                difference = std::max(difference, std::abs(at(traced.picture, x, y, c) - at(drawn.picture, x, y, c)));
            }
            if (contrast > 20) continue; // an edge
            ++compared;
            different += difference > 1;
            largest = std::max(largest, difference);
        }
    std::cout << compared << " pixels away from edges compared, largest difference " << largest << "/255\n";
    EXPECT_GT(compared, 25'000);
    EXPECT_EQ(different, 0);
}

TEST_F(TreesTest, ChangeOnlyPixelsThatShowMirrorOrGlassAndNoVisibility) {
    const scene::Snapshot shiny = builtIn();
    const Drawn with = draw(shiny, "ray-traced", {}), without = draw(shiny, "ray-traced", {{"depth", "0"}});
    EXPECT_EQ(with.visibility, without.visibility);
    const trace::ExactVisibility judge(shiny);
    int kept = 0, changed = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const auto hit = judge.eyeHit(shiny->camera, dvec2(x, y) + 0.5, kSize);
            const auto i = static_cast<std::ptrdiff_t>(4 * (y * kSize.x + x));
            const bool same = std::equal(with.picture.rgba.begin() + i, with.picture.rgba.begin() + i + 4,
                                         without.picture.rgba.begin() + i);
            const auto shows = [&] {
                const scene::Material& material = shiny->materials[shiny->objects[hit->object].partMaterials[0]];
                return material.reflectivity > 0 || material.transparency > 0;
            };
            if (hit && shows()) {
                changed += !same;
                continue;
            }
            ++kept;
            EXPECT_TRUE(same) << x << ", " << y;
        }
    EXPECT_GT(kept, 15'000);
    EXPECT_GT(changed, 5000);
}

TEST_F(TreesTest, SameBytesForAnyNumberOfThreads) {
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    std::vector<image::Image> pictures;
    for (const char* threads : {"1", "2", "4"}) {
        ::setenv("SHADOWLAB_THREADS", threads, 1);
        pictures.push_back(draw(builtIn(), "ray-traced", {}).picture);
    }
    before ? ::setenv("SHADOWLAB_THREADS", kept.c_str(), 1) : ::unsetenv("SHADOWLAB_THREADS");
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
}

TEST_F(TreesTest, EveryKnobOfTheTreeIsSeen) {
    const scene::Snapshot shiny = builtIn();
    const image::Image right = draw(shiny, "ray-traced", {}).picture;
    for (const auto& [id, value] :
         Settings{{"depth", "2"}, {"cutoff", "0.2"}, {"fresnel", "constant"}, {"fresnel", "schlick"}, {"c2", "0.2"}})
        EXPECT_GT(differentPixels(right, draw(shiny, "ray-traced", {{id, value}}).picture), 200) << id << "=" << value;
}

// Away from mirrors, too, and there as far as the eye is.
TEST_F(TreesTest, AttenuationDarkensWhatIsFar) {
    scene::Scene scene = testing::floorScene();
    scene.ambient = vec3(1);
    scene.materials[0].diffuse = vec3(0.5f);
    scene.camera.positionWorld = {0, 2, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, 1};
    const auto snapshot = testing::snapshot(scene);
    picture::Session session(snapshot);
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    params::setFromText(params::find(slot.params, "c1", "ray-traced"), "0.5", "ray-traced");
    View view;
    view.camera = scene.camera;
    view.size = {3, 3}; // the middle one looks straight down
    session.render(slot, view, {});
    const image::Image picture = picture::PictureEncoder().encode(slot.target.color, 1.0f);
    const double linear = 0.5 / (1 + 0.5 * 2); // 0.25, which sRGB encodes as 137
    EXPECT_NEAR(picture.rgba[4 * 4], 255 * (1.055 * std::pow(linear, 1 / 2.4) - 0.055), 1);
}

TEST_F(TreesTest, ProbeTellsTheWholeTree) {
    const scene::Snapshot shiny = builtIn();
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    View view;
    view.camera = shiny->camera;
    view.size = kSize;
    std::optional<Probe> glass;
    const trace::ExactVisibility judge(shiny);
    for (int x = 0; x < kSize.x && !glass; ++x) {
        const auto hit = judge.eyeHit(view.camera, dvec2(x, 75) + 0.5, kSize);
        if (hit && shiny->objects[hit->object].name == "glass ball")
            glass = slot.technique->probe(shiny, view, {x + 10, 75}, 0);
    }
    ASSERT_TRUE(glass);
    int reflections = 0, refractions = 0, shadows = 0;
    for (std::size_t i = 0; i < glass->tree.size(); ++i) {
        const Probe::Node& node = glass->tree[i];
        EXPECT_LT(node.parent, static_cast<int>(i));
        EXPECT_EQ(node.parent < 0, i == 0);
        reflections += node.label.starts_with("reflection");
        refractions += node.label.starts_with("refraction");
        shadows += node.label.starts_with("shadow ray");
    }
    EXPECT_EQ(glass->tree[0].label, "eye ray");
    EXPECT_EQ(glass->tree[0].facts[0].value, "glass ball");
    EXPECT_GT(reflections, 2);
    EXPECT_GT(refractions, 2);
    EXPECT_GE(shadows, 3);
    const auto has = [&](const char* label) {
        return std::ranges::any_of(glass->tree[0].facts, [&](const Probe::Fact& f) { return f.label == label; });
    };
    for (const char* label : {"u", "V", "N", "R", "T", "I_R", "I_T", "I", "attenuation"})
        EXPECT_TRUE(has(label)) << label;
    // One line leads on from the end of another.
    int lines = 0;
    for (const Probe::Segment& segment : glass->geometry) {
        if (!segment.label.starts_with("reflection") && !segment.label.starts_with("refraction")) continue;
        ++lines;
        EXPECT_TRUE(std::ranges::any_of(glass->geometry, [&](const Probe::Segment& other) {
            return &other != &segment && glm::length(other.toWorld - segment.fromWorld) < 1e-9;
        }));
    }
    EXPECT_GT(lines, 4);
}

} // namespace
} // namespace shadowlab
