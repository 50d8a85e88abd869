// SPDX-License-Identifier: MIT
#include "app/picture/stages/scanline_plot.h"

#include <algorithm>
#include <cmath>

#include "app/picture/labels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::picture {

namespace {

using judge::Verdict;
using trace::Visibility;

constexpr image::Color8 kPlotGround{16, 16, 18, 255}, kText{245, 245, 245, 255}, kGrid{90, 90, 96, 255};
const vec3 kTruthArea = look::linearFromSrgb8(0x8A, 0x8A, 0x90);
const vec3 kCurve = look::linearFromSrgb8(0xF0, 0xE4, 0x42);

/// Columns and rows that are shown.
struct Window {
    int left, right, top, bottom;
    Window(const Region& region, ivec2 size) : left(0), right(size.x), top(0), bottom(size.y) {
        if (region.size.x <= 0 || region.size.y <= 0) return;
        left = region.corner.x, right = std::min(size.x, left + region.size.x);
        top = region.corner.y, bottom = std::min(size.y, top + region.size.y);
    }
};

bool isPlottedWrong(Verdict verdict) { return verdict == Verdict::falseLit || verdict == Verdict::falseShadow; }

/// Where the curve is drawn, in the picture's pixels.
struct Plot {
    Window window;
    int top, height, line; ///< of the area from visibility 1 down to 0; thickness of the curve
    [[nodiscard]] int rowOf(double visibility) const {
        return top + static_cast<int>(std::lround((1.0 - visibility) * (height - 1)));
    }
};

/// A thin frame above and below the row, so that its own pixels stay as they are.
void markRow(image::Image& picture, int row, const Window& window) {
    for (const int y : {row - 2, row + 2})
        fillRect(picture, window.left, y, window.right - window.left, 1, image::encoded(kCurve));
}

void drawGround(image::Image& picture, const Plot& plot, int margin) {
    constexpr float kCoverage = 0.92f; // the picture shows through a little: one sees that it goes on
    for (int y = plot.top - margin; y < plot.top + plot.height + margin / 2; ++y)
        for (int x = plot.window.left; x < plot.window.right; ++x)
            blendPixel(picture, x, y, kPlotGround, kCoverage);
    for (const double value : {0.0, 0.5, 1.0})
        fillRect(picture, plot.window.left, plot.rowOf(value), plot.window.right - plot.window.left, 1, kGrid);
}

void drawCurves(image::Image& picture, const Plot& plot, const Scanline& scanline, int row) {
    const judge::Truth& truth = scanline.truth;
    int before = -1;
    for (int x = plot.window.left; x < plot.window.right; ++x) {
        const std::size_t i = truth.index(x, row);
        const int share = plot.rowOf(truth.share(i)), bottom = plot.top + plot.height;
        const bool seen = truth.share(i) > 0;
        if (seen) fillRect(picture, x, share, 1, bottom - share, image::encoded(kTruthArea));
        const Verdict verdict = scanline.judgement.verdicts[i];
        if (isPlottedWrong(verdict))
            fillRect(picture, x, plot.top, 1, plot.height,
                     image::encoded(verdict == Verdict::falseLit ? look::kFalseLit : look::kFalseShadow));
        // Of a share between none and all, its top stays to be seen.
        if (seen && share > plot.top) fillRect(picture, x, share, 1, plot.line, image::encoded(kTruthArea));
        if (verdict == Verdict::tie)
            fillRect(picture, x, plot.top, 1, plot.height, image::encoded(look::kTieOnPicture));
        if (scanline.visibility.alpha(x, row) != 255) {
            before = -1;
            continue;
        }
        const int here = plot.rowOf(scanline.visibility.grey(x, row) / 255.0);
        const int from = before < 0 ? here : std::min(before, here), to = before < 0 ? here : std::max(before, here);
        fillRect(picture, x, from - plot.line / 2, 1, to - from + plot.line, image::encoded(kCurve));
        before = here;
    }
}

void drawNumbers(image::Image& picture, const Plot& plot, const Scanline& scanline, int row, const image::Font& font,
                 double em) {
    const int x = plot.window.left + static_cast<int>(em / 2), lineHeight = font.measure("0", em).height;
    const std::string title = "visibility of '" + scanline.light + "' along row " + std::to_string(row);
    font.draw(picture, x, plot.top - lineHeight - static_cast<int>(em * 0.3), title, em, kText);
    const auto number = [&](const char* text, int y) {
        const image::TextSize size = font.measure(text, em);
        for (int py = y; py < y + size.height; ++py)
            for (int px = x - 3; px < x + size.width + 3; ++px)
                blendPixel(picture, px, py, kPlotGround, 0.9f);
        font.draw(picture, x, y, text, em, kText);
    };
    number("1", plot.top + 2);
    number("0", plot.top + plot.height - lineHeight - 2);
}

} // namespace

int mostTellingRow(const Scanline& scanline, const Region& region) {
    const judge::Truth& truth = scanline.truth;
    const Window window(region, truth.size);
    int best = window.top, mostWrong = 0, mostChanges = 0;
    for (int y = window.top; y < window.bottom; ++y) {
        int wrong = 0, changes = 0;
        for (int x = window.left; x < window.right; ++x) {
            const std::size_t i = truth.index(x, y);
            wrong += isPlottedWrong(scanline.judgement.verdicts[i]);
            if (x == window.left) continue;
            const Visibility here = truth.visibility[i], before = truth.visibility[i - 1];
            changes += here != before && here >= Visibility::shadowed && before >= Visibility::shadowed;
        }
        if (wrong < mostWrong || (wrong == mostWrong && changes <= mostChanges)) continue;
        mostWrong = wrong, mostChanges = changes;
        best = y;
    }
    return best;
}

Panel scanlinePanel(image::Image picture, const Scanline& scanline, std::optional<int> row, const Region& region,
                    const image::Font* font) {
    const Window window(region, scanline.truth.size);
    const int y = row.value_or(mostTellingRow(scanline, region));
    const int height = window.bottom - window.top;
    const double em = std::max(10.0, height / 38.0); // as legends are: readable from the last row
    const int margin = font ? font->measure("X", em).height + static_cast<int>(em * 0.6) : 4;
    // In the half in which the row is not; above, a title may need some room, and below, the legend.
    const int plotHeight = height / 4;
    const bool above = y - window.top > height / 2;
    const Plot plot{window, above ? window.top + height / 12 + margin : window.bottom - height / 3 - plotHeight / 2,
                    plotHeight, std::max(2, height / 360)};
    markRow(picture, y, window);
    drawGround(picture, plot, margin);
    drawCurves(picture, plot, scanline, y);
    if (font) drawNumbers(picture, plot, scanline, y, *font, em);
    Display display;
    display.key = {{kTruthArea, "truth"},
                   {kCurve, scanline.technique},
                   {look::kFalseLit, "false lit"},
                   {look::kFalseShadow, "false shadow"},
                   {look::kTieOnPicture, "tie"}};
    return {std::move(picture), "", StageKind::swatches, std::move(display)};
}

} // namespace shadowlab::picture
