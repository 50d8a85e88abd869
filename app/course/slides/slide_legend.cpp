// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_legend.h"

#include <algorithm>
#include <regex>

#include "app/drawing/prose.h"
#include "app/picture/labels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::course {

namespace {

constexpr double kLegendType = kLeastType, kLegendRow = 1.25 * kLegendType;
constexpr double kSwatch = 22, kSwatchGap = 10, kColumnGap = 28;
constexpr int kMostKeyColumns = 3;
constexpr double kWidestBar = 460, kBarShare = 0.6, kBarThickness = 20; ///< kBarShare: of the width
constexpr int kBarSteps = 128;                                          ///< of colour: no step is seen
constexpr double kAbove = 10; ///< between a picture and its legend
constexpr const char *kLegendInk = "#1a1a1a", *kSwatchEdge = "#5a5a5a";

drawing::TextStyle legendStyle(drawing::Anchor anchor = drawing::Anchor::start) {
    return {.size = kLegendType, .anchor = anchor, .color = kLegendInk, .hasRim = false};
}

double barWidth(double width) { return std::min(kWidestBar, kBarShare * width); }

std::vector<std::string> unitLines(const picture::Panel& panel, double width, const Fonts& fonts) {
    if (panel.display.unit.empty()) return {};
    return fonts.upright.wrap(panel.display.unit, kLegendType, static_cast<int>(width - barWidth(width) - kSwatchGap));
}

/// Lines of a legend's text. Names of scenes may have any letters: they are prose only where there is a formula.
std::vector<drawing::ProseLine> legendLines(const std::string& label, double width, const Fonts& fonts) {
    const std::string prose = legendProse(label);
    if (prose != label) return drawing::wrapProse(prose, kLegendType, width, false, fonts.formula());
    std::vector<drawing::ProseLine> lines;
    for (const std::string& line : fonts.upright.wrap(label, kLegendType, static_cast<int>(width)))
        lines.push_back({{{line, false}}});
    return lines;
}

/// The key's entries, each broken into lines, and where they stand: down one column after the other.
struct KeyLayout {
    struct Entry {
        dvec2 corner;
        std::vector<drawing::ProseLine> lines;
    };
    std::vector<Entry> entries;
    double height = 0;
};
KeyLayout keyLayout(const picture::Panel& panel, double width, const Fonts& fonts, std::size_t columns) {
    const std::vector<KeyEntry>& key = panel.display.key;
    const double column = (width + kColumnGap) / static_cast<double>(columns) - kColumnGap;
    const std::size_t perColumn = (key.size() + columns - 1) / columns;
    KeyLayout layout;
    double y = 0;
    for (std::size_t i = 0; i < key.size(); ++i) {
        if (i % perColumn == 0) y = 0;
        const double x = static_cast<double>(i / perColumn) * (column + kColumnGap);
        layout.entries.push_back({{x, y},
                                  legendLines(key[i].label, column - kSwatch - kSwatchGap, fonts)});
        y += kLegendRow * static_cast<double>(layout.entries.back().lines.size());
        layout.height = std::max(layout.height, y);
    }
    return layout;
}

/// In as many columns as make it lowest.
KeyLayout lowestKey(const picture::Panel& panel, double width, const Fonts& fonts) {
    KeyLayout lowest = keyLayout(panel, width, fonts, 1);
    for (std::size_t columns = 2; columns <= kMostKeyColumns && columns <= panel.display.key.size(); ++columns)
        if (KeyLayout layout = keyLayout(panel, width, fonts, columns); layout.height < lowest.height) lowest = std::move(layout);
    return lowest;
}

/// A bar from the least value to the greatest with the unit beside it, and the numbers below.
void drawBar(drawing::Drawing& drawing, const picture::Panel& panel, dvec2 corner, double width, const Fonts& fonts) {
    const look::Palette& palette = picture::paletteOf(panel.kind);
    const double length = barWidth(width);
    for (int i = 0; i < kBarSteps; ++i) { // each from its left end to the bar's: no seam between them
        const double from = length * i / kBarSteps;
        drawing.rectangle(corner + dvec2(from, 0), {length - from, kBarThickness},
                          drawing::colorText(look::colorAt(palette, static_cast<float>((i + 0.5) / kBarSteps))), {"", 0, false});
    }
    drawing.rectangle(corner, {length, kBarThickness}, "", {kSwatchEdge, 1.5, false});
    double foot = corner.y + kBarThickness - 1;
    for (const std::string& line : unitLines(panel, width, fonts)) {
        drawing.text({corner.x + length + kSwatchGap, foot}, line, legendStyle());
        foot += kLegendRow;
    }
    const double below = corner.y + kBarThickness + kLegendType;
    const double least = panel.display.minimum, greatest = panel.display.maximum;
    drawing.text({corner.x, below}, picture::shortNumber(least), legendStyle());
    drawing.text({corner.x + length, below}, picture::shortNumber(greatest), legendStyle(drawing::Anchor::end));
    if (panel.kind == StageKind::count && least < 0 && greatest > 0) {
        const double zero = corner.x - least / (greatest - least) * length;
        drawing.line({zero, corner.y}, {zero, corner.y + kBarThickness + 4}, {kSwatchEdge, 2, false});
        drawing.text({zero, below}, "0", legendStyle(drawing::Anchor::middle));
    }
}

} // namespace

std::string legendProse(const std::string& label) {
    static const std::regex condition("^([A-Za-z\u00b7_]{1,8}) ([=<>]|\u2264) ([A-Za-z0-9]{1,4})(?=:|$)");
    std::smatch parts;
    if (!std::regex_search(label, parts, condition)) return label;
    std::string left = std::regex_replace(parts[1].str(), std::regex("_([A-Za-z]+)"), "_{$1}");
    left = std::regex_replace(left, std::regex("([A-Z])\u00b7([A-Z])"), "\\mathbf{$1} \\cdot \\mathbf{$2}");
    const std::string relation = parts[2] == "\u2264" ? "\\le" : parts[2].str();
    return "$" + left + " " + relation + " " + parts[3].str() + "$" + parts.suffix().str();
}

double legendHeight(const picture::Panel& panel, double width, const Fonts& fonts) {
    if (picture::hasScale(panel.kind)) {
        const auto lines = static_cast<double>(unitLines(panel, width, fonts).size());
        return kAbove + std::max(kBarThickness + 1.2 * kLegendType, lines * kLegendRow);
    }
    return panel.display.key.empty() ? 0 : kAbove + lowestKey(panel, width, fonts).height;
}

void drawLegendBelow(drawing::Drawing& drawing, const picture::Panel& panel, dvec2 corner, double width, const Fonts& fonts) {
    corner.y += kAbove;
    if (picture::hasScale(panel.kind)) {
        drawBar(drawing, panel, corner, width, fonts);
        return;
    }
    const KeyLayout key = lowestKey(panel, width, fonts);
    for (std::size_t i = 0; i < key.entries.size(); ++i) {
        const dvec2 at = corner + key.entries[i].corner;
        drawing.rectangle(at + dvec2(0, 4), dvec2(kSwatch), drawing::colorText(panel.display.key[i].colorLinear),
                          {kSwatchEdge, 1.5, false});
        double foot = at.y + kLegendType - 1;
        for (const drawing::ProseLine& line : key.entries[i].lines) {
            drawing::drawProse(drawing, {at.x + kSwatch + kSwatchGap, foot}, line, legendStyle(), fonts.formula());
            foot += kLegendRow;
        }
    }
}

} // namespace shadowlab::course
