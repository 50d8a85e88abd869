// The strip of stages is drawn on the thread that hands wait for: it ends at its deadline and goes on in the next frame.
// SPDX-License-Identifier: MIT
#include "app/lab/stage_strip.h"

#include <algorithm>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab::lab {
namespace {

class StageStripTest : public testing::GlTest {
protected:
    static int pictures(const StageStrip& strip) {
        return static_cast<int>(std::ranges::count_if(
            strip.thumbnails(), [](const Thumbnail& thumbnail) { return bool(thumbnail.picture.texture); }));
    }
    static bool isWaiting(const StageStrip& strip) { return std::ranges::any_of(strip.thumbnails(), &Thumbnail::isToCome); }

    /// Draws one strip with no time at all in each call and one with all the time of the world, and expects the same pictures.
    /// Returns the number of calls.
    static int expectSamePictures(picture::Session& session, const PaneRequest& request) {
        const picture::PictureEncoder encoder;
        const auto update = [&](StageStrip& strip, Deadline deadline) {
            return strip.update(session, encoder, request, {64, 48}, deadline);
        };
        StageStrip strip, patient;
        int updates = 0, partly = 0;
        double progress = 0;
        while (update(strip, Deadline()) && ++updates < 10'000) {
            partly += pictures(strip) > 0 && isWaiting(strip);
            progress = std::max(progress, isWaiting(strip) ? strip.progress() : 0);
            if (updates == 1) {
                EXPECT_GE(strip.thumbnails().size(), 4u) << "all are there by name";
                EXPECT_TRUE(isWaiting(strip)) << "nothing takes no time";
            }
        }
        EXPECT_GE(partly, 1) << "pictures appear before all of them are there";
        EXPECT_GT(progress, 0);
        EXPECT_LE(progress, 1);
        EXPECT_FALSE(isWaiting(strip));
        EXPECT_TRUE(update(patient, Deadline::max()));
        EXPECT_FALSE(update(patient, Deadline::max())) << "nothing is left to do";
        EXPECT_EQ(strip.thumbnails().size(), patient.thumbnails().size());
        int compared = 0;
        for (std::size_t i = 0; i < std::min(strip.thumbnails().size(), patient.thumbnails().size()); ++i) {
            EXPECT_EQ(strip.thumbnails()[i].stage.text(), patient.thumbnails()[i].stage.text());
            const PanePicture &one = strip.thumbnails()[i].picture, &other = patient.thumbnails()[i].picture;
            EXPECT_TRUE(one.texture && other.texture) << strip.thumbnails()[i].stage.text() << " is drawn, derived or not";
            if (!one.texture || !other.texture) continue;
            EXPECT_EQ(picture::PictureEncoder::read(one.texture), picture::PictureEncoder::read(other.texture));
            ++compared;
        }
        EXPECT_GE(compared, 6);
        return updates;
    }
    static PaneRequest requestOf(const std::string& technique, const picture::Session& session) {
        PaneRequest request;
        request.state.technique = technique;
        request.snapshot = session.snapshot();
        request.view.camera = session.snapshot()->camera;
        return request;
    }
};

TEST_F(StageStripTest, GoesOnWhereItsTimeEnded) {
    scene::Scene scene = testing::simpleScene();
    // A tree for the rays of so many triangles is not built in one call.
    testing::addObject(scene, scene::makeSphere(0.3, 256), testing::translation({0, 2, 0}));
    picture::Session session(testing::snapshot(scene));
    EXPECT_GE(expectSamePictures(session, requestOf("ray-traced", session)), 3);
}

// What gets better sample by sample, or is solved step by step, is as many slices.
TEST_F(StageStripTest, SlicesWhatConverges) {
    picture::Session session(
        scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}));
    PaneRequest samples = requestOf("ray-traced", session);
    samples.state.settings["ray-traced"]["samples"] = "4";
    EXPECT_GE(expectSamePictures(session, samples), 3);
    PaneRequest patches = requestOf("radiosity", session);
    patches.state.settings["radiosity"]["patches"] = "100";
    EXPECT_GE(expectSamePictures(session, patches), 3);
}

// One frame of all stages of a technique that needs no time to prepare would be one long frame.
TEST_F(StageStripTest, DrawsAFewStagesAtATime) {
    picture::Session session(testing::snapshot(testing::simpleScene()));
    EXPECT_GE(expectSamePictures(session, requestOf("shadow-map", session)), 3);
}

} // namespace
} // namespace shadowlab::lab
