// SPDX-License-Identifier: MIT
#include "app/picture/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/picture/labels.h"

namespace shadowlab::picture {

namespace {

// Type sizes as shares of the figure's height, the first that fits is taken. 1/45 is readable from the last row of a
// lecture hall; less is not.
constexpr std::array kTitleShares = {1.0 / 30, 1.0 / 37, 1.0 / 45};
constexpr std::array kLegendShares = {1.0 / 38, 1.0 / 45};
constexpr double kSmallestType = 10;      ///< pixels; below, letters dissolve
constexpr double kLargestShare = 1.0 / 3; ///< of a cell that a plate may cover
constexpr image::Color8 kDark{16, 16, 18, 255}, kLight{245, 245, 245, 255};

void drawPicture(image::Image& figure, const Cell& cell, const image::Image& picture) {
    // A stage of a size of its own is centred; a picture of the cell's size fills it.
    const int offsetX = (cell.pictureSize.x - picture.width) / 2 - cell.cropX;
    const int offsetY = (cell.pictureSize.y - picture.height) / 2;
    for (int y = 0; y < cell.height; ++y)
        for (int x = 0; x < cell.width; ++x)
            if (picture.contains(x - offsetX, y - offsetY))
                figure.set(cell.x + x, cell.y + y, picture.at(x - offsetX, y - offsetY));
}

/// A dark line and a light one: one of them is seen on any picture.
void drawDividers(image::Image& figure, const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
        if (cell.x > 0) {
            fillRect(figure, cell.x - 1, cell.y, 1, cell.height, kDark);
            fillRect(figure, cell.x, cell.y, 1, cell.height, kLight);
        }
        if (cell.y > 0) {
            fillRect(figure, cell.x, cell.y - 1, cell.width, 1, kDark);
            fillRect(figure, cell.x, cell.y, cell.width, 1, kLight);
        }
    }
}

bool coversLittle(const Plate& plate, const Cell& cell) {
    return plate.width <= cell.width && plate.height <= cell.height &&
           plate.width * plate.height <= kLargestShare * cell.width * cell.height;
}

/// The plates of all cells in one type size: the largest in which every plate fits and needs no more lines than in the
/// smallest. Empty plates when even the smallest does not fit.
template <typename MakePlate, typename Fits>
std::vector<Plate> layOut(std::span<const double> shares, int figureHeight, const std::vector<Cell>& cells,
                          const MakePlate& plateOfCell, const Fits& fits) {
    std::vector<std::vector<Plate>> tries;
    for (const double share : shares) {
        std::vector<Plate>& plates = tries.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i)
            plates.push_back(plateOfCell(i, std::max(kSmallestType, figureHeight * share)));
    }
    const std::vector<Plate>& smallest = tries.back();
    for (const std::vector<Plate>& plates : tries) {
        bool good = true;
        for (std::size_t i = 0; i < cells.size(); ++i)
            good = good && fits(plates[i], cells[i]) && plates[i].lines <= smallest[i].lines;
        if (good) return plates;
    }
    return std::vector<Plate>(cells.size());
}

constexpr const char* kLeftOut = " would cover the pictures and are left out; choose a larger size to have them";

void drawTitles(Figure& figure, const std::vector<Plate>& titles, const std::vector<Cell>& cells,
                const std::vector<Panel>& panels) {
    bool isMissing = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        isMissing = isMissing || (titles[i].isEmpty() && !panels[i].title.empty());
        if (!titles[i].isEmpty()) drawPlate(figure.picture, titles[i], cells[i].x, cells[i].y);
    }
    if (isMissing) figure.notes.push_back(std::string("the titles") + kLeftOut);
}

} // namespace

std::vector<Cell> layoutCells(Layout layout, int count, ivec2 size, double splitShare) {
    std::vector<Cell> cells;
    if (layout == Layout::diff) count = 1;
    const int columns = layout == Layout::grid ? static_cast<int>(std::ceil(std::sqrt(count))) : count;
    const int rows = (count + columns - 1) / columns;
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        int left = size.x * column / columns, right = size.x * (column + 1) / columns;
        if (layout == Layout::split && count == 2) {
            const int line = static_cast<int>(std::lround(splitShare * size.x));
            left = i == 0 ? 0 : line;
            right = i == 0 ? line : size.x;
        }
        const int top = size.y * row / rows, bottom = size.y * (row + 1) / rows;
        Cell cell{left, top, right - left, bottom - top, {right - left, bottom - top}, 0};
        if (layout == Layout::split) {
            cell.pictureSize = size;
            cell.cropX = left;
        }
        cells.push_back(cell);
    }
    return cells;
}

bool hasLegend(const Panel& panel) {
    return hasScale(panel.kind) || !panel.display.key.empty();
}

Figure composeFigure(const std::vector<Cell>& cells, const std::vector<Panel>& panels, ivec2 size,
                     const image::Font* font) {
    Figure figure{image::Image(size.x, size.y, {12, 12, 14, 255}), {}};
    for (std::size_t i = 0; i < cells.size(); ++i)
        drawPicture(figure.picture, cells[i], panels[i].picture);
    drawDividers(figure.picture, cells);
    if (!font) return figure;

    const auto titles = layOut(
        kTitleShares, size.y, cells,
        [&](std::size_t i, double em) { return titlePlate(panels[i].title, *font, em, cells[i].width); }, coversLittle);
    drawTitles(figure, titles, cells, panels);
    const auto legends = layOut(
        kLegendShares, size.y, cells,
        [&](std::size_t i, double em) { return legendPlate(panels[i], *font, em, cells[i].width); }, coversLittle);
    bool isMissing = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        isMissing = isMissing || (legends[i].isEmpty() && hasLegend(panels[i]));
        if (!legends[i].isEmpty())
            drawPlate(figure.picture, legends[i], cells[i].x, cells[i].y + cells[i].height - legends[i].height);
    }
    if (isMissing) figure.notes.push_back(std::string("the legends") + kLeftOut);
    return figure;
}

} // namespace shadowlab::picture
