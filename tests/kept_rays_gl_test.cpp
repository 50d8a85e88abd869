// What is kept of eye rays while only lights change (ray tracing: all of them; where volumes and maps ask rays: those of the blocks of
// pixels that were asked for): a frame is always that of a technique which has kept nothing.
// SPDX-License-Identifier: MIT
#include <functional>

#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using KeptRaysTest = testing::GlTest;

struct Drawn {
    image::Image picture;                ///< as it is looked at
    std::vector<std::uint8_t> visibility; ///< of the first light
};

Drawn draw(picture::Session& session, picture::Slot& slot, const View& view) {
    gl::FinishedPicture finished;
    FrameRequest request;
    request.finished = &finished;
    const bool isFinished = session.render(slot, view, request).result.isFinished;
    Drawn drawn{isFinished ? picture::PictureEncoder::read(finished.color) : picture::PictureEncoder().encode(slot.target.color, 1), {}};
    FrameRequest withAnswers;
    withAnswers.stages = {{"visibility", 0}};
    const picture::RenderedFrame frame = session.render(slot, view, withAnswers);
    drawn.visibility = picture::readVisibility(picture::findStage(frame, {"visibility", 0})).greyAlpha;
    return drawn;
}

/// A scene from frame to frame.
struct Shown {
    scene::Scene scene = testing::everyKindOfLight();
    View view;
    std::vector<std::string> settings;
};
struct Change {
    const char* what;
    std::function<void(Shown&)> make;
    bool isSeen = true; ///< in the first light's shadows, as the camera sees them
};

void moveLight(Shown& shown, const dvec3& byWorld) {
    shown.scene.lights[0].positionWorld += byWorld;
    shown.scene.revisions.lights = scene::newRevision();
}

std::vector<Change> changes(const std::string& technique) {
    std::vector<Change> list{
        {"the light moves", [](Shown& s) { moveLight(s, {0.2, 0, 0}); }},
        {"and on", [](Shown& s) { moveLight(s, {0.2, 0.1, 0}); }},
        {"the camera moves", [](Shown& s) { s.view.camera.positionWorld.x += 0.4; }},
        {"the light after it", [](Shown& s) { moveLight(s, {0, 0, 0.3}); }},
        {"an object moves",
         [](Shown& s) {
             s.scene.objects[1].worldFromObject = testing::translation({0.3, 0, 0.2}) * s.scene.objects[1].worldFromObject;
             s.scene.revisions.transforms = scene::newRevision();
         }},
        {"the light after it", [](Shown& s) { moveLight(s, {-0.3, 0, 0}); }},
        {"holes are cut",
         [](Shown& s) {
             testing::perforate(s.scene, 2, {"##..", "##..", "..##", "..##"});
             s.scene.revisions.materials = scene::newRevision();
         }},
        {"the light after it", [](Shown& s) { moveLight(s, {0, 0.2, 0.2}); }},
        {"an object goes",
         [](Shown& s) {
             s.scene.objects.erase(s.scene.objects.begin() + 1);
             s.scene.revisions.geometry = scene::newRevision();
         }},
        {"one no longer casts",
         [](Shown& s) {
             s.scene.objects[1].castsShadow = false;
             s.scene.revisions.transforms = scene::newRevision();
         }},
        {"another size", [](Shown& s) { s.view.size = {133, 170}; }},
        {"a light goes",
         [](Shown& s) {
             s.scene.lights.erase(s.scene.lights.begin());
             s.scene.revisions.lights = scene::newRevision();
         }},
        {"nothing", [](Shown&) {}, false},
    };
    if (technique == "ray-traced")
        for (const char* setting : {"receivers=id-buffer", "exclude-source=false", "exclude-source=true", "structure=grid"})
            list.push_back({setting, [=](Shown& s) { s.settings.push_back("ray-traced." + std::string(setting)); },
                            std::string(setting).starts_with("exclude")});
    return list;
}

TEST_F(KeptRaysTest, AFrameIsThatOfATechniqueWhichHasKeptNothing) {
    for (const std::string technique : {"ray-traced", "shadow-volume", "shadow-map-exact"}) {
        Shown shown;
        shown.view.camera = shown.scene.camera;
        shown.view.size = {160, 120};
        picture::Session session(testing::snapshot(shown.scene));
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot(technique));
        if (technique == "shadow-volume") shown.settings.push_back("shadow-volume.repair=true");
        if (technique == "shadow-map-exact") shown.settings.push_back("shadow-map-exact.resolution=256");
        int compared = 0;
        std::vector<std::uint8_t> before;
        for (const Change& change : changes(technique)) {
            change.make(shown);
            lab::applySettings(slots, shown.settings);
            const scene::Snapshot snapshot = testing::snapshot(shown.scene);
            session.setScene(snapshot);
            const Drawn drawn = draw(session, slots[0], shown.view);
            picture::Session other(snapshot);
            std::vector<picture::Slot> fresh;
            fresh.push_back(picture::Session::makeSlot(technique));
            lab::applySettings(fresh, shown.settings);
            const Drawn wanted = draw(other, fresh[0], shown.view);
            EXPECT_EQ(drawn.picture, wanted.picture) << technique << ": " << change.what;
            EXPECT_EQ(drawn.visibility, wanted.visibility) << technique << ": " << change.what;
            if (change.isSeen) EXPECT_NE(drawn.visibility, before) << technique << ": " << change.what << " is not seen at all";
            before = drawn.visibility;
            ++compared;
        }
        EXPECT_GE(compared, 13);
    }
}

} // namespace
} // namespace shadowlab
