// What is kept from frame to frame while nothing moves, the volumes that are drawn and the pixels decided by rays: never
// those of another frame.
// SPDX-License-Identifier: MIT
#include "app/lab/settings.h"
#include "app/picture/picture.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using KeptCountTest = testing::GlTest;

/// A frame's picture, and all that it has counted.
struct Drawn {
    image::Image picture;
    std::vector<std::pair<std::string, double>> counted;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};

Drawn draw(picture::Session& session, picture::Slot& slot, const View& view) {
    const picture::RenderedFrame frame = session.render(slot, view);
    Drawn drawn{picture::PictureEncoder().encode(slot.target.color, 1), {}};
    for (const Counter& counter : frame.result.counters)
        if (counter.id != "volumes-rebuilt") drawn.counted.emplace_back(counter.id, counter.built);
    return drawn;
}

View viewOf(const scene::Scene& scene) {
    View view;
    view.camera = scene.camera;
    view.size = {160, 120};
    return view;
}

std::vector<picture::Slot> slotsOf(const std::string& technique, const std::vector<std::string>& settings) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    lab::applySettings(slots, settings);
    return slots;
}

/// By a slot that has kept nothing.
Drawn fresh(const scene::Snapshot& snapshot, const std::string& technique, const std::vector<std::string>& settings,
            const View& view) {
    picture::Session session(snapshot);
    std::vector<picture::Slot> slots = slotsOf(technique, settings);
    return draw(session, slots[0], view);
}

const char* const kTechniques[] = {"shadow-volume", "shadow-volume-zpass", "shadow-volume-zfail"};

TEST_F(KeptCountTest, EveryParameterThatMattersCountsAnew) {
    const scene::Snapshot snapshot = testing::snapshot(testing::everyKindOfLight());
    const View view = viewOf(*snapshot);
    int compared = 0;
    for (const std::string technique : kTechniques) {
        picture::Session session(snapshot);
        std::vector<picture::Slot> slots = slotsOf(technique, {technique + ".repair=true"});
        std::vector<std::string> settings{technique + ".repair=true"};
        std::vector<std::string> changes{"extrude-on=cpu",       "volume-end=infinity",  "volume-end=distance",
                                         "extrusion=0.5",        "stencil-bits=1",       "wrap=false",
                                         "stencil-bits=8",       "counter=float",        "volume-end=receivers",
                                         "two-sided=false",      "construction=lecture", "cull=false",
                                         "construction=general", "repair=false",         "repair=true"};
        if (technique == "shadow-volume-zpass") changes.insert(changes.end(), {"eye-correction=true"});
        if (technique == "shadow-volume-zfail") changes.insert(changes.end(), {"caps=false", "far-plane=clip"});
        for (const std::string& change : changes) {
            settings.push_back(technique + "." + change);
            lab::applySettings(slots, settings);
            const Drawn changed = draw(session, slots[0], view), again = draw(session, slots[0], view);
            EXPECT_EQ(changed, fresh(snapshot, technique, settings, view)) << technique << " " << change;
            EXPECT_EQ(again, changed) << technique << " " << change;
            ++compared;
        }
    }
    EXPECT_GE(compared, 45);
}

TEST_F(KeptCountTest, EveryViewCountsAnew) {
    const scene::Snapshot snapshot = testing::snapshot(testing::simpleScene());
    for (const std::string technique : kTechniques) {
        const std::vector<std::string> settings{technique + ".repair=true"};
        picture::Session session(snapshot);
        std::vector<picture::Slot> slots = slotsOf(technique, settings);
        View view = viewOf(*snapshot);
        const auto compare = [&](const char* what) {
            EXPECT_EQ(draw(session, slots[0], view), fresh(snapshot, technique, settings, view)) << technique << what;
        };
        compare(": first");
        view.camera.positionWorld.x += 0.5;
        compare(": eye");
        view.camera.fovYDegrees = 30;
        compare(": field of view");
        view.size = {120, 160};
        compare(": size");
    }
}

/// The volumes that were chosen lie in memory that a scene between two frames gives to others, also where that is never drawn.
TEST_F(KeptCountTest, ASceneThatWasPreparedAndNotDrawnLeavesNothingBehind) {
    const scene::Snapshot first = testing::snapshot(testing::simpleScene());
    scene::Scene other = testing::simpleScene();
    other.objects.erase(other.objects.begin() + 1);
    for (const std::string technique : kTechniques) {
        picture::Session session(first);
        std::vector<picture::Slot> slots = slotsOf(technique, {technique + ".repair=true"});
        const View view = viewOf(*first);
        const Drawn before = draw(session, slots[0], view);
        slots[0].technique->prepare(testing::snapshot(other), Deadline::max());
        EXPECT_EQ(draw(session, slots[0], view), before) << technique;
    }
}

} // namespace
} // namespace shadowlab
