// Rectangles, copies, blending and UTF-8.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "techniques/foundation/image/utf8.h"

namespace shadowlab::image {
namespace {

constexpr Color8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255}, kRed{255, 0, 0, 255};

int countOf(const Image& image, Color8 color) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            count += image.at(x, y) == color;
    return count;
}

TEST(Image, FillRectIsClippedOnAllSides) {
    Image image(10, 8, kBlack);
    fillRect(image, -3, -3, 5, 5, kRed);
    EXPECT_EQ(countOf(image, kRed), 4);
    fillRect(image, 8, 6, 100, 100, kWhite);
    EXPECT_EQ(countOf(image, kWhite), 4);
    fillRect(image, 20, 0, 5, 5, kRed);
    fillRect(image, 0, 0, -5, 5, kRed);
    EXPECT_EQ(countOf(image, kRed), 4);
}

TEST(Image, BlitCopiesTheOverlapOnly) {
    Image source(4, 4);
    for (int i = 0; i < 16; ++i)
        source.set(i % 4, i / 4, {static_cast<std::uint8_t>(i), 0, 0, 255});
    for (const auto& [x, y] : {std::pair{-2, -3}, {4, 5}, {1, 1}, {-9, 0}, {0, 9}}) {
        Image image(6, 6, kWhite);
        blit(image, x, y, source);
        for (int row = 0; row < 6; ++row)
            for (int column = 0; column < 6; ++column)
                EXPECT_EQ(image.at(column, row),
                          source.contains(column - x, row - y) ? source.at(column - x, row - y) : kWhite);
    }
}

TEST(Image, SrgbRoundTripIsExact) {
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(srgbFromLinear(linearFromSrgb(static_cast<std::uint8_t>(i))), i);
    EXPECT_EQ(srgbFromLinear(-1), 0);
    EXPECT_EQ(srgbFromLinear(2), 255);
}

TEST(Image, BlendingIsLinearInLight) {
    Image image(1, 1, kBlack);
    blendPixel(image, 0, 0, kWhite, 0.5f);
    EXPECT_EQ(image.at(0, 0), (Color8{188, 188, 188, 255})); // sRGB of 0.5
    blendPixel(image, 0, 0, kRed, 0);
    EXPECT_EQ(image.at(0, 0), (Color8{188, 188, 188, 255}));
    blendPixel(image, 0, 0, kRed, 1);
    EXPECT_EQ(image.at(0, 0), kRed);
    blendPixel(image, 5, -1, kRed, 1); // outside: nothing, and no crash
}

TEST(Image, BlendingOntoNothingKeepsTheColour) {
    Image image(1, 1);
    blendPixel(image, 0, 0, kRed, 0.5f);
    EXPECT_EQ(image.at(0, 0), (Color8{255, 0, 0, 128}));
}

TEST(Utf8, RoundTripAndReplacement) {
    const std::string good = "a\u00e9\u20ac\U0001F600";
    EXPECT_EQ(encodeUtf8(decodeUtf8(good)), good);
    EXPECT_EQ(decodeUtf8("a\xff"
                         "b"),
              std::u32string(U"a\uFFFDb"));
    EXPECT_EQ(decodeUtf8("\xc0\xaf"), std::u32string(U"\uFFFD\uFFFD"));           // overlong
    EXPECT_EQ(decodeUtf8("\xed\xa0\x80"), std::u32string(U"\uFFFD\uFFFD\uFFFD")); // a surrogate
    EXPECT_EQ(decodeUtf8("\xe2\x82"), std::u32string(U"\uFFFD\uFFFD"));           // cut short
}

} // namespace
} // namespace shadowlab::image
