// The card about the picked pixel: it covers nothing that the picture is about, and stands only where its ring does.
// SPDX-License-Identifier: MIT
#include "app/window/panels/probe_card.h"

#include "app/context/assets.h"
#include "app/course/deck.h"
#include "app/window/picture_view.h"
#include "app/window/slide_state.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/probed/map_probe.h"
#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

using testing::Lab;
using window::FreePlaces;
using window::PaneSigns;
using window::PlaceBox;

class ProbeCardTest : public testing::ScreenFixture {
protected:
    /// The card and what is beside it in the active pane; null where there is none.
    static const PaneSigns* carded(const Lab& lab) {
        for (const PaneSigns& signs : lab.screen.paneSigns())
            if (signs.card) return &signs;
        return nullptr;
    }
    static void expectFree(const PaneSigns& signs, float em, const std::string& where) {
        EXPECT_EQ(signs.places.cost(signs.card->box, FreePlaces::kSign), 0) << where << " covers an icon, a name or a label";
        EXPECT_EQ(signs.places.cost(signs.card->box), 0) << where << " covers an object";
        EXPECT_GT(signs.card->box.distance(signs.card->ring), em) << where << " covers its ring";
    }
    static void showSlide(Lab& lab, const char* deck, const std::string& wanted) {
        lab.ui.slides.decks = course::builtInDecks(context::assetsRoot());
        lab.ui.slides.loading = {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
        window::openDeck(lab.ui, deck);
        for (int i = 0; i < 200 && lab.ui.slides.slide.name != wanted; ++i)
            window::stepSlides(lab.ui, 1);
        ASSERT_EQ(lab.ui.slides.slide.name, wanted);
    }
    static void pick(Lab& lab, const dvec2& place) {
        lab.ui.bench.pick(place);
        settle(lab.screen);
    }
};

struct SlideCase {
    const char* deck;
    const char* slide;
    bool fromOutside;
};

TEST_F(ProbeCardTest, OnSlidesItCoversNeitherObjectsNorLampsNorLabels) {
    constexpr SlideCase kCases[] = {{"shadows", "one-texel", false},
                                    {"shadows", "intersection", false},
                                    {"shadows", "volumes", false},
                                    {"shadows", "volumes", true},
                                    {"shadow-rendering-techniques", "in-shadow", false},
                                    {"shadow-rendering-techniques", "z-fail-right", false}};
    for (const bool presenter : {true, false})
        for (const SlideCase& one : kCases) {
            Lab lab(scene("sphere-on-plane"), {1280, 720});
            if (presenter) togglePresenter(lab.ui);
            lab.screen.fit({1280, 720}, 1);
            showSlide(lab, one.deck, one.slide);
            if (one.fromOutside) chooseStage(lab.ui, {"outside"});
            settle(lab.screen);
            const std::string where = std::string(one.deck) + " " + one.slide + (one.fromOutside ? " outside" : "");
            const PaneSigns* const signs = carded(lab);
            ASSERT_NE(signs, nullptr) << where;
            expectFree(*signs, lab.screen.theme().em, where);
        }
}

TEST_F(ProbeCardTest, ShrinksToItsVerdictWhereThereIsNoRoomForMore) {
    Lab lab(scene("still-life"), {1280, 720});
    chooseLayout(lab.ui, picture::Layout::single);
    pick(lab, {0.55, 0.8});
    ASSERT_NE(carded(lab), nullptr);
    const std::size_t before = carded(lab)->card->lines.size();
    chooseLayout(lab.ui, picture::Layout::grid);
    lab.screen.fit({480, 360}, 1);
    settle(lab.screen);
    ASSERT_NE(carded(lab), nullptr);
    EXPECT_LT(carded(lab)->card->lines.size(), before);
    for (const window::CardLine& line : carded(lab)->card->lines)
        EXPECT_EQ(line.size, lab.screen.theme().em) << "the verdict's own type: " << line.text;
}

// Seen by the second camera a point is in another place than by the eye.
TEST_F(ProbeCardTest, FromOutsideTheRingIsAtThePoint) {
    Lab lab(scene("still-life"), {1000, 640});
    chooseLayout(lab.ui, picture::Layout::single);
    pick(lab, {0.55, 0.8});
    ASSERT_NE(carded(lab), nullptr);
    const ImVec2 byEye = carded(lab)->card->ring;
    chooseStage(lab.ui, {"outside"});
    settle(lab.screen);
    ASSERT_NE(carded(lab), nullptr);
    const PaneSigns& signs = *carded(lab);
    const window::Area& area = signs.places.area();
    const scene::Camera outside =
        scene::widenedFor(lab.ui.bench.document().outsideCamera, static_cast<double>(area.size.x) / area.size.y);
    const dvec3 pointWorld = lab.ui.bench.pickedPixel().probe.geometry.front().toWorld;
    const auto pixel = lab::pixelOf(outside, area.size, pointWorld);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(signs.card->ring.x, area.corner.x + pixel->x, 1.5);
    EXPECT_NEAR(signs.card->ring.y, area.corner.y + pixel->y, 1.5);
    EXPECT_GT(std::hypot(signs.card->ring.x - byEye.x, signs.card->ring.y - byEye.y), 20);
}

// A lit point is the first surface that its light meets: the picture of depths holds its own distance there.
TEST_F(ProbeCardTest, InTheMapsPictureTheRingIsWhereThePointIsLookedUp) {
    for (const char* technique : {"shadow-map", "shadow-map-exact"})
        for (const char* name : {"still-life", "three-lights", "candle"}) {
            Lab lab(scene(name), {1000, 640});
            chooseLayout(lab.ui, picture::Layout::single);
            chooseTechnique(lab.ui, technique);
            chooseStage(lab.ui, {"light-depth"});
            settle(lab.screen);
            int compared = 0;
            for (const dvec2 place : {dvec2(0.2, 0.85), dvec2(0.8, 0.9), dvec2(0.5, 0.92), dvec2(0.35, 0.75), dvec2(0.65, 0.8)}) {
                pick(lab, place);
                const Probe& probe = lab.ui.bench.pickedPixel().probe;
                const PaneSigns* const signs = carded(lab);
                if (!signs || !probe.decision || probe.decision->visibility < 1) continue;
                const lab::Pane& pane = lab.ui.bench.pane(signs->pane);
                const auto stage = std::ranges::find(pane.rendered().result.stages, "light-depth", [](const Stage& s) { return s.key.id; });
                ASSERT_NE(stage, pane.rendered().result.stages.end());
                const ivec2 size = stage->texture.size();
                const PlaceBox box = window::fittedPicture({float(size.x), float(size.y)}, signs->places.area());
                const auto column = static_cast<int>((signs->card->ring.x - box.low.x) / box.size().x * float(size.x));
                const auto fromTop = static_cast<int>((signs->card->ring.y - box.low.y) / box.size().y * float(size.y));
                const vec4 texel = gl::readTexels(stage->texture)[static_cast<std::size_t>(fromTop * size.x + column)];
                const scene::Light& light = lab.ui.bench.shownScene()->light(0);
                const dvec3 away = glm::abs(probe.geometry.front().toWorld - light.positionWorld);
                // Six maps hold depths, each along its own axis; one map that looks straight at the scene nearly distances.
                const bool isCube = probe.find<MapProbe>()->layers == 6;
                const double distance = isCube ? std::max(away.x, std::max(away.y, away.z)) : glm::length(away);
                EXPECT_NEAR(texel.r, distance, 0.05 * distance) << technique << " " << name << " " << place.x;
                ++compared;
            }
            EXPECT_GE(compared, 1) << technique << " " << name;
        }
}

// The matrix of the equations has no place for a point of the scene.
TEST_F(ProbeCardTest, WithoutARingThereIsNoCard) {
    Lab lab(scene("cornell-room"), {800, 500});
    chooseLayout(lab.ui, picture::Layout::single);
    chooseTechnique(lab.ui, "radiosity");
    lab.ui.bench.change("", [](lab::Document& d) { d.panes[0].settings["radiosity"]["patches"] = "100"; });
    pick(lab, {0.39, 0.958});
    ASSERT_NE(carded(lab), nullptr);
    chooseStage(lab.ui, {"matrix"});
    settle(lab.screen);
    EXPECT_EQ(carded(lab), nullptr);
}

} // namespace
} // namespace shadowlab
