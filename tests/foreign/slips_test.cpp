// Mistakes with a number or a name, by another renderer (foreign_renderer.h): each is called by its name first, and its number is right, in visibility
// images and in pairs of shaded pictures.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <regex>
#include <tuple>

#include "tests/foreign/staged_pictures.h"

namespace shadowlab::foreign {
namespace {

using foreign_renderer::Method;

/// The first number that the expression finds in the cause's words, which has one group.
double numberIn(const std::string& words, const char* expression) {
    std::smatch found;
    return std::regex_search(words, found, std::regex(expression)) ? std::stod(found[1]) : NAN;
}

/// Both ways in which a picture may be judged.
std::vector<std::pair<std::string, JudgedPicture>> judgedBothWays(const Staged& stage, const Settings& settings) {
    const Pictures pictures = foreign_renderer::render(stage.own, settings);
    std::vector<std::pair<std::string, JudgedPicture>> judged;
    judged.emplace_back(stage.own.name + ", visibility", judgedVisibility(stage, pictures));
    judged.emplace_back(stage.own.name + ", pair", judgedPair(stage, pictures));
    return judged;
}

const NamedCause* firstCause(const JudgedPicture& judged) { return judged.diagnosis.causes.empty() ? nullptr : &judged.diagnosis.causes.front(); }

/// Named first, and it explains nearly all.
void expectFirst(const std::string& where, const JudgedPicture& judged, std::string_view id, const std::string& words, double least) {
    const NamedCause* const first = firstCause(judged);
    ASSERT_TRUE(first) << where << "\n" << said(judged);
    EXPECT_EQ(first->id, id) << where << "\n" << said(judged);
    EXPECT_NE(first->what.find(words), std::string::npos) << where << "\n" << said(judged);
    EXPECT_GE(first->explained, least) << where << "\n" << said(judged);
}

/// So much of the width that shadows of several things lie within, and enough of them outside.
TEST(ForeignSlipsTest, AMapThatCoversAPartOnlyIsNamed) {
    int cases = 0;
    for (const auto& [scene, part, dark] : {std::tuple(0, 0.45, false), std::tuple(1, 0.45, false), std::tuple(1, 0.7, false), std::tuple(2, 0.45, false),
                                            std::tuple(0, 0.45, true), std::tuple(0, 0.7, true), std::tuple(1, 0.7, true), std::tuple(2, 0.7, true)}) {
        Settings settings;
        settings.method = Method::map, settings.raysInMap = true, settings.mapPart = part, settings.darkOutside = dark;
        for (const auto& [where, judged] : judgedBothWays(staged()[static_cast<std::size_t>(scene)], settings)) {
            expectFirst(where + (dark ? ", dark" : ", lit") + " outside of " + std::to_string(part), judged, "outside-map", dark ? "where all is dark" : "where all is lit", 0.8);
            ++cases;
        }
    }
    EXPECT_EQ(cases, 16);
}

/// With depths in the map, 2048 texels wide, and a bias of a centimetre: there are other errors as well.
TEST(ForeignSlipsTest, AMapOfDepthsThatCoversAPartOnlyIsNamed) {
    int cases = 0;
    for (const Staged& stage : staged())
        for (const bool dark : {false, true}) {
            Settings settings;
            settings.method = Method::map, settings.texels = 2048, settings.bias = 0.01, settings.mapPart = 0.5, settings.darkOutside = dark;
            for (const auto& [where, judged] : judgedBothWays(stage, settings)) {
                expectFirst(where + (dark ? ", dark" : ", lit") + " outside", judged, "outside-map", dark ? "where all is dark" : "where all is lit", 0.5);
                ++cases;
            }
        }
    EXPECT_EQ(cases, 12);
}

/// The scene with these things as one, which then shades itself.
Staged joined(const Staged& stage, std::vector<std::string> names) {
    foreign_renderer::Scene own = stage.own;
    own.things.clear();
    std::vector<int> places;
    int together = -1;
    for (const foreign_renderer::Thing& thing : stage.own.things) {
        const bool isPart = std::ranges::find(names, thing.name) != names.end();
        if (isPart && together >= 0) {
            places.push_back(together);
            continue;
        }
        places.push_back(static_cast<int>(own.things.size()));
        if (isPart) together = places.back();
        own.things.push_back(thing);
    }
    for (foreign_renderer::Tri& tri : own.triangles)
        tri.thing = places[static_cast<std::size_t>(tri.thing)];
    return stagedScene(own);
}

TEST(ForeignSlipsTest, MissingSelfShadowsAreNamed) {
    int cases = 0;
    for (const Staged& stage : {joined(staged()[0], {"block", "plank", "post", "card"}), joined(staged()[1], {"wall", "fence", "ball", "awning"}), joined(staged()[2], {"step 1", "step 2", "step 3", "ball", "leaf"})}) {
        Settings settings;
        settings.selfShadows = false;
        for (const auto& [where, judged] : judgedBothWays(stage, settings)) {
            expectFirst(where, judged, "self-shadows-missing", "cast no shadow on themselves", 0.95);
            ++cases;
        }
    }
    EXPECT_EQ(cases, 6);
}

/// Of one of them, the flag, the picture has 27 pixels of shadow only.
TEST(ForeignSlipsTest, TheOnlyCasterIsNamed) {
    int cases = 0;
    for (const auto& [scene, name] : {std::pair(0, "plank"), std::pair(0, "card"), std::pair(1, "ball"), std::pair(1, "flag"), std::pair(2, "ball"), std::pair(2, "petal")}) {
        const Staged& stage = staged()[static_cast<std::size_t>(scene)];
        Settings settings;
        settings.onlyThing = static_cast<int>(std::ranges::find(stage.own.things, std::string(name), &foreign_renderer::Thing::name) - stage.own.things.begin());
        for (const auto& [where, judged] : judgedBothWays(stage, settings)) {
            expectFirst(where + ", " + name, judged, "caster-missing", "only one object casts a shadow, '" + std::string(name) + "'", 0.95);
            ++cases;
        }
    }
    EXPECT_EQ(cases, 12);
}

TEST(ForeignSlipsTest, ASmallMoveOfTheLightIsToldWithItsDistance) {
    int cases = 0;
    for (const Staged& stage : staged()) {
        if (stage.own.isSun) continue;
        for (const double metres : {0.01, 0.03})
            for (const foreign_renderer::Vec way : {foreign_renderer::Vec{1, 0, 0}, {0, 1, 0}, {0.6, 0, -0.8}}) {
                Settings settings;
                settings.lightOffset = metres * way;
                for (const auto& [where, judged] : judgedBothWays(stage, settings)) {
                    const std::string place = where + " " + std::to_string(metres) + " " + std::to_string(way.x) + " " + std::to_string(way.y) + " " + std::to_string(way.z);
                    expectFirst(place, judged, "light-displaced", "the light stands in the wrong place", 0.8);
                    if (const NamedCause* const first = firstCause(judged)) {
                        const bool centimetres = first->what.find(" cm away") != std::string::npos;
                        const double told = numberIn(first->what, "([0-9.]+) c?m away") * (centimetres ? 0.01 : 1);
                        EXPECT_NEAR(told, metres, 0.15 * metres) << place << "\n" << said(judged);
                    }
                    ++cases;
                }
            }
    }
    EXPECT_EQ(cases, 24);
}

/// In a pair no light is expected outside of it, so only what the picture's cone lacks can be seen there, and of that
/// only shadows: the other picture lacks the light, too.
TEST(ForeignSlipsTest, AnotherConeIsToldWithItsAngle) {
    int cases = 0;
    for (const Staged& stage : staged()) {
        if (stage.own.isSun) continue;
        const Staged other = underASpot(stage);
        for (const double degrees : {15.0, 28.0, 45.0}) {
            Settings settings;
            settings.coneDegrees = degrees;
            for (const auto& [where, judged] : judgedBothWays(other, settings)) {
                if (judged.errors.judgement.counts.wrong() == 0) {
                    EXPECT_TRUE(degrees > 20 && where.ends_with("pair")) << where;
                    continue;
                }
                expectFirst(where + " " + std::to_string(degrees), judged, "cone", "the spot's cone is another", 0.95);
                if (const NamedCause* const first = firstCause(judged)) EXPECT_NEAR(numberIn(first->what, "([0-9.]+) degrees wide"), degrees, 1) << where << "\n" << said(judged);
                ++cases;
            }
        }
    }
    EXPECT_EQ(cases, 8);
}

} // namespace
} // namespace shadowlab::foreign
