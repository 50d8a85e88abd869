// A painted drawing shows its marks where they are, and nothing elsewhere.
// SPDX-License-Identifier: MIT
#include "app/drawing/paint.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::drawing {
namespace {

constexpr image::Color8 kWhite{255, 255, 255, 255};

class PaintTest : public ::testing::Test {
protected:
    [[nodiscard]] image::Image painted(const Drawing& drawing, ivec2 corner = {0, 0}, double scale = 1) const {
        image::Image picture(200, 100, kWhite);
        painter_.paint(drawing, picture, corner, scale);
        return picture;
    }
    static int inked(const image::Image& picture, ivec2 from = {0, 0}, ivec2 to = {200, 100}) {
        int count = 0;
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x)
                count += picture.at(x, y) != kWhite;
        return count;
    }
    Painter painter_{context::assetsRoot() / "fonts"};
};

TEST_F(PaintTest, WhatIsNoCharacterIsDrawnAsTheReplacementOfOne) {
    const auto written = [&](const std::string& text) {
        Drawing drawing({200, 100});
        drawing.text({10, 50}, text, {});
        return painted(drawing);
    };
    const image::Image expected = written("a\xEF\xBF\xBD");
    EXPECT_GT(inked(expected), inked(written("a")) + 20);
    // Cairo refuses each of them: U+FFFF, U+FDD0, U+10FFFE, and a byte that begins nothing.
    for (const char* odd : {"a\xEF\xBF\xBF", "a\xEF\xB7\x90", "a\xF4\x8F\xBF\xBE", "a\xFF"})
        EXPECT_EQ(written(odd), expected);
}

// A line that was measured to fit does not run past the margin, and what follows it does not stand in it.
TEST_F(PaintTest, LettersEndWhereTheFontMeasuresThem) {
    const std::string text = "A point is in the shadow of a light source if the segment that connects both meets an object";
    int compared = 0;
    for (const bool isBold : {false, true})
        for (const double em : {15.0, 24.0, 28.0}) {
            const image::Font font(context::assetsRoot() / "fonts" / (isBold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf"));
            Drawing drawing({2000, 60});
            drawing.text({10, 40}, text, {.size = em, .isBold = isBold, .hasRim = false});
            image::Image picture(2000, 60, kWhite);
            painter_.paint(drawing, picture, {0, 0}, 1);
            int last = 0;
            for (int x = 0; x < picture.width; ++x)
                for (int y = 0; y < picture.height; ++y)
                    if (picture.at(x, y) != kWhite) last = x;
            // The last letter ends within its width; the measure is in whole pixels.
            EXPECT_NEAR(last, 10 + font.measure(text, em).width, 3) << em;
            ++compared;
        }
    EXPECT_EQ(compared, 6);
}

TEST_F(PaintTest, FilledRectanglesHaveTheirColorAndPlace) {
    Drawing drawing({200, 100});
    drawing.rectangle({20, 30}, {50, 40}, "#0072b2", {"#000000", 0, false});
    const image::Image picture = painted(drawing);
    EXPECT_EQ(inked(picture), 50 * 40);
    EXPECT_EQ(picture.at(45, 50), (image::Color8{0x00, 0x72, 0xb2, 255}));
    const image::Image twice = painted(drawing, {10, 0}, 0.5);
    EXPECT_EQ(inked(twice), 25 * 20);
    EXPECT_EQ(inked(twice, {20, 15}, {45, 35}), 25 * 20) << "half as large, and moved";
}

TEST_F(PaintTest, EveryKindOfMarkIsSeenAndClipsHide) {
    const auto drawn = [&](const auto& draw) {
        Drawing drawing({200, 100});
        draw(drawing);
        const int all = inked(painted(drawing));
        Drawing clipped({200, 100});
        clipped.beginClip({0, 0}, {100, 100});
        draw(clipped);
        clipped.endClip();
        const image::Image half = painted(clipped);
        EXPECT_EQ(inked(half, {100, 0}, {200, 100}), 0);
        EXPECT_GT(inked(half), 0);
        EXPECT_LT(inked(half), all);
        return all;
    };
    const Stroke stroke{"#000000", 4, false};
    EXPECT_NEAR(drawn([&](Drawing& drawing) { drawing.line({20, 50}, {180, 50}, stroke); }), 164 * 4, 8);
    EXPECT_LT(drawn([&](Drawing& drawing) {
                  drawing.line({20, 50}, {180, 50}, {"#000000", 4, true});
              }),
              150 * 4)
        << "dashes";
    EXPECT_GT(drawn([&](Drawing& drawing) { drawing.arrow({20, 50}, {180, 50}, stroke); }), 164 * 4);
    EXPECT_GT(drawn([&](Drawing& drawing) { drawing.circle({100, 50}, 30, "#ff0000", stroke); }), 3000);
    EXPECT_GT(drawn([&](Drawing& drawing) { drawing.rectangle({50, 20}, {100, 60}, "", stroke, 10); }), 1000);
    EXPECT_GT(drawn([&](Drawing& drawing) { drawing.text({20, 60}, "shadow volume", {.size = 24}); }), 1000);
    const dvec2 points[] = {{20, 20}, {180, 20}, {180, 80}};
    EXPECT_GT(drawn([&](Drawing& drawing) { drawing.path(points, true, "#00ff00", stroke); }), 4000);
}

TEST_F(PaintTest, SameDrawingSameBytes) {
    Drawing drawing({200, 100});
    drawing.text({20, 60}, "N · L > 0", {.size = 30, .isItalic = true});
    EXPECT_EQ(painted(drawing), painted(drawing));
    EXPECT_EQ(painted(drawing), [&] {
        image::Image picture(200, 100, kWhite);
        Painter(context::assetsRoot() / "fonts").paint(drawing, picture);
        return picture;
    }());
}

TEST_F(PaintTest, AMissingFontIsTold) { EXPECT_THROW(Painter("/nowhere"), Error); }

} // namespace
} // namespace shadowlab::drawing
