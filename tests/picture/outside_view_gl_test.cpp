// The second camera's picture: of every technique, with the lines where they belong, and the first picture untouched.
// SPDX-License-Identifier: MIT
#include "app/picture/outside/outside_view.h"

#include "app/picture/derived_stages.h"
#include "app/picture/outside/outside_shapes.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/picture/outside_fixture.h"

namespace shadowlab::picture {
namespace {

/// Draws one black pass and says what it was asked.
class Counting final : public Technique {
public:
    params::ParamList params() override { return {params::boolean("knob", knob, "Turns nothing.")}; }
    Progress prepare(const scene::Snapshot&, Deadline) override { return {1.0, isReady}; }
    Progress render(Frame& frame) override {
        static constexpr PassInfo pass{"nothing", "Nothing", "", "", false};
        frame.pass(pass, [] { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); });
        return {};
    }
    std::vector<SceneShape> shapes(const scene::Snapshot&, const View&, int) override {
        ++asked;
        return shown;
    }
    bool knob = false, isReady = true;
    int asked = 0;
    std::vector<SceneShape> shown;
};

Slot countingSlot(Counting*& technique) {
    static const TechniqueInfo info = [] {
        TechniqueInfo described;
        described.id = "counting";
        return described;
    }();
    auto made = std::make_unique<Counting>();
    technique = made.get();
    Slot slot{&info, std::move(made), {}, {}};
    slot.params = slot.technique->params();
    return slot;
}

TEST_F(OutsideViewTest, EveryTechniqueHasItAndShowsEyeAndLight) {
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production)) {
        const std::string id(technique.info->id);
        const std::vector<StageInfo> stages = stagesOf(*technique.info);
        ASSERT_EQ(std::ranges::count(stages, "outside", &StageInfo::id), 1) << id;
        const image::Image image = picture(id);
        EXPECT_GE(pixelsOf(image, look::kEye), 300) << id;
        EXPECT_GE(pixelsOf(image, look::kChosenLight), 20) << id;
        EXPECT_FALSE(shows("other lights")) << id;
        EXPECT_TRUE(key.empty()) << id << ": " << (key.empty() ? "" : key[0].label) << " has no label";
        // A star reaches eight pixels from its place, and the label stands at any of its points.
        EXPECT_LE(glm::length(labelled("light point").place - pixelOf(session->snapshot()->light(0).positionWorld)), 12) << id;
        EXPECT_LE(glm::length(labelled("eye").place - pixelOf(eye.camera.positionWorld)), 0.5) << id;
    }
}

TEST_F(OutsideViewTest, ATechniquesOwnShapesAreShown) {
    EXPECT_EQ(pixelsOf(picture("unshadowed"), look::kLightFrustum), 0);
    EXPECT_GE(pixelsOf(picture("shadow-map"), look::kLightFrustum), 200);
    EXPECT_TRUE(shows("view of the shadow map"));
    EXPECT_TRUE(shows("near plane of the map"));
    const image::Image rays = picture("ray-traced");
    EXPECT_GE(pixelsOf(rays, look::kEyeRay), 200);
    EXPECT_GE(pixelsOf(rays, look::kEqualDepth), 200);
    EXPECT_GE(pixelsOf(rays, look::kOccluded), 20);
    for (const char* words : {"eye rays", "shadow rays: lit", "shadow rays: blocked"})
        EXPECT_TRUE(shows(words)) << words;
}

TEST_F(OutsideViewTest, TheEyesViewLiesWhereItsCornersAre) {
    const image::Image image = picture("unshadowed");
    // Along the two upper edges of the pyramid, which lie over everything; from the eye three quarters of the way.
    const auto corners = scene::viewCorners(eye.camera, 1.5, shownDepth(*session->snapshot(), eye));
    int looked = 0;
    for (const dvec3& corner : {corners[0], corners[1]})
        for (int i = 4; i <= 30; ++i) {
            const ivec2 pixel(pixelOf(glm::mix(eye.camera.positionWorld, corner, i / 40.0)));
            if (!image.contains(pixel.x - 1, pixel.y - 1) || !image.contains(pixel.x + 1, pixel.y + 1)) continue;
            ++looked;
            int colored = 0; // the border is smoothed: of these nine a line two pixels wide covers three whole
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    colored += isColor(image.at(pixel.x + x, pixel.y + y), look::kEye);
            EXPECT_GE(colored, 2) << i;
        }
    EXPECT_GE(looked, 30);
}

TEST_F(OutsideViewTest, WithoutShapesThePainterDrawsNothing) {
    const gl::Target target(kSize, "painted");
    const auto painted = [&](std::span<const SceneShape> shapes) {
        gl::setBaselineState();
        target.framebuffer.bind();
        glClearColor(0.25f, 0.5f, 0.75f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        std::vector<const SceneShape*> all;
        for (const SceneShape& shape : shapes)
            all.push_back(&shape);
        ShapePainter().draw(all, outside.camera, kSize);
        int changed = 0;
        for (const vec4& texel : gl::readTexels(target.color))
            changed += texel != vec4(0.25f, 0.5f, 0.75f, 1);
        return changed;
    };
    EXPECT_EQ(painted({}), 0);
    SceneShape line{"line", look::kEye, SceneShape::Kind::lines, {}};
    SceneShape face{"face", look::kEye, SceneShape::Kind::faces, {}};
    const SceneShape none[] = {line, face};
    EXPECT_EQ(painted(none), 0);
    const dvec3 towards = outside.camera.targetWorld - outside.camera.positionWorld;
    const dvec3 behind = outside.camera.positionWorld - towards;
    line.pointsWorld = {behind, behind + dvec3(1, 0, 0)};
    face.pointsWorld = {behind, behind + dvec3(1, 0, 0), behind + dvec3(0, 1, 0)};
    const SceneShape hidden[] = {line, face};
    EXPECT_EQ(painted(hidden), 0) << "drawn though behind the camera";
    for (SceneShape* shape : {&line, &face})
        for (dvec3& point : shape->pointsWorld)
            point += 2.0 * towards;
    const SceneShape seen[] = {line, face};
    EXPECT_GE(painted(seen), 150);
}

TEST_F(OutsideViewTest, WhatTheSceneHidesIsFaint) {
    Counting* technique = nullptr;
    Slot slot = countingSlot(technique);
    const dvec3 middle = outside.camera.targetWorld;
    const scene::Camera& camera = outside.camera;
    const dvec3 right = glm::normalize(glm::cross(middle - camera.positionWorld, camera.upWorld));
    technique->shown = {{"", look::kMultipleEdge, SceneShape::Kind::lines, {middle - right, middle + right}}}; // without a label
    scene::Scene empty = *session->snapshot();
    empty.objects.clear();
    const auto visible = [&](scene::Scene scene) {
        scene.revisions.geometry = scene::newRevision();
        session->setScene(testing::snapshot(scene));
        OutsideView view;
        return pixelsOf(picture(view, slot), look::kMultipleEdge);
    };
    EXPECT_GE(visible(empty), 60);
    scene::Scene walled = empty; // a ball around the line
    testing::addObject(walled, scene::makeSphere(1.5, 32), testing::translation(middle));
    EXPECT_EQ(visible(walled), 0);
}

TEST_F(OutsideViewTest, ShapesAreMadeOnceWhileNothingChanges) {
    Counting* technique = nullptr;
    Slot slot = countingSlot(technique);
    OutsideView view;
    picture(view, slot);
    outside.camera.positionWorld += dvec3(0.1, 0.2, 0.3);
    picture(view, slot);
    EXPECT_EQ(technique->asked, 1);
    technique->knob = true;
    picture(view, slot);
    EXPECT_EQ(technique->asked, 2);
    eye.camera.positionWorld.x += 0.5;
    picture(view, slot);
    EXPECT_EQ(technique->asked, 3);
    session->setScene(testing::snapshot(testing::simpleScene())); // another snapshot
    picture(view, slot);
    EXPECT_EQ(technique->asked, 4);
    picture(view, slot, kNoLight);
    EXPECT_EQ(technique->asked, 4); // without a light there is nothing to ask for
    EXPECT_TRUE(shows("eye"));
    EXPECT_TRUE(shows("other lights")); // a light that nobody looks at
    technique->isReady = false;
    EXPECT_FALSE(view.render(*session, slot, eye, outside, 0, {}, Deadline::min()));
}

// Trees of rays take more than one slice of time. A view that was shown after the first slice kept half a mirror for good.
TEST_F(OutsideViewTest, WhatIsNotReadyInTimeIsGoneOnWith) {
    scene::Scene glass = *session->snapshot();
    for (scene::Material& material : glass.materials) material.reflectivity = 0.5;
    use(glass);
    Slot slot = Session::makeSlot("ray-traced"), atOnceSlot = Session::makeSlot("ray-traced");
    OutsideView view, atOnce;
    int slices = 0, unfinished = 0;
    constexpr std::chrono::milliseconds kSlice(20); // a small part of what a picture of 720x480 takes
    do {
        view.render(*session, slot, eye, outside, 0, look, std::chrono::steady_clock::now() + kSlice);
        unfinished += !view.isWhole();
    } while (!view.isWhole() && ++slices < 2000);
    EXPECT_GE(unfinished, 2);
    ASSERT_TRUE(view.isWhole());
    EXPECT_EQ(view.drawnShare(), 1);
    EXPECT_EQ(differing(picture(view, slot), picture(atOnce, atOnceSlot)), 0);
}

TEST_F(OutsideViewTest, TheSlotsOwnPictureStays) {
    Slot slot = Session::makeSlot("shadow-map");
    session->render(slot, eye);
    const auto before = gl::readTexels(slot.target.color);
    outside.size = {200, 100};
    OutsideView view;
    EXPECT_EQ(picture(view, slot).width, 200);
    EXPECT_EQ(slot.target.size(), kSize);
    EXPECT_EQ(gl::readTexels(slot.target.color), before);
}

TEST_F(OutsideViewTest, ARegionIsTheSamePictureThere) {
    const image::Image whole = picture("shadow-map");
    outside.region = {{300, 160}, {150, 120}};
    const image::Image part = picture("shadow-map");
    for (int y = 160; y < 280; ++y)
        for (int x = 300; x < 450; ++x)
            ASSERT_EQ(part.at(x, y), whole.at(x, y)) << x << ' ' << y;
}

TEST_F(OutsideViewTest, AnyScaleAndAnyPlaceGiveTheSamePicture) {
    const scene::Scene scene = *session->snapshot();
    const image::Image here = picture("shadow-map");
    const int most =
        kSize.x * kSize.y / 500; // lines, and edges of the map's shadows, may lie within rounding of a pixel
    for (const double scale : {1e-3, 1e4}) {
        scene::Scene scaled = scene;
        scaled.camera.positionWorld *= scale;
        scaled.camera.targetWorld *= scale;
        scaled.camera.near *= scale;
        for (scene::Light& light : scaled.lights) {
            light.positionWorld *= scale;
            light.intensity *= scale * scale;
        }
        for (scene::Object& object : scaled.objects)
            object.worldFromObject = dmat4(dmat3(scale)) * object.worldFromObject;
        use(scaled);
        EXPECT_LE(differing(picture("shadow-map"), here), most) << scale;
    }
    use(testing::moved(scene, {1e6, 0, -1e6}));
    EXPECT_LE(differing(picture("shadow-map"), here), most);
}

TEST_F(OutsideViewTest, OfAPickedPixelTheRaysAreShownInPlaceOfAFewOfAll) {
    Slot slot = Session::makeSlot("ray-traced");
    OutsideView view;
    const image::Image ofAll = picture(view, slot);
    const auto named = [&](const char* beginning) { return shows(beginning); };
    EXPECT_TRUE(named("eye rays"));
    eye.picked = kSize / 2;
    const image::Image ofOne = picture(view, slot);
    EXPECT_FALSE(ofOne == ofAll);
    EXPECT_FALSE(named("eye rays"));
    EXPECT_TRUE(named("the pixel's ray"));
    EXPECT_FALSE(named("cells"));
    eye.picked = kSize / 3;
    EXPECT_FALSE(picture(view, slot) == ofOne) << "another pixel has other rays";
    params::setFromText(params::find(slot.params, "structure", "ray-traced"), "grid", "ray-traced");
    picture(view, slot);
    EXPECT_TRUE(named("cells that the eye ray passes: "));
    eye.picked.reset();
    params::setFromText(params::find(slot.params, "structure", "ray-traced"), "bvh", "ray-traced");
    EXPECT_EQ(picture(view, slot), ofAll);
}

TEST_F(OutsideViewTest, EveryTechniqueShowsAPickedPixel) {
    int shown = 0;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production)) {
        Slot slot = Session::makeSlot(technique.info->id);
        OutsideView view;
        eye.picked.reset();
        const image::Image before = picture(view, slot);
        eye.picked = kSize / 2;
        EXPECT_FALSE(picture(view, slot) == before) << technique.info->id;
        ++shown;
    }
    EXPECT_GE(shown, 6);
}

} // namespace
} // namespace shadowlab::picture
