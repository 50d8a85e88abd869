// Random scenes of six classes, each made to break one kind of careless shadow volume: all three ways to count, before and
// after repair. With SHADOWLAB_LONG=1 a hundred of each class for each kind of light, else ten.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

#include "techniques/shadow_volume/casters.h"
#include "tests/shadow_volume/volume_case.h"
#include "tests/support/hard_scenes.h"

namespace shadowlab {
namespace {

using testing::HardClass;
using testing::JudgedPicture;
using testing::kExactWays;
using testing::TruthComparison;

constexpr ivec2 kSize{256, 256};

int scenesPerClass() { return std::getenv("SHADOWLAB_LONG") ? 100 : 10; }

struct BeforeAndAfter {
    TruthComparison before, after;
    int mostBefore = 0; ///< wrong pixels of one picture
};

class HardClasses : public testing::VolumeCase, public ::testing::WithParamInterface<HardClass> {
protected:
    template <typename Visit>
    void forEachScene(const Visit& visit) const {
        for (const bool directional : {false, true})
            for (int i = 0; i < scenesPerClass(); ++i)
                visit(testing::hardScene(GetParam(), static_cast<unsigned>(i), directional));
    }
};

TEST_P(HardClasses, AreExactUpToCracksAndRepairMendsThose) {
    std::array<BeforeAndAfter, std::size(kExactWays)> both; // of each way, over all scenes of the class
    long textbook = 0;
    forEachScene([&](const scene::Scene& scene) {
        const JudgedPicture picture = judged(scene, 0, kSize);
        for (std::size_t w = 0; w < both.size(); ++w) {
            const TruthComparison before = picture.compare(draw(picture, kExactWays[w], false));
            both[w].mostBefore = std::max(both[w].mostBefore, before.wrong());
            both[w].before += before;
            both[w].after += picture.compare(draw(picture, kExactWays[w], true));
        }
        textbook += wrongWith(picture, "shadow-volume-zpass", {"eye-correction=false"});
    });
    for (std::size_t w = 0; w < both.size(); ++w) {
        const auto& [before, after, mostBefore] = both[w];
        std::cout << toText(GetParam()) << ", " << kExactWays[w].technique << "\n  before: " << before
                  << "\n  after:  " << after << "\n";
        SCOPED_TRACE(kExactWays[w].technique);
        // Inside a closed tube nothing is lit: light only leaves through the holes of half the scenes.
        EXPECT_GT(before.lit, GetParam() == HardClass::lightInMesh ? 500 : 10000);
        EXPECT_GT(before.shadowed, 10000);
        EXPECT_LE(before.wrong(), testing::kCrackShare * before.compared);
        EXPECT_LE(mostBefore, 4) << "a crack is one pixel; a wrong count would be a region";
        EXPECT_EQ(after.wrong(), 0);
        EXPECT_LE(after.ties, before.ties) << "had the surface that the rasteriser shows been kept, ties would be new";
        EXPECT_LE(before.ties, before.compared / 500);
    }
    // The comparison sees what the textbook's depth pass gets wrong wherever the eye is in many shadows.
    if (GetParam() == HardClass::lightInMesh || GetParam() == HardClass::eyeInSoup) {
        EXPECT_GT(textbook, both[0].before.compared / 100);
    }
}

// Where volumes end at infinity, their bottom lies on the far plane exactly, and rounding may not clip it there.
TEST_P(HardClasses, HaveVolumesThatReachInfinity) {
    int atInfinity = 0, all = 0;
    forEachScene([&](const scene::Scene& scene) {
        const scene::Snapshot snapshot = testing::snapshot(scene);
        shadow_volume::Casters casters;
        while (!casters.buildNext(snapshot)) {
        }
        for (const shadow_volume::CasterVolume& caster : casters.of(0)) {
            atInfinity += caster.useful && !caster.endWorld;
            ++all;
        }
    });
    std::cout << toText(GetParam()) << ": " << atInfinity << " of " << all << "\n";
    // A torus that the light is outside of has a side of the scene beyond it.
    EXPECT_GE(atInfinity, GetParam() == HardClass::torus ? 0 : 1);
}

INSTANTIATE_TEST_SUITE_P(All, HardClasses, ::testing::ValuesIn(testing::kHardClasses), [](const auto& info) {
    std::string name = toText(info.param);
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == '-'; }, '_');
    return name;
});

} // namespace
} // namespace shadowlab
