// The strip of stages is drawn on the thread that hands wait for: it ends at its deadline and goes on in the next frame.
// SPDX-License-Identifier: MIT
#include "app/lab/stage_strip.h"

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab::lab {
namespace {

class StageStripTest : public testing::GlTest {};

TEST_F(StageStripTest, GoesOnWhereItsTimeEnded) {
    scene::Scene scene = testing::simpleScene();
    // A tree for the rays of so many triangles is not built in one call.
    testing::addObject(scene, scene::makeSphere(0.3, 256), testing::translation({0, 2, 0}));
    picture::Session session(testing::snapshot(scene));
    const picture::PictureEncoder encoder;
    PaneRequest request;
    request.state.technique = "ray-traced";
    request.snapshot = session.snapshot();
    request.view.camera = scene.camera;
    const auto update = [&](StageStrip& strip, Deadline deadline) {
        return strip.update(session, encoder, request, {64, 48}, deadline);
    };
    StageStrip strip, patient;
    int updates = 0;
    while (update(strip, Deadline()) && ++updates < 10'000) {
        if (updates > 1) continue;
        EXPECT_TRUE(strip.thumbnails().empty()) << "nothing is ready after no time";
    }
    EXPECT_GE(updates, 3);
    EXPECT_TRUE(update(patient, Deadline::max()));
    EXPECT_FALSE(update(patient, Deadline::max())) << "nothing is left to do";
    ASSERT_GE(strip.thumbnails().size(), 4u);
    ASSERT_EQ(strip.thumbnails().size(), patient.thumbnails().size());
    int compared = 0;
    for (std::size_t i = 0; i < strip.thumbnails().size(); ++i) {
        EXPECT_EQ(strip.thumbnails()[i].stage.text(), patient.thumbnails()[i].stage.text());
        const PanePicture &one = strip.thumbnails()[i].picture, &other = patient.thumbnails()[i].picture;
        ASSERT_EQ(bool(one.texture), bool(other.texture));
        if (!one.texture) continue;
        EXPECT_EQ(picture::PictureEncoder::read(one.texture), picture::PictureEncoder::read(other.texture));
        ++compared;
    }
    EXPECT_GE(compared, 3);
}

} // namespace
} // namespace shadowlab::lab
