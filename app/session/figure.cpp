// SPDX-License-Identifier: MIT
#include "app/session/figure.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "techniques/foundation/look.h"

namespace shadowlab::session {

namespace {

// Type no smaller than 1/45 of the figure's height is readable from the last row; these leave a reserve.
constexpr double kTitleShare = 1.0 / 30.0;
constexpr double kLegendShare = 1.0 / 38.0;
constexpr image::Color8 kText{245, 245, 245, 255};
constexpr image::Color8 kPlate{16, 16, 18, 255};
constexpr float kPlateCoverage = 0.78f;
constexpr int kDividerWidth = 2;

void plate(image::Image& figure, int x, int y, int width, int height) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) blendPixel(figure, column, row, kPlate, kPlateCoverage);
}

image::Color8 encoded(const vec3& linear) {
    return {image::srgbFromLinear(linear.r), image::srgbFromLinear(linear.g), image::srgbFromLinear(linear.b), 255};
}

/// At most three significant digits: legends are read from afar.
std::string shortNumber(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3);
    return error == std::errc{} ? std::string(buffer, end) : std::string();
}

void drawTitle(image::Image& figure, const Cell& cell, const std::string& title, const image::Font& font, int height) {
    const double em = std::max(9.0, height * kTitleShare);
    const int pad = static_cast<int>(em * 0.45);
    int y = cell.y;
    for (const std::string& line : font.wrap(title, em, cell.width - 2 * pad)) {
        const image::TextSize size = font.measure(line, em);
        plate(figure, cell.x, y, std::min(size.width + 2 * pad, cell.width), size.height + pad);
        font.draw(figure, cell.x + pad, y + pad / 2, line, em, kText);
        y += size.height + pad;
    }
}

/// A bar from minimum to maximum with its numbers and unit.
void drawBar(image::Image& figure, const Cell& cell, const Panel& panel, const image::Font& font, int height) {
    const double em = std::max(9.0, height * kLegendShare);
    const int pad = static_cast<int>(em * 0.5), barHeight = static_cast<int>(em * 0.7);
    const std::string low = shortNumber(panel.display.minimum), high = shortNumber(panel.display.maximum);
    const image::TextSize lowSize = font.measure(low, em), highSize = font.measure(high, em), unit = font.measure(panel.display.unit, em);
    const int barWidth = std::min(cell.width - 2 * pad, std::max({cell.width / 3, unit.width, lowSize.width + highSize.width + 3 * pad}));
    const int boxHeight = barHeight + 2 * lowSize.height + 3 * pad;
    const int x = cell.x + pad, y = cell.y + cell.height - boxHeight;
    plate(figure, cell.x, y, barWidth + 2 * pad, boxHeight);
    font.draw(figure, x, y + pad / 2, panel.display.unit, em, kText);
    const look::Palette& palette = panel.kind == StageKind::count ? look::diverging() : look::viridis();
    const int barY = y + lowSize.height + pad;
    for (int i = 0; i < barWidth; ++i)
        fillRect(figure, x + i, barY, 1, barHeight, encoded(look::colorAt(palette, (i + 0.5) / barWidth)));
    const int numbersY = barY + barHeight + pad / 2;
    font.draw(figure, x, numbersY, low, em, kText);
    font.draw(figure, x + barWidth - highSize.width, numbersY, high, em, kText);
    if (panel.kind == StageKind::count) {
        const image::TextSize zero = font.measure("0", em);
        font.draw(figure, x + (barWidth - zero.width) / 2, numbersY, "0", em, kText);
    }
}

void drawKey(image::Image& figure, const Cell& cell, const Panel& panel, const image::Font& font, int height) {
    const double em = std::max(9.0, height * kLegendShare);
    const int pad = static_cast<int>(em * 0.5), swatch = static_cast<int>(em * 0.9);
    struct Line {
        const KeyEntry* entry; ///< null on the further lines of a wrapped label
        std::string text;
    };
    std::vector<Line> lines;
    int widest = 0, lineHeight = font.measure("X", em).height;
    for (const KeyEntry& entry : panel.display.key)
        for (const std::string& text : font.wrap(entry.label, em, cell.width - swatch - 4 * pad)) {
            const bool first = lines.empty() || lines.back().entry != &entry;
            lines.push_back({first ? &entry : nullptr, text});
            if (!first) lines.back().entry = nullptr;
            widest = std::max(widest, font.measure(text, em).width);
        }
    const int boxHeight = static_cast<int>(lines.size()) * lineHeight + 2 * pad;
    int y = cell.y + cell.height - boxHeight;
    plate(figure, cell.x, y, widest + swatch + 3 * pad, boxHeight);
    y += pad;
    for (const Line& line : lines) {
        if (line.entry)
            fillRect(figure, cell.x + pad, y + (lineHeight - swatch) / 2, swatch, swatch, encoded(line.entry->colorLinear));
        font.draw(figure, cell.x + swatch + 2 * pad, y, line.text, em, kText);
        y += lineHeight;
    }
}

} // namespace

std::vector<Cell> layoutCells(Layout layout, int count, ivec2 size) {
    std::vector<Cell> cells;
    const int columns = layout == Layout::grid ? static_cast<int>(std::ceil(std::sqrt(count))) : count;
    const int rows = (count + columns - 1) / columns;
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        const int left = size.x * column / columns, right = size.x * (column + 1) / columns;
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
    return panel.kind == StageKind::scalar || panel.kind == StageKind::count || !panel.display.key.empty();
}

image::Image composeFigure(const std::vector<Cell>& cells, const std::vector<Panel>& panels, ivec2 size,
                           const image::Font* font) {
    image::Image figure(size.x, size.y, {12, 12, 14, 255});
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Cell& cell = cells[i];
        const image::Image& picture = panels[i].picture;
        // A stage with a size of its own is centred in its cell; a picture of the target's size fills it.
        const bool ownSize = picture.width != cell.pictureSize.x || picture.height != cell.pictureSize.y;
        const int offsetX = ownSize ? (cell.width - picture.width) / 2 : -cell.cropX;
        const int offsetY = ownSize ? (cell.height - picture.height) / 2 : 0;
        for (int y = 0; y < cell.height; ++y)
            for (int x = 0; x < cell.width; ++x)
                if (picture.contains(x - offsetX, y - offsetY))
                    figure.set(cell.x + x, cell.y + y, picture.at(x - offsetX, y - offsetY));
        if (cell.x > 0) fillRect(figure, cell.x - kDividerWidth / 2, cell.y, kDividerWidth, cell.height, kText);
    }
    if (!font) return figure;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!panels[i].title.empty()) drawTitle(figure, cells[i], panels[i].title, *font, size.y);
        if (panels[i].kind == StageKind::scalar || panels[i].kind == StageKind::count)
            drawBar(figure, cells[i], panels[i], *font, size.y);
        else if (!panels[i].display.key.empty())
            drawKey(figure, cells[i], panels[i], *font, size.y);
    }
    return figure;
}

} // namespace shadowlab::session
