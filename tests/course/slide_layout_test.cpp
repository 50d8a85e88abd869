// The layout of every slide of the built-in decks, as rectangles: one left edge, rows that end at one height, nothing over a picture.
// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_layout.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "app/course/slides/slide_legend.h"
#include "app/course/slides/slide_parts.h"
#include "app/course/slides/slide_words.h"
#include "techniques/foundation/base/error.h"
#include "tests/figures/written.h"

namespace shadowlab::course {
namespace {

const scene::LoadOptions kLayoutLoading{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
constexpr double kRounding = 1e-6; ///< units of a slide 1080 high: rounding of sums, far below a pixel

const Fonts& slideFonts() {
    static const image::Font upright(context::assetsRoot() / "fonts/DejaVuSans.ttf"), bold(context::assetsRoot() / "fonts/DejaVuSans-Bold.ttf");
    static const Fonts fonts{upright, bold};
    return fonts;
}

/// What pictures may ask for: legends of that height, and a square shape where a stage may have one.
std::vector<PictureNeeds> needsOf(const Slide& slide, double legend, bool isSquare) {
    std::vector<PictureNeeds> all;
    for (const SlidePart& part : partsOf(slide)) {
        PictureNeeds needs;
        needs.label = hasBands(part) ? "bands" : part.label;
        needs.isDrawing = !part.picture.figure.empty();
        if (mayHaveLegend(part)) {
            if (legend > 0) needs.legendHeight = [legend](double) { return legend; };
            if (isSquare) needs.aspect = 1.0;
        }
        all.push_back(std::move(needs));
    }
    return all;
}

bool isInside(const Box& inner, const Box& outer) {
    return glm::all(glm::greaterThanEqual(inner.corner, outer.corner - kRounding)) &&
           glm::all(glm::lessThanEqual(inner.corner + inner.size, outer.corner + outer.size + kRounding));
}

/// Do they share more than an edge?
bool covers(const Box& a, const Box& b) {
    return a.size.x > 0 && a.size.y > 0 &&
           Box{a.corner + kRounding, a.size - 2 * kRounding}.overlaps({b.corner + kRounding, b.size - 2 * kRounding});
}

void expectOrder(const SlideLayout& layout, const std::string& name) {
    const std::size_t count = layout.cells.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Box& cell = layout.cells[i];
        EXPECT_TRUE(isInside(cell, layout.pictures)) << name;
        EXPECT_TRUE(isInside(layout.legends[i], layout.pictures)) << name;
        const bool beginsRow = i == 0 || cell.corner.y > layout.cells[i - 1].corner.y + kRounding;
        const bool isBesideFirst = layout.isFirstLarge && i > 0;
        if (beginsRow) EXPECT_NEAR(cell.corner.x, isBesideFirst ? layout.cells[1].corner.x : kMargin, kRounding) << name << ": one left edge";
        EXPECT_NEAR(layout.legends[i].corner.x, cell.corner.x, kRounding) << name;
        if (!layout.labels.empty()) EXPECT_NEAR(layout.labels[i].corner.x, cell.corner.x, kRounding) << name;
        EXPECT_NEAR(cell.size.y, layout.cells[isBesideFirst ? 1 : 0].size.y, kRounding) << name << ": neighbours end at one height";
        EXPECT_GE(layout.captionTop, layout.legends[i].corner.y + layout.legends[i].size.y) << name;
        for (std::size_t j = 0; j < count; ++j) {
            EXPECT_FALSE(covers(layout.legends[j], cell)) << name << ": a legend over a picture";
            if (!layout.labels.empty()) EXPECT_FALSE(covers(layout.labels[j], cell)) << name << ": a label over a picture";
            if (i != j) EXPECT_FALSE(covers(layout.cells[j], cell)) << name;
        }
        if (layout.words.size.x > 0) EXPECT_FALSE(covers(layout.words, cell)) << name << ": words over a picture";
    }
    if (layout.isFirstLarge)
        EXPECT_NEAR(layout.cells[0].corner.y + layout.cells[0].size.y, layout.cells[3].corner.y + layout.cells[3].size.y, kRounding)
            << name << ": the large picture ends with the lower row";
    if (count == 0) EXPECT_NEAR(layout.words.corner.x, kMargin, kRounding) << name;
    EXPECT_LE(layout.words.corner.x + layout.words.size.x, layout.width - kMargin + kRounding) << name;
    const double captionEnd = layout.captionTop + kLineHeight * layout.captionType * static_cast<double>(layout.caption.size());
    EXPECT_LE(captionEnd, kSlideHeight - 1.8 * kFootType) << name << ": the caption reaches into the slide's foot";
}

TEST(SlideLayoutTest, EverySlideHasOneLeftEdgeAndNothingOverItsPictures) {
    int layouts = 0, pictures = 0;
    for (const std::string& name : builtInDecks(context::assetsRoot())) {
        Deck deck(name, kLayoutLoading);
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            const Slide slide = deck.read(i);
            for (const double width : {1920.0, 1440.0}) // 16:9 and 4:3
                for (const double legend : {0.0, 70.0, 180.0})
                    for (const bool isSquare : {false, true}) {
                        const std::vector<PictureNeeds> needs = needsOf(slide, legend, isSquare);
                        const SlideLayout layout = layOut(slide, width, slideFonts(), needs);
                        ASSERT_EQ(layout.cells.size(), needs.size());
                        expectOrder(layout, name + ", " + slide.name);
                        for (std::size_t part = 0; part < needs.size(); ++part)
                            if (needs[part].aspect)
                                EXPECT_NEAR(layout.cells[part].size.x / layout.cells[part].size.y, *needs[part].aspect, kRounding)
                                    << slide.name << ": bars beside a picture of its own shape";
                        ++layouts;
                        pictures += static_cast<int>(needs.size());
                    }
        }
    }
    EXPECT_GE(layouts, 75 * 12) << "75 slides, each in twelve ways";
    EXPECT_GE(pictures, 1000);
}

TEST(SlideLayoutTest, PicturesUseTheSlide) {
    // A picture alone is as high as the slide lets it be; two side by side reach from margin to margin.
    Slide slide;
    slide.written.title = slide.title = "Title";
    const std::vector<PictureNeeds> one(1), two(2);
    const SlideLayout alone = layOut(slide, 1920, slideFonts(), one), pair = layOut(slide, 1920, slideFonts(), two);
    EXPECT_GT(alone.cells[0].size.y, 0.8 * kSlideHeight);
    EXPECT_NEAR(pair.pictures.corner.x + pair.pictures.size.x, 1920 - kMargin, 2) << "heights are whole units";
    EXPECT_GT(pair.cells[0].size.y, 0.6 * kSlideHeight);
    const std::vector<PictureNeeds> four(4);
    const SlideLayout square = layOut(slide, 1920, slideFonts(), four);
    EXPECT_NEAR(square.cells[2].corner.x, square.cells[0].corner.x, kRounding) << "two rows of two";
}

// A scene before the square maps of three lights: in one row a third of the slide would stay empty.
TEST(SlideLayoutTest, OnePictureBeforeThreeSquareOnesIsLarge) {
    Slide slide;
    slide.written.title = slide.title = "Title";
    slide.written.caption = slide.caption = "The algorithm needs a depth buffer of its own for each light source.";
    std::vector<PictureNeeds> needs(4);
    for (std::size_t i = 0; i < needs.size(); ++i) {
        needs[i].label = "Label";
        if (i == 0) continue;
        needs[i].aspect = 1;
        needs[i].legendHeight = [](double) { return 70; };
    }
    const SlideLayout layout = layOut(slide, 1920, slideFonts(), needs);
    EXPECT_TRUE(layout.isFirstLarge);
    EXPECT_TRUE(layout.hasCaptionBeside);
    expectOrder(layout, "one before three");
    EXPECT_GT(layout.pictures.size.y, 0.8 * kSlideHeight);
    EXPECT_GT(layout.cells[0].size.y, 2 * layout.cells[1].size.y);
    EXPECT_GT(layout.cells[1].size.y, 0.3 * kSlideHeight);
    EXPECT_EQ(layout.words.corner.x, layout.cells[2].corner.x) << "the caption fills the fourth place";
    needs[3].aspect.reset();
    EXPECT_FALSE(layOut(slide, 1920, slideFonts(), needs).isFirstLarge) << "pictures of any shape fill rows";
}

// What a legend compares is a formula; a scene's own names are letters, whatever they look like.
TEST(SlideLegendTest, ConditionsAreFormulas) {
    EXPECT_EQ(legendProse("d < z: in shadow"), "$d < z$: in shadow");
    EXPECT_EQ(legendProse("N\u00b7L > 0: faces the light"), "$\\mathbf{N} \\cdot \\mathbf{L} > 0$: faces the light");
    EXPECT_EQ(legendProse("N\u00b7L \u2264 0: faces away"), "$\\mathbf{N} \\cdot \\mathbf{L} \\le 0$: faces away");
    EXPECT_EQ(legendProse("F_jk = 1"), "$F_{jk} = 1$");
    for (const std::string plain : {"top cap", "costs $5: lit", "0: j does not see k", "light a = b c: lit", "false lit: 3 px"})
        EXPECT_EQ(legendProse(plain), plain);
    for (const char* prose : {"$d < z$: in shadow", "$\\mathbf{N} \\cdot \\mathbf{L} \\le 0$: faces away"})
        EXPECT_EQ(drawing::proseInOneLine(prose, 24, false, slideFonts().formula()).pieces.size(), 2U) << prose;
}

// A side that pictures leave empty is for the caption; a column of words is no wider than its type needs.
TEST(SlideLayoutTest, NoSideOfTheSlideStaysEmpty) {
    Slide slide;
    slide.written.title = slide.title = "Title";
    slide.written.caption = slide.caption = "Each reflection is one product with a matrix. The sum of all of them is the solution.";
    for (const std::size_t pictures : {1, 4}) {
        const SlideLayout layout = layOut(slide, 1920, slideFonts(), std::vector<PictureNeeds>(pictures));
        EXPECT_TRUE(layout.hasCaptionBeside) << pictures;
        EXPECT_TRUE(layout.caption.empty()) << pictures;
        EXPECT_GT(layout.words.size.x, 0.2 * 1920) << pictures;
        EXPECT_NEAR(layout.words.corner.x + layout.words.size.x, 1920 - kMargin, kRounding) << pictures;
        EXPECT_GT(layout.pictures.size.y, 0.75 * kSlideHeight) << pictures;
        EXPECT_EQ(wordsType(slide, true, layout.words.size, slideFonts()).letters, 36) << pictures;
    }
    const SlideLayout pair = layOut(slide, 1920, slideFonts(), std::vector<PictureNeeds>(2));
    EXPECT_FALSE(pair.hasCaptionBeside) << "two pictures fill the width";
    const SlideLayout row = layOut(slide, 1920, slideFonts(), std::vector<PictureNeeds>(3));
    EXPECT_FALSE(row.hasCaptionBeside);
    EXPECT_GT(row.captionType, kCaptionType) << "below a row of three there is room";

    Slide few = slide;
    few.written.caption.clear();
    few.text = few.written.text = {"A short text."};
    Slide many = few;
    many.text = many.written.text = std::vector<std::string>(7, "A text of which there is a lot, so that it needs the whole column.");
    const SlideLayout narrow = layOut(few, 1920, slideFonts(), std::vector<PictureNeeds>(1)),
                      wide = layOut(many, 1920, slideFonts(), std::vector<PictureNeeds>(1));
    EXPECT_LT(narrow.words.size.x, 0.9 * wide.words.size.x);
    EXPECT_EQ(wordsType(few, false, narrow.words.size, slideFonts()).letters, 36);
}

// Marked lines of pseudocode are bold, which is wider: they are broken as they are drawn.
TEST(SlideWordsTest, NoLineReachesBeyondTheWords) {
    int lines = 0, bold = 0;
    for (const std::string& name : builtInDecks(context::assetsRoot())) {
        Deck deck(name, kLayoutLoading);
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            const Slide slide = deck.read(i);
            const SlideLayout layout = layOut(slide, 1920, slideFonts(), needsOf(slide, 70, false));
            drawing::Drawing drawing({1920, kSlideHeight});
            writeWords(drawing, slide, layout, slideFonts());
            for (const figures::Written& one : figures::written(drawing.document("words"))) {
                const image::Font& font = one.isBold ? slideFonts().bold : slideFonts().upright;
                // Lines are broken by whole pixels of their type: two units.
                EXPECT_LE(one.box.corner.x + drawing::textSize(font, one.text, one.em).x, layout.words.corner.x + layout.words.size.x + 2)
                    << name << ", " << slide.name << ": " << one.text;
                ++lines;
                bold += one.isBold;
            }
        }
    }
    EXPECT_GE(lines, 150);
    EXPECT_GE(bold, 5);
}

TEST(ProseTest, FormulasStandAmongWords) {
    const auto lines = drawing::wrapProse("the texel holds $d(u,v)$, one depth", 30, 10000, false, slideFonts().formula());
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].pieces.size(), 3u);
    EXPECT_EQ(lines[0].pieces[0].text, "the texel holds ");
    EXPECT_TRUE(lines[0].pieces[1].isFormula);
    EXPECT_EQ(lines[0].pieces[2].text, ", one depth");
    EXPECT_EQ(drawing::plainProse("holds $n_f$."), "holds n_f.");
    const auto narrow = drawing::wrapProse("the texel holds $d(u,v)$, one depth", 30, 200, false, slideFonts().formula());
    EXPECT_GT(narrow.size(), 2u);
    for (const drawing::ProseLine& line : narrow)
        EXPECT_LE(drawing::proseWidth(line, 30, false, slideFonts().formula()), 200);
    EXPECT_THROW(drawing::plainProse("costs 5 $"), Error);
}

} // namespace
} // namespace shadowlab::course
