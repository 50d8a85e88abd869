// Labels by themselves: where they may stand, which are left out, and what a grid says of lines and faces.
// SPDX-License-Identifier: MIT
#include "app/picture/outside/label_layout.h"

#include <gtest/gtest.h>

namespace shadowlab::picture {
namespace {

constexpr ivec2 kSize{400, 300};
constexpr double kEm = 12;

dvec2 sizeOf(const std::string& text) { return {7.0 * static_cast<double>(text.size()), 16}; }

LabelRoom room(ivec2 size = kSize) { return {size, kEm, 0}; }

TEST(LabelLayoutTest, LabelsOfOnePlaceStandApartAndLeaveItFree) {
    const CoverGrid cover(kSize, 6);
    std::vector<LabelWish> wishes;
    for (const char* text : {"eye", "near plane", "silhouette", "bottom cap", "sides"})
        wishes.push_back({text, vec3(1), CoverGrid::kMostThings, {dvec2(200, 150)}});
    const auto placed = placeLabels(wishes, cover, room(), sizeOf);
    ASSERT_EQ(placed.size(), wishes.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_FALSE(placed[i].standsOnIt()) << placed[i].text;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(placed[i].box.overlaps(placed[k].box)) << placed[i].text << " and " << placed[k].text;
    }
}

TEST(LabelLayoutTest, TheLabelStaysWithinThePicture) {
    const CoverGrid cover(kSize, 6);
    int looked = 0;
    for (const dvec2& place : {dvec2(2, 2), dvec2(398, 2), dvec2(2, 298), dvec2(398, 298), dvec2(200, 1)}) {
        const auto placed = placeLabels({{"a long label", vec3(1), CoverGrid::kMostThings, {place}}}, cover, room(), sizeOf);
        ASSERT_EQ(placed.size(), 1u);
        EXPECT_GE(placed[0].box.lower.x, 0);
        EXPECT_GE(placed[0].box.lower.y, 0);
        EXPECT_LE(placed[0].box.upper.x, kSize.x);
        EXPECT_LE(placed[0].box.upper.y, kSize.y);
        ++looked;
    }
    EXPECT_EQ(looked, 5);
}

TEST(LabelLayoutTest, SmallPicturesKeepTheMostImportant) {
    constexpr ivec2 kSmall{120, 80};
    const CoverGrid cover(kSmall, 6);
    std::vector<LabelWish> wishes;
    for (const char* text : {"light", "eye", "silhouette", "bottom cap"})
        wishes.push_back({text, vec3(1), CoverGrid::kMostThings, {dvec2(60, 40)}});
    const auto placed = placeLabels(wishes, cover, room(kSmall), sizeOf);
    ASSERT_GE(placed.size(), 1u);
    EXPECT_LT(placed.size(), wishes.size());
    for (std::size_t i = 0; i < placed.size(); ++i)
        EXPECT_EQ(placed[i].text, wishes[i].text);
}

TEST(LabelLayoutTest, ALargeFaceHasItsLabelOnItAndLinesAreKeptFree) {
    CoverGrid cover(kSize, 6);
    cover.addTriangle({dvec2(20, 20), dvec2(380, 20), dvec2(20, 280)}, 0);
    EXPECT_TRUE(cover.hasFace(cover.cellAt({80, 80}), 0));
    EXPECT_FALSE(cover.hasFace(cover.cellAt({380, 280}), 0));
    const auto onFace = placeLabels({{"face", vec3(1), 0, {dvec2(100, 100)}}}, cover, room(), sizeOf);
    ASSERT_EQ(onFace.size(), 1u);
    EXPECT_TRUE(onFace[0].standsOnIt());

    cover.addLine({0, 100}, {400, 100}, 1);
    const auto beside = placeLabels({{"face", vec3(1), 0, {dvec2(100, 100)}}}, cover, room(), sizeOf);
    ASSERT_EQ(beside.size(), 1u);
    EXPECT_EQ(cover.lineShare(beside[0].box), 0) << "it would hide the line";
}

TEST(LabelLayoutTest, SegmentsAreCutAtABoxsBorder) {
    const PixelBox box{{0, 0}, {10, 10}};
    dvec2 from(-5, 5), to(15, 5);
    ASSERT_TRUE(cutToBox(from, to, box));
    EXPECT_EQ(from, dvec2(0, 5));
    EXPECT_EQ(to, dvec2(10, 5));
    dvec2 above(-5, 12), beside(15, 12);
    EXPECT_FALSE(cutToBox(above, beside, box));
    dvec2 point(3, 3), same(3, 3);
    EXPECT_TRUE(cutToBox(point, same, box));
}

} // namespace
} // namespace shadowlab::picture
