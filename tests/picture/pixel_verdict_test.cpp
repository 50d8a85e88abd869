// A pixel's verdict in words, held against the numbers of the same probe: what it says is true of them.
// SPDX-License-Identifier: MIT
#include "app/picture/pixel_verdict.h"

#include <gtest/gtest.h>

#include <regex>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/probed/map_probe.h"
#include "techniques/probed/patch_exchange.h"
#include "techniques/probed/seen_point.h"
#include "techniques/probed/volume_probe.h"
#include "techniques/registry.h"

namespace shadowlab::picture {
namespace {

/// Probes of pixels that lie in rows over the picture, for the first light.
template <typename Check>
void overPictures(std::string_view technique, const Check& check,
                  const std::vector<std::pair<std::string, std::string>>& settings = {}) {
    for (const char* name : {"still-life", "eye-in-shadow", "three-lights"}) {
        const scene::Snapshot scene =
            scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        const std::unique_ptr<Technique> made = findTechnique(technique).make();
        params::ParamList params = made->params();
        for (const auto& [id, value] : settings)
            params::setFromText(params::find(params, id, technique), value, technique);
        View view;
        view.camera = scene->camera;
        view.size = {320, 180};
        for (int y = 7; y < view.size.y; y += 26)
            for (int x = 9; x < view.size.x; x += 37) {
                const Probe probe = made->probe(scene, view, {x, y}, 0);
                const PixelVerdict verdict = pixelVerdict(probe);
                check(probe, verdict,
                      std::string(name) + " " + std::to_string(x) + "," + std::to_string(y) + " " +
                          std::string(technique) + ": " + verdict.sentence);
            }
    }
}

TEST(PixelVerdictTest, SaysInCapitalsWhatTheTechniqueDecided) {
    int lit = 0, dark = 0, wrong = 0;
    for (const char* technique : {"planar", "shadow-map", "shadow-map-exact", "shadow-volume-zpass", "shadow-volume"})
        overPictures(technique, [&](const Probe& probe, const PixelVerdict& verdict, const std::string& where) {
            EXPECT_EQ(verdict.sentence.find('\n'), std::string::npos) << where;
            EXPECT_NE(verdict.sentence.find(": "), std::string::npos) << where;
            if (!probe.decision) return;
            EXPECT_TRUE(verdict.isOfTechnique) << where;
            EXPECT_EQ(verdict.isWrong, !probe.decision->why.empty()) << where;
            const bool isLit = probe.decision->visibility == 1;
            const std::string expected = verdict.isWrong
                                             ? (probe.decision->visibility > 0.5 ? "FALSE LIT: " : "FALSE SHADOW: ")
                                         : isLit                          ? "LIT: "
                                         : probe.decision->visibility > 0 ? "PARTLY LIT: "
                                         : probe.decision->isTurnedAway   ? "TURNED AWAY: "
                                                                          : "IN SHADOW: ";
            EXPECT_TRUE(verdict.sentence.starts_with(expected)) << where;
            (verdict.isWrong ? wrong : isLit ? lit : dark) += 1;
        });
    EXPECT_GE(lit, 100);
    EXPECT_GE(dark, 100);
    EXPECT_GE(wrong, 20) << "z-pass with the eye in shadow is wrong all over";
}

// "entered 1, left 2; beyond the point left 4, entered 4": what is counted, and so the technique's own number.
TEST(PixelVerdictTest, EnteredAndLeftAddUpToTheCount) {
    static const std::regex kWords("(?:starts at (\\d+), )?(?:entered (\\d+), left (\\d+))?(?:; )?"
                                   "(?:beyond the point left (\\d+), entered (\\d+))?");
    int checked = 0, notZero = 0;
    for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"})
        overPictures(technique, [&](const Probe& probe, const PixelVerdict& verdict, const std::string& where) {
            const auto* const volume = probe.find<VolumeProbe>();
            if (!volume || verdict.light == PixelLight::turnedAway || !probe.find<SeenPoint>()->receivesShadow) return;
            std::smatch found;
            const std::string reason = verdict.sentence.substr(verdict.sentence.find(": ") + 2);
            ASSERT_TRUE(std::regex_match(reason, found, kWords)) << where;
            const auto number = [&](std::size_t i) { return found[i].matched ? std::stoi(found[i]) : 0; };
            EXPECT_EQ(number(1) + number(2) - number(3) + number(4) - number(5), volume->count) << where;
            ++checked;
            notZero += volume->count != 0;
        });
    EXPECT_GE(checked, 200);
    EXPECT_GE(notZero, 30);
}

TEST(PixelVerdictTest, DepthsAreShownSoThatTheyDiffer) {
    static const std::regex kWords("d ([0-9.]+)(?: m)? (<|>=) z - bias ([0-9.]+)(?: m)?");
    int less = 0, notLess = 0;
    overPictures("shadow-map",
                 [&](const Probe& probe, const PixelVerdict& verdict, const std::string& where) {
                     std::smatch found;
                     const std::string reason = verdict.sentence.substr(verdict.sentence.find(": ") + 2);
                     if (!std::regex_match(reason, found, kWords)) return;
                     const auto* const map = probe.find<MapProbe>();
                     ASSERT_NE(map, nullptr);
                     const bool isLess = found[2] == "<";
                     EXPECT_EQ(isLess, map->stored < map->compared) << where;
                     EXPECT_EQ(std::stod(found[1]) < std::stod(found[3]), isLess) << where;
                     EXPECT_EQ(isLess, probe.decision->visibility == 0) << where;
                     (isLess ? less : notLess) += 1;
                 },
                 {{"filter", "hard"}});
    EXPECT_GE(less, 10);
    EXPECT_GE(notLess, 20);
}

// One conclusion: what the map or the count says changes nothing for a surface that gets no light.
TEST(PixelVerdictTest, WhatIsTurnedAwayIsNowhereCalledLit) {
    static const std::regex kLit("\\blit\\b|light is added|light is left out", std::regex::icase);
    int checked = 0;
    for (const char* technique : {"shadow-map", "shadow-map-exact", "shadow-volume-zpass", "shadow-volume-zfail"})
        overPictures(technique, [&](const Probe&, const PixelVerdict& verdict, const std::string& where) {
            if (verdict.light != PixelLight::turnedAway) return;
            EXPECT_TRUE(verdict.sentence.starts_with("TURNED AWAY: no direct light")) << where;
            for (const std::string& sum : verdict.sums)
                EXPECT_FALSE(std::regex_search(sum, kLit)) << where << ": " << sum;
            checked += verdict.sums.empty() ? 0 : 1;
        });
    EXPECT_GE(checked, 20);
}

// The same pixel lies on another patch where there are fewer of them, which sees another share of the light.
TEST(PixelVerdictTest, AShareOfTheLightSaysWhatItIsAShareOf) {
    PatchExchange exchange;
    exchange.j.object = "floor";
    exchange.j.area = 0.0862;
    Probe probe;
    probe.add(exchange);
    SeenPoint seen;
    seen.object = "floor";
    seen.light = 0;
    seen.lightName = "lamp";
    seen.truth = trace::Visibility::lit;
    seen.lightShare = 0.98;
    probe.add(seen);
    EXPECT_EQ(pixelVerdict(probe).sentence, "PARTLY LIT: the patch of 0.086 m^2 on floor sees 98 % of lamp");
}

TEST(PixelVerdictTest, AShadowRayMeetsSomethingOrArrives) {
    int arrives = 0, blocked = 0, background = 0;
    overPictures("ray-traced", [&](const Probe& probe, const PixelVerdict& verdict, const std::string& where) {
        const SeenPoint& seen = *probe.find<SeenPoint>();
        if (seen.object.empty()) {
            EXPECT_TRUE(verdict.sentence.starts_with("BACKGROUND: ")) << where;
            ++background;
            return;
        }
        if (verdict.light == PixelLight::turnedAway) return;
        const bool isLit = seen.truth == trace::Visibility::lit;
        EXPECT_EQ(verdict.sentence.find(isLit ? "LIT: the shadow ray to " : "IN SHADOW: the shadow ray to "), 0u)
            << where;
        EXPECT_TRUE(isLit ? verdict.sentence.ends_with(" arrives")
                          : verdict.sentence.find(" is blocked by ") != std::string::npos)
            << where;
        (isLit ? arrives : blocked) += 1;
    });
    EXPECT_GE(arrives, 50);
    EXPECT_GE(blocked, 10);
}

TEST(PixelVerdictTest, WhoTellsNothingOfItsOwnIsAnsweredForExactly) {
    int said = 0;
    overPictures("unshadowed", [&](const Probe& probe, const PixelVerdict& verdict, const std::string& where) {
        const trace::Visibility truth = probe.find<SeenPoint>()->truth;
        EXPECT_FALSE(verdict.isOfTechnique) << where;
        if (truth < trace::Visibility::shadowed) return;
        EXPECT_TRUE(verdict.sentence.starts_with(truth == trace::Visibility::lit ? "TRULY LIT: " : "TRULY IN SHADOW: "))
            << where;
        ++said;
    });
    EXPECT_GE(said, 100);
}

} // namespace
} // namespace shadowlab::picture
