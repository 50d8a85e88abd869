// Random scenes of six classes, each made to break one kind of careless shadow volume: all three ways to count, before and
// after repair. With SHADOWLAB_LONG=1 a hundred of each class for each kind of light, else ten.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>

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
    static void expectCracksOnly(const BeforeAndAfter& both, const std::string& what) {
        const auto& [before, after, mostBefore] = both;
        std::cout << toText(GetParam()) << ", " << what << ": at most " << mostBefore
                  << " wrong in one picture\n  before: " << before << "\n  after:  " << after << "\n";
        SCOPED_TRACE(what);
        // Inside a closed tube nothing is lit: light only leaves through the holes of half the scenes.
        EXPECT_GT(before.lit, GetParam() == HardClass::lightInMesh ? 500 : 10000);
        EXPECT_GT(before.shadowed, 10000);
        EXPECT_LE(before.wrong(), testing::kCrackShare * before.compared);
        EXPECT_LE(mostBefore, 10) << "cracks along one edge; a wrong count would be a region";
        EXPECT_EQ(before.together, 0) << "a crack is a pixel alone";
        EXPECT_EQ(after.wrong(), 0);
        EXPECT_LE(after.ties, before.ties) << "had the surface that the rasteriser shows been kept, ties would be new";
        EXPECT_LE(before.ties, before.compared / 500);
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
    for (std::size_t w = 0; w < both.size(); ++w)
        expectCracksOnly(both[w], kExactWays[w].technique);
    // The comparison sees what the textbook's depth pass gets wrong wherever the eye is in many shadows.
    if (GetParam() == HardClass::lightInMesh || GetParam() == HardClass::eyeInSoup) {
        EXPECT_GT(textbook, both[0].before.compared / 100);
    }
}

// There the bottom of a volume lies exactly on the far plane, where rounding may not clip it, and the sides have corners with
// w = 0, which the rasteriser has to clip. All of it is allowed to cost cracks, and no more.
TEST_P(HardClasses, WithVolumesThatEndAtInfinity) {
    std::array<BeforeAndAfter, std::size(kExactWays)> both;
    forEachScene([&](const scene::Scene& scene) {
        const JudgedPicture picture = judged(scene, 0, testing::kCaseSize);
        for (std::size_t w = 0; w < both.size(); ++w) {
            testing::ExactWay way = kExactWays[w];
            way.settings.emplace_back("volume-end=infinity");
            const TruthComparison before = picture.compare(draw(picture, way, false));
            both[w].mostBefore = std::max(both[w].mostBefore, before.wrong());
            both[w].before += before;
            both[w].after += picture.compare(draw(picture, way, true));
        }
    });
    for (std::size_t w = 0; w < both.size(); ++w)
        expectCracksOnly(both[w], kExactWays[w].technique + ", to infinity");
}

INSTANTIATE_TEST_SUITE_P(All, HardClasses, ::testing::ValuesIn(testing::kHardClasses), [](const auto& info) {
    std::string name = toText(info.param);
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == '-'; }, '_');
    return name;
});

} // namespace
} // namespace shadowlab
