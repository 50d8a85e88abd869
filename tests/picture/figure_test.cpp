// Cells tile the figure; labels are large enough to read and small enough to leave something to see.
// SPDX-License-Identifier: MIT
#include "app/picture/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/picture/labels.h"

namespace shadowlab::picture {
namespace {

const std::vector<ivec2> kSizes = {{1280, 720}, {1281, 721}, {97, 101}, {7, 5}, {1920, 1}, {640, 1080}};

const image::Font& font() {
    static const image::Font font(std::string(SHADOWLAB_SOURCE_DIR) + "/assets/fonts/DejaVuSans.ttf");
    return font;
}

/// How many cells each pixel belongs to.
std::vector<int> coverage(const std::vector<Cell>& cells, ivec2 size) {
    std::vector<int> count(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (const Cell& cell : cells)
        for (int y = cell.y; y < cell.y + cell.height; ++y)
            for (int x = cell.x; x < cell.x + cell.width; ++x) {
                if (x < 0 || y < 0 || x >= size.x || y >= size.y) {
                    ADD_FAILURE() << "a cell reaches out of the figure";
                    return count;
                }
                ++count[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
            }
    return count;
}

TEST(LayoutCells, SideAndSplitCoverEveryPixelOnce) {
    for (const Layout layout : {Layout::side, Layout::split})
        for (const ivec2 size : kSizes)
            for (int count = 1; count <= 9; ++count)
                for (const int covered : coverage(layoutCells(layout, count, size), size))
                    ASSERT_EQ(covered, 1);
    for (const int covered : coverage(layoutCells(Layout::single, 1, {97, 101}), {97, 101}))
        ASSERT_EQ(covered, 1);
}

TEST(LayoutCells, GridLeavesOnlyTheEndOfItsLastRowEmpty) {
    for (const ivec2 size : kSizes)
        for (int count = 1; count <= 10; ++count) {
            const std::vector<Cell> cells = layoutCells(Layout::grid, count, size);
            ASSERT_EQ(cells.size(), static_cast<std::size_t>(count));
            const std::vector<int> covered = coverage(cells, size);
            const Cell& last = cells.back();
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const bool afterTheLast = y >= last.y && x >= last.x + last.width;
                    ASSERT_EQ(covered[static_cast<std::size_t>(y * size.x + x)], afterTheLast ? 0 : 1);
                }
        }
}

TEST(LayoutCells, PicturesAreComparable) {
    for (const ivec2 size : kSizes)
        for (int count = 1; count <= 9; ++count) {
            for (const Layout layout : {Layout::side, Layout::grid}) {
                const std::vector<Cell> cells = layoutCells(layout, count, size);
                for (const Cell& cell : cells) {
                    EXPECT_EQ(cell.pictureSize, ivec2(cell.width, cell.height));
                    EXPECT_EQ(cell.cropX, 0);
                    EXPECT_LE(std::abs(cell.width - cells.front().width), 1);
                    EXPECT_LE(std::abs(cell.height - cells.front().height), 1);
                }
            }
            // Bands of one picture: each shows the columns where it stands.
            for (const Cell& cell : layoutCells(Layout::split, count, size)) {
                EXPECT_EQ(cell.pictureSize, size);
                EXPECT_EQ(cell.cropX, cell.x);
            }
        }
}

/// A picture whose colour tells column and row.
image::Image gradient(ivec2 size) {
    image::Image picture(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            picture.set(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 77, 255});
    return picture;
}

std::vector<Panel> panelsFor(const std::vector<Cell>& cells, const std::string& title = "", const Display& display = {},
                             StageKind kind = StageKind::radiance) {
    std::vector<Panel> panels;
    for (const Cell& cell : cells)
        panels.push_back({gradient(cell.pictureSize), title, kind, display});
    return panels;
}

TEST(ComposeFigure, SplitBandsJoinToOnePicture) {
    const ivec2 size{200, 40};
    const std::vector<Cell> cells = layoutCells(Layout::split, 3, size);
    const Figure figure = composeFigure(cells, panelsFor(cells), size, nullptr);
    const image::Image expected = gradient(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const bool divider =
                std::ranges::any_of(cells, [&](const Cell& c) { return c.x > 0 && std::abs(2 * x + 1 - 2 * c.x) < 2; });
            if (divider) continue;
            ASSERT_EQ(figure.picture.at(x, y), expected.at(x, y)) << x << ' ' << y;
        }
    EXPECT_TRUE(figure.notes.empty());
}

TEST(ComposeFigure, AStageOfItsOwnSizeIsCentred) {
    const ivec2 size{100, 60};
    const std::vector<Cell> cells = layoutCells(Layout::single, 1, size);
    const Figure figure = composeFigure(cells, {{gradient({40, 20}), "", StageKind::radiance, {}}}, size, nullptr);
    EXPECT_EQ(figure.picture.at(30, 20), gradient({40, 20}).at(0, 0));
    EXPECT_EQ(figure.picture.at(69, 39), gradient({40, 20}).at(39, 19));
    EXPECT_NE(figure.picture.at(29, 20).b, 77);
}

const Display kKey = {.unit = "",
                      .key = {{{0, 1, 0}, "d = z: equal, lit"},
                              {{1, 0, 0}, "d < z: something is nearer, in shadow"},
                              {{0, 0, 1}, "not asked"}}};
const Display kBar = {.minimum = 1.69, .maximum = 1234.5, .unit = "m from the light", .key = {}};

/// Share of a cell's pixels that are not its panel's picture any more.
double changedShare(const Figure& figure, const Cell& cell) {
    const image::Image picture = gradient(cell.pictureSize);
    int changed = 0;
    for (int y = 2; y < cell.height - 2; ++y) // dividers aside
        for (int x = 2; x < cell.width - 2; ++x)
            changed += figure.picture.at(cell.x + x, cell.y + y) != picture.at(x + cell.cropX, y);
    return static_cast<double>(changed) / (cell.width * cell.height);
}

TEST(ComposeFigure, LabelsLeaveMostOfEveryCellVisible) {
    for (const ivec2 size :
         {ivec2(1280, 720), ivec2(640, 360), ivec2(320, 240), ivec2(200, 150), ivec2(64, 48), ivec2(16, 16)})
        for (const Layout layout : {Layout::side, Layout::split, Layout::grid})
            for (int count = 2; count <= 4; ++count)
                for (const auto& [display, kind] :
                     {std::pair{kKey, StageKind::swatches}, std::pair{kBar, StageKind::scalar}}) {
                    const std::vector<Cell> cells = layoutCells(layout, count, size);
                    const Figure figure =
                        composeFigure(cells, panelsFor(cells, "Shadow volume (z-fail)", display, kind), size, &font());
                    for (const Cell& cell : cells)
                        EXPECT_LE(changedShare(figure, cell), 2.0 / 3) << size.x << 'x' << size.y;
                    if (size.x >= 640 && count == 2) {
                        EXPECT_TRUE(figure.notes.empty()) << size.x << ' ' << figure.notes.front();
                    }
                    if (size.x <= 64) {
                        EXPECT_EQ(figure.notes.size(), 2u) << size.x;
                    }
                }
}

TEST(ComposeFigure, WhatIsLeftOutIsSaid) {
    const ivec2 size{40, 30};
    const std::vector<Cell> cells = layoutCells(Layout::single, 1, size);
    const Figure figure =
        composeFigure(cells, panelsFor(cells, "Shadow map", kKey, StageKind::swatches), size, &font());
    ASSERT_EQ(figure.notes.size(), 2u);
    EXPECT_NE(figure.notes[0].find("titles"), std::string::npos);
    EXPECT_NE(figure.notes[1].find("legends"), std::string::npos);
    EXPECT_EQ(figure.picture, gradient(size));
}

TEST(ComposeFigure, ASmallSinglePictureKeepsItsLegend) {
    const ivec2 size{200, 150};
    const std::vector<Cell> cells = layoutCells(Layout::single, 1, size);
    const Display twoSides = {.unit = "", .key = {{{1, 1, 0}, "faces the light"}, {{0, 0, 1}, "faces away"}}};
    const Figure figure = composeFigure(cells, panelsFor(cells, "", twoSides, StageKind::swatches), size, &font());
    EXPECT_TRUE(figure.notes.empty());
    EXPECT_GT(changedShare(figure, cells.front()), 0.02);
    EXPECT_LT(changedShare(figure, cells.front()), 0.34);
}

TEST(ComposeFigure, LabelsStayInTheirCells) {
    // The middle cell has labels; its neighbours must be as if it had none.
    const ivec2 size{900, 300};
    const std::vector<Cell> cells = layoutCells(Layout::side, 3, size);
    std::vector<Panel> panels = panelsFor(cells);
    panels[1] = {panels[1].picture, "Shadow volume (z-fail), a long title to wrap", StageKind::scalar, kBar};
    const Figure figure = composeFigure(cells, panels, size, &font());
    EXPECT_GT(changedShare(figure, cells[1]), 0.02);
    EXPECT_EQ(changedShare(figure, cells[0]), 0);
    EXPECT_EQ(changedShare(figure, cells[2]), 0);
}

TEST(ComposeFigure, TypeIsReadableFromAfar) {
    // Rows of the plate of a one-line title: at least the height of type of 1/45 of the figure.
    for (const int height : {360, 720, 1080, 2160}) {
        const ivec2 size{height * 16 / 9, height};
        for (const int count : {2, 3, 4}) {
            const std::vector<Cell> cells = layoutCells(Layout::side, count, size);
            const Figure figure = composeFigure(cells, panelsFor(cells, "Shadow map"), size, &font());
            ASSERT_TRUE(figure.notes.empty());
            int rows = 0;
            while (rows < height && figure.picture.at(3, rows) != gradient(cells[0].pictureSize).at(3, rows))
                ++rows;
            EXPECT_GE(rows, font().measure("X", height / 45.0).height) << height;
        }
    }
}

TEST(Labels, BarAndKeyAreAsWideAsTheyMust) {
    const Panel bar{{}, "", StageKind::scalar, kBar};
    const Plate plate = legendPlate(bar, font(), 20, 400);
    EXPECT_LE(plate.width, 400);
    EXPECT_GE(plate.width, font().measure("m from the light", 20).width);
    EXPECT_EQ(plate.lines, 2);
    const Panel key{{}, "", StageKind::swatches, kKey};
    EXPECT_EQ(legendPlate(key, font(), 20, 1000).lines, 3);
    EXPECT_GT(legendPlate(key, font(), 20, 200).lines, 3);
    EXPECT_TRUE(legendPlate({{}, "", StageKind::visibility, {}}, font(), 20, 200).isEmpty());
    EXPECT_TRUE(titlePlate("", font(), 20, 200).isEmpty());
}

} // namespace
} // namespace shadowlab::picture
