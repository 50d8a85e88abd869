// SPDX-License-Identifier: MIT
#include "app/picture/labels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

constexpr image::Color8 kLabelText{245, 245, 245, 255};
constexpr image::Color8 kPlate{16, 16, 18, 255};
constexpr float kPlateCoverage = 0.9f; ///< white text keeps a contrast above 6:1 even on a white picture

/// The unit above a bar from minimum to maximum, with the numbers at its ends below. Counts also mark their zero.
Plate barPlate(const Panel& panel, const image::Font& font, double em, int widest) {
    const int pad = static_cast<int>(em * 0.5), barHeight = static_cast<int>(em * 0.7);
    const Display& display = panel.display;
    const std::string low = shortNumber(display.minimum), high = shortNumber(display.maximum);
    const int lowWidth = font.measure(low, em).width, highWidth = font.measure(high, em).width;
    const int zeroWidth = font.measure("0", em).width, lineHeight = font.measure("0", em).height;
    const std::vector<std::string> unit = font.wrap(display.unit, em, widest - 2 * pad);
    const int unitLines = display.unit.empty() ? 0 : static_cast<int>(unit.size());
    int textWidth = lowWidth + zeroWidth + highWidth + 4 * pad;
    for (const std::string& line : unit)
        textWidth = std::max(textWidth, font.measure(line, em).width);
    const int barWidth = std::max(textWidth, std::min(widest - 2 * pad, static_cast<int>(14 * em)));

    Plate plate{barWidth + 2 * pad, (unitLines + 1) * lineHeight + barHeight + 2 * pad, unitLines + 1, {}};
    plate.drawText = [=, &font](image::Image& figure, int left, int top) {
        const int x = left + pad, barY = top + pad / 2 + unitLines * lineHeight + pad / 2,
                  numbersY = barY + barHeight + pad / 2;
        for (int i = 0; i < unitLines; ++i)
            font.draw(figure, x, top + pad / 2 + i * lineHeight, unit[static_cast<std::size_t>(i)], em, kLabelText);
        const look::Palette& palette = paletteOf(panel.kind);
        for (int i = 0; i < barWidth; ++i)
            fillRect(figure, x + i, barY, 1, barHeight, image::encoded(look::colorAt(palette, (i + 0.5) / barWidth)));
        font.draw(figure, x, numbersY, low, em, kLabelText);
        font.draw(figure, x + barWidth - highWidth, numbersY, high, em, kLabelText);
        const double zeroAt = -display.minimum / (display.maximum - display.minimum);
        const int zeroX = static_cast<int>(zeroAt * barWidth) - zeroWidth / 2;
        if (panel.kind == StageKind::count && zeroX > lowWidth + pad && zeroX + zeroWidth + pad < barWidth - highWidth)
            font.draw(figure, x + zeroX, numbersY, "0", em, kLabelText);
    };
    return plate;
}

/// A swatch and a label for every colour that has a meaning.
Plate keyPlate(const Panel& panel, const image::Font& font, double em, int widest) {
    struct Entry {
        int y; ///< of its first line, from the plate's upper edge
        std::vector<std::string> lines;
    };
    const int pad = static_cast<int>(em * 0.5), swatch = static_cast<int>(em * 0.9);
    const int lineHeight = font.measure("X", em).height;
    std::vector<Entry> entries;
    Plate plate;
    int y = pad;
    for (const KeyEntry& one : panel.display.key) {
        Entry entry{y, font.wrap(one.label, em, widest - swatch - 3 * pad)};
        for (const std::string& line : entry.lines)
            plate.width = std::max(plate.width, font.measure(line, em).width + swatch + 3 * pad);
        y += static_cast<int>(entry.lines.size()) * lineHeight;
        plate.lines += static_cast<int>(entry.lines.size());
        entries.push_back(std::move(entry));
    }
    plate.height = y + pad;
    plate.drawText = [=, &font, &panel](image::Image& figure, int plateX, int plateY) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            const int x = plateX + pad, top = plateY + entries[i].y;
            fillRect(figure, x, top + (lineHeight - swatch) / 2, swatch, swatch,
                     image::encoded(panel.display.key[i].colorLinear));
            for (std::size_t line = 0; line < entries[i].lines.size(); ++line)
                font.draw(figure, x + swatch + pad, top + static_cast<int>(line) * lineHeight, entries[i].lines[line],
                          em, kLabelText);
        }
    };
    return plate;
}

} // namespace

std::string shortNumber(double value, int digits) {
    const bool whole = std::abs(value) >= 100 && std::abs(value) < 1e6; // 1234 and not 1.23e+03
    std::array<char, 32> buffer{};
    const auto [end, error] =
        whole ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::llround(value))
              : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return error == std::errc{} ? std::string(buffer.data(), end) : std::string();
}

Plate titlePlate(const std::string& title, const image::Font& font, double em, int widest) {
    if (title.empty()) return {};
    const int pad = static_cast<int>(em * 0.45), lineHeight = font.measure("X", em).height;
    const std::vector<std::string> lines = font.wrap(title, em, widest - 2 * pad);
    Plate plate{0, static_cast<int>(lines.size()) * lineHeight + pad, static_cast<int>(lines.size()), {}};
    for (const std::string& line : lines)
        plate.width = std::max(plate.width, font.measure(line, em).width + 2 * pad);
    plate.drawText = [=, &font](image::Image& figure, int left, int top) {
        for (std::size_t i = 0; i < lines.size(); ++i)
            font.draw(figure, left + pad, top + pad / 2 + static_cast<int>(i) * lineHeight, lines[i], em, kLabelText);
    };
    return plate;
}

Plate legendPlate(const Panel& panel, const image::Font& font, double em, int widest) {
    if (hasScale(panel.kind)) return barPlate(panel, font, em, widest);
    return panel.display.key.empty() ? Plate{} : keyPlate(panel, font, em, widest);
}

void drawPlate(image::Image& figure, const Plate& plate, int x, int y) {
    for (int row = y; row < y + plate.height; ++row)
        for (int column = x; column < x + plate.width; ++column)
            blendPixel(figure, column, row, kPlate, kPlateCoverage);
    plate.drawText(figure, x, y);
}

} // namespace shadowlab::picture
