// Lamps in the picture: whole icons, names beside each other, and one sign for each meaning.
// SPDX-License-Identifier: MIT
#include "app/window/gizmo.h"
#include "app/window/handle_places.h"
#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

using testing::Lab;
using window::PaneSigns;
using window::PlaceBox;

class LampNamesTest : public testing::ScreenFixture {};

TEST_F(LampNamesTest, NamesDoNotLieOverOneAnother) {
    int compared = 0;
    for (const char* name : {"three-lights", "room-with-lamps", "still-life"})
        for (const ivec2 size : {ivec2(1280, 720), ivec2(800, 600)})
            for (const bool presenter : {false, true}) {
                Lab lab(scene(name), size);
                if (presenter) togglePresenter(lab.ui);
                lab.screen.fit(size, 1);
                for (const picture::Layout layout : {picture::Layout::single, picture::Layout::split, picture::Layout::side}) {
                    chooseLayout(lab.ui, layout);
                    for (int frame = 0; frame < 2; ++frame) // the pictures; what is right in them is of no interest here
                        lab.screen.frame(0.03);
                    EXPECT_FALSE(lab.screen.paneSigns().front().names.empty()) << name;
                    for (const PaneSigns& signs : lab.screen.paneSigns())
                        for (std::size_t i = 0; i < signs.names.size(); ++i)
                            for (std::size_t k = 0; k < i; ++k, ++compared)
                                EXPECT_EQ(window::overlap(signs.names[i], signs.names[k]), 0)
                                    << name << " " << size.x << (presenter ? " presenter" : "");
                }
            }
    EXPECT_GE(compared, 50);
}

TEST_F(LampNamesTest, TheSplitLineCutsNoIcon) {
    int compared = 0;
    Lab lab(scene("three-lights"), {1000, 640});
    settle(lab.screen);
    const window::ShownPane whole = lab.screen.shownPanes().front();
    for (const auto& [name, place] : window::handlePlaces(lab.ui, whole, lab.screen.theme())) {
        const double share = (place.x - whole.pictureCorner.x) / whole.pictureSize.x;
        if (share < 0.1 || share > 0.9) continue;
        for (const double beside : {-0.003, 0.003}) {
            lab.ui.bench.change("", [&](lab::Document& d) { d.split = share + beside; });
            settle(lab.screen);
            for (const window::ShownPane& pane : lab.screen.shownPanes()) {
                const window::SeenPane seen = window::seenIn(pane, lab.ui.bench.document().camera);
                const ImVec2 icon = seen.iconPlace({static_cast<float>(place.x), static_cast<float>(place.y)}, lab.screen.theme());
                if (!pane.area.contains(icon)) continue;
                ++compared;
                const float least = window::kIconEm * lab.screen.theme().em - 1;
                EXPECT_GE(icon.x - static_cast<float>(pane.area.corner.x), least) << name;
                EXPECT_GE(static_cast<float>(pane.area.corner.x + pane.area.size.x) - icon.x, least) << name;
            }
        }
    }
    EXPECT_GE(compared, 2);
}

} // namespace
} // namespace shadowlab
