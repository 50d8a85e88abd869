// Text: the ink lies in the measured box, every script the captions use has glyphs, and lines fit where they are told
// to.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/foundation/base/error.h"

namespace shadowlab::image {
namespace {

constexpr Color8 kBlack{0, 0, 0, 255}, kWhite{255, 255, 255, 255};
constexpr int kMargin = 40; // room to see ink that leaves its box

const Font& font() {
    static const Font sans(SHADOWLAB_SOURCE_DIR "/assets/fonts/DejaVuSans.ttf");
    return sans;
}

struct Ink {
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1; ///< relative to the box; right and bottom exclusive
    std::int64_t amount = 0;
};

Ink inkOf(const std::string& text, double pixelHeight) {
    const TextSize size = font().measure(text, pixelHeight);
    Image image(size.width + 2 * kMargin, size.height + 2 * kMargin, kBlack);
    font().draw(image, kMargin, kMargin, text, pixelHeight, kWhite);
    Ink ink;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) == kBlack) continue;
            ink.left = std::min(ink.left, x - kMargin), ink.right = std::max(ink.right, x - kMargin + 1);
            ink.top = std::min(ink.top, y - kMargin), ink.bottom = std::max(ink.bottom, y - kMargin + 1);
            ink.amount += image.at(x, y).r;
        }
    return ink;
}

TEST(Text, InkLiesWithinTheMeasuredBoxAndFillsItsWidth) {
    for (const char* text :
         {"Shadow map", "jjj", "\u00c4\u1ebe\u0170", "fff/", "Tj\nlonger second line", "AVAVAV", "\u2264 \u03b1"})
        for (const double pixelHeight : {9.0, 14.5, 32.0, 100.0}) {
            SCOPED_TRACE(std::string(text) + " at " + std::to_string(pixelHeight));
            const TextSize size = font().measure(text, pixelHeight);
            const Ink ink = inkOf(text, pixelHeight);
            EXPECT_GE(ink.left, 0);
            EXPECT_GE(ink.top, 0);
            EXPECT_LE(ink.right, size.width);
            EXPECT_LE(ink.bottom, size.height);
            EXPECT_GE(ink.right - ink.left, size.width - 0.3 * pixelHeight - 2); // side bearings are thin
        }
}

TEST(Text, SizesScale) {
    const TextSize small = font().measure("Shadow volume", 20), large = font().measure("Shadow volume", 200);
    EXPECT_NEAR(large.width, 10 * small.width, 10); // one pixel of rounding, ten times
    EXPECT_NEAR(large.height, 10 * small.height, 20);
    EXPECT_EQ(font().measure("", 20).width, 0);
}

TEST(Text, LinesAddUp) {
    const TextSize one = font().measure("x", 20), three = font().measure("x\nx\nx", 20);
    EXPECT_EQ(three.width, one.width);
    EXPECT_EQ(three.height - one.height, 2 * (font().measure("x\nx", 20).height - one.height));
}

TEST(Text, CharactersOfTheCaptionsAreInTheFont) {
    Image missing(64, 64, kBlack);
    font().draw(missing, 8, 8, "\U000F0000", 32, kWhite); // private use: surely the empty box
    for (const char* text :
         {"\u00e9", "\u00df", "\u03b1", "\u2264", "\u00d7", "\u2013", "\u221e", "\u2192", "\u00b0", "\u0416"}) {
        Image drawn(64, 64, kBlack);
        font().draw(drawn, 8, 8, text, 32, kWhite);
        EXPECT_NE(drawn, missing) << text;
        EXPECT_GT(inkOf(text, 32).amount, 0) << text;
    }
}

TEST(Text, SamePixelsEveryTimeAndAtEveryPlace) {
    Image first(200, 60, kBlack), second(200, 60, kBlack), moved(203, 65, kBlack), shifted(203, 65, kBlack);
    font().draw(first, 5, 5, "Shadow \u03b1", 24, kWhite);
    font().draw(second, 5, 5, "Shadow \u03b1", 24, kWhite);
    EXPECT_EQ(first, second);
    font().draw(moved, 8, 10, "Shadow \u03b1", 24, kWhite);
    blit(shifted, 3, 5, first);
    EXPECT_EQ(moved, shifted);
}

TEST(Text, DrawingOutsideIsClipped) {
    Image image(20, 10, kBlack);
    for (const int x : {-50, -5, 15, 500})
        font().draw(image, x, x / 2, "Shadow", 16, kWhite);
    EXPECT_NE(image, Image(20, 10, kBlack));
}

TEST(Text, WrappedLinesFitAndLoseNothing) {
    const std::string text = "The z-fail test counts the faces behind the receiver, incomprehensibilities included.";
    for (const int width : {60, 120, 300}) {
        std::string together;
        for (const std::string& line : font().wrap(text, 16, width)) {
            EXPECT_LE(font().measure(line, 16).width, width) << line;
            together += line;
        }
        std::string letters = text;
        std::erase(letters, ' '), std::erase(together, ' ');
        EXPECT_EQ(together, letters);
    }
    EXPECT_EQ(font().wrap("a b\nc", 16, 1000), (std::vector<std::string>{"a b", "c"}));
    EXPECT_EQ(font().wrap("", 16, 100), std::vector<std::string>{""});
}

TEST(Text, MissingOrBrokenFontNamesTheMend) {
    for (const char* file : {"/no/such.ttf", SHADOWLAB_SOURCE_DIR "/assets/fonts/LICENSE-DejaVu.txt"}) {
        try {
            const Font none(file);
            FAIL() << file;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            EXPECT_EQ(std::string(error.what()).find(file), 0u);
            EXPECT_NE(std::string(error.what()).find("fonts-dejavu-core"), std::string::npos);
        }
    }
}

} // namespace
} // namespace shadowlab::image
