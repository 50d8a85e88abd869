// Wrong pixels that stand alone become squares; where they are dense they keep their form; counts never change.
// SPDX-License-Identifier: MIT
#include "app/picture/wrong_marks.h"

#include <gtest/gtest.h>

#include "app/picture/difference_panel.h"
#include "app/picture/verdict_panels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {
namespace {

using judge::Verdict;

constexpr ivec2 kSize{80, 60};
constexpr int kWidth = 5;

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kSize.x + x); }

std::vector<std::uint8_t> nothing() { return std::vector<std::uint8_t>(at(0, kSize.y)); }

int marked(const WrongMarks& marks) {
    return static_cast<int>(std::ranges::count_if(marks.owner, [](std::int32_t owner) { return owner != WrongMarks::kNone; }));
}

TEST(WrongMarks, AreAtLeastFivePixelsWideAndGrowWithThePicture) {
    EXPECT_EQ(wideMark(720), 5);
    EXPECT_EQ(wideMark(1080), 7);
    EXPECT_EQ(wideMark(2160), 13);
    EXPECT_EQ(wideMark(90), 5);
}

TEST(WrongMarks, MakeASquareOfAPixelThatStandsAlone) {
    std::vector<std::uint8_t> wrong = nothing();
    wrong[at(30, 20)] = 1;
    wrong[at(0, 0)] = 1; // its square ends at the edges
    const WrongMarks marks = wrongMarks(wrong, kSize, kWidth);
    EXPECT_EQ(marks.wide, 2);
    EXPECT_EQ(marks.single, 0);
    EXPECT_EQ(marked(marks), 25 + 9);
    for (int y = 18; y <= 22; ++y)
        for (int x = 28; x <= 32; ++x)
            EXPECT_EQ(marks.owner[at(x, y)], static_cast<std::int32_t>(at(30, 20))) << x << ' ' << y;
    EXPECT_EQ(noteOf(marks, kWidth), "each wrong pixel is drawn 5 pixels wide");

    const WrongMarks plain = wrongMarks(wrong, kSize, kOnePixel);
    EXPECT_EQ(marked(plain), 2);
    EXPECT_EQ(noteOf(plain, kOnePixel), "");
}

TEST(WrongMarks, DivideWhatIsBetweenTwo) {
    std::vector<std::uint8_t> wrong = nothing();
    wrong[at(30, 20)] = wrong[at(31, 20)] = 1;
    const WrongMarks marks = wrongMarks(wrong, kSize, kWidth);
    const std::int32_t left = static_cast<std::int32_t>(at(30, 20)), right = static_cast<std::int32_t>(at(31, 20));
    EXPECT_EQ(marks.owner[at(30, 20)], left);
    EXPECT_EQ(marks.owner[at(31, 20)], right);
    EXPECT_EQ(std::ranges::count(marks.owner, left) + std::ranges::count(marks.owner, right), 30);
    EXPECT_EQ(std::ranges::count(marks.owner, left), 15) << "three columns each";
}

TEST(WrongMarks, WidenALineAndKeepTheFormOfStripes) {
    std::vector<std::uint8_t> line = nothing(), stripes = nothing();
    for (int x = 5; x < 75; ++x)
        line[at(x, 30)] = 1;
    const WrongMarks widened = wrongMarks(line, kSize, kWidth);
    EXPECT_EQ(widened.wide, 70);
    EXPECT_EQ(marked(widened), 74 * kWidth);

    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x / 2; ++x)
            stripes[at(x, y)] = x % 4 == 0; // acne, with gaps that squares would fill
    stripes[at(70, 30)] = 1;               // and one far from it
    const WrongMarks kept = wrongMarks(stripes, kSize, kWidth);
    EXPECT_EQ(kept.wide, 1);
    EXPECT_EQ(kept.single, 10 * kSize.y);
    EXPECT_EQ(marked(kept), 10 * kSize.y + 25);
    EXPECT_EQ(noteOf(kept, kWidth), "wrong pixels that stand alone are drawn 5 pixels wide");
}

/// Two wrong pixels beside each other, of either kind, and one elsewhere.
struct Judged {
    judge::Truth truth;
    judge::Judgement judgement;
    Judged() {
        truth.size = kSize;
        truth.visibility.assign(at(0, kSize.y), trace::Visibility::lit);
        truth.objects.assign(at(0, kSize.y), 0);
        truth.ties.assign(at(0, kSize.y), 0);
        judgement.verdicts.assign(at(0, kSize.y), Verdict::correct);
        judgement.verdicts[at(40, 30)] = Verdict::falseLit;
        judgement.verdicts[at(41, 30)] = Verdict::falseShadow;
        judgement.verdicts[at(10, 10)] = Verdict::falseShadow;
    }
};

int count(const image::Image& picture, const vec3& color) {
    int found = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            found += picture.at(x, y) == image::encoded(color);
    return found;
}

TEST(WrongMarks, LeaveTheCountsOfVerdictsAsTheyAre) {
    const Judged judged;
    const Panel wide = errorOverlay(judged.truth, judged.judgement, {}, kWidth), plain = errorOverlay(judged.truth, judged.judgement, {});
    EXPECT_EQ(count(plain.picture, look::kFalseLit), 1);
    EXPECT_EQ(count(plain.picture, look::kFalseShadow), 2);
    EXPECT_EQ(count(wide.picture, look::kFalseLit) + count(wide.picture, look::kFalseShadow), 30 + 25);
    EXPECT_GE(count(wide.picture, look::kFalseLit), 10);
    EXPECT_EQ(wide.picture.at(40, 30), image::encoded(look::kFalseLit));
    EXPECT_EQ(wide.picture.at(41, 30), image::encoded(look::kFalseShadow));
    ASSERT_EQ(wide.display.key.size(), 3u);
    EXPECT_EQ(wide.display.key[0].label, "false lit (should be in shadow): 1 px");
    EXPECT_EQ(wide.display.key[1].label, "false shadow (should be lit): 2 px");
    EXPECT_EQ(wide.display.key[2].label, "tie: 0 px\neach wrong pixel is drawn 5 pixels wide");
    EXPECT_EQ(plain.display.key[2].label, "tie: 0 px");

    judge::Judgement right = judged.judgement;
    std::ranges::fill(right.verdicts, Verdict::correct);
    const Panel difference =
        differencePanel(image::Image(kSize.x, kSize.y), {&right, &judged.judgement}, {"A", "B"}, kWidth);
    EXPECT_EQ(count(difference.picture, look::kFalseLitSecond) + count(difference.picture, look::kFalseShadowSecond), 30 + 25);
    EXPECT_EQ(difference.display.key[2].label, "B: false lit: 1 px");
    EXPECT_EQ(difference.display.key[3].label, "B: false shadow: 2 px");
    EXPECT_EQ(difference.display.key[4].label, "both wrong: 0 px\neach wrong pixel is drawn 5 pixels wide");
}

} // namespace
} // namespace shadowlab::picture
