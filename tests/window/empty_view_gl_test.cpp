// A camera that has come to rest where it sees no surface is told so, once; and the message goes when something is seen again.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

using testing::Lab;

class EmptyViewTest : public testing::ScreenFixture {
protected:
    /// How many messages say that nothing is in view.
    static std::ptrdiff_t said(const Lab& lab) {
        return std::ranges::count_if(lab.screen.messages(), [](const window::Message& message) {
            return message.text.starts_with("no surface is in view: ");
        });
    }
};

TEST_F(EmptyViewTest, IsToldOnceAndTakenBack) {
    Lab lab(scene("sphere-on-plane"), {320, 200});
    settle(lab.screen);
    EXPECT_EQ(said(lab), 0);
    const scene::Camera before = lab.ui.bench.document().camera;
    scene::Camera away = before; // up into the sky
    away.targetWorld = away.positionWorld + dvec3(0.1, 5, 0);
    lab.ui.bench.setCamera(away);
    settle(lab.screen);
    EXPECT_EQ(said(lab), 1);
    lab.screen.frame(1.0 / 30);
    EXPECT_EQ(said(lab), 1) << "not once per frame";
    lab.ui.bench.setCamera(before);
    settle(lab.screen);
    EXPECT_EQ(said(lab), 0);
}

} // namespace
} // namespace shadowlab
