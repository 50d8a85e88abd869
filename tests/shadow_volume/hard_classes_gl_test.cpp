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

using testing::ExactWay;
using testing::HardClass;
using testing::JudgedPicture;
using testing::kExactWays;
using testing::TruthComparison;

constexpr ivec2 kSize{256, 256};

int scenesPerClass() { return std::getenv("SHADOWLAB_LONG") ? 100 : 10; }

struct BeforeAndAfter {
    TruthComparison before, after;
};

class HardClasses : public testing::VolumeCase, public ::testing::WithParamInterface<HardClass> {
protected:
    /// Of each way, over all scenes of the class.
    std::array<BeforeAndAfter, std::size(kExactWays)> sums() const {
        std::array<BeforeAndAfter, std::size(kExactWays)> sums;
        for (const bool directional : {false, true})
            for (int i = 0; i < scenesPerClass(); ++i) {
                const JudgedPicture picture =
                    judged(testing::hardScene(GetParam(), static_cast<unsigned>(i), directional), 0, kSize);
                for (std::size_t w = 0; w < sums.size(); ++w) {
                    const TruthComparison before = picture.compare(draw(picture, kExactWays[w], false));
                    if (before.wrong() > 3)
                        std::cout << kExactWays[w].technique << ", scene " << i
                                  << (directional ? ", directional: " : ": ") << before << "\n";
                    sums[w].before += before;
                    sums[w].after += picture.compare(draw(picture, kExactWays[w], true));
                }
            }
        return sums;
    }
};

TEST_P(HardClasses, AreExactUpToCracksAndRepairMendsThose) {
    const auto both = sums();
    for (std::size_t w = 0; w < both.size(); ++w) {
        const auto& [before, after] = both[w];
        std::cout << toText(GetParam()) << ", " << kExactWays[w].technique << "\n  before: " << before
                  << "\n  after:  " << after << "\n";
        SCOPED_TRACE(kExactWays[w].technique);
        // Inside a closed tube nothing is lit: light only leaves through the holes of half the scenes.
        EXPECT_GT(before.lit, GetParam() == HardClass::lightInMesh ? 100 : 10000);
        EXPECT_GT(before.shadowed, 10000);
        EXPECT_LE(before.wrong(), testing::kCrackShare * before.compared);
        EXPECT_EQ(after.wrong(), 0);
        EXPECT_EQ(after.core, 0);
        EXPECT_LE(after.ties, before.ties) << "had the surface that the rasteriser shows been kept, ties would be new";
        EXPECT_LE(before.ties, before.compared / 500);
    }
}

INSTANTIATE_TEST_SUITE_P(All, HardClasses, ::testing::ValuesIn(testing::kHardClasses), [](const auto& info) {
    std::string name = toText(info.param);
    std::ranges::replace_if(
        name, [](char c) { return c == ' ' || c == '-'; }, '_');
    return name;
});

} // namespace
} // namespace shadowlab
