// SPDX-License-Identifier: MIT
#include "app/window/panels/legend.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/picture/labels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

constexpr float kSmallest = 0.72f; ///< of the text's size: what the last row still reads in presenter mode
constexpr float kBarEm = 11;       ///< length of a bar
constexpr int kBarSteps = 64; ///< colours of a bar: finer than the eye can distinguish

float textWidth(const Theme& theme, float em, const std::string& text) {
    return theme.text->CalcTextSizeA(em, FLT_MAX, 0, text.c_str()).x;
}

/// The unit, the least number, the colours from it to the greatest, and that.
void drawBar(ImDrawList& list, const lab::PanePicture& picture, const Area& band, const Theme& theme) {
    const Display& display = picture.display;
    const std::string low = picture::shortNumber(display.minimum), high = picture::shortNumber(display.maximum);
    const float room = static_cast<float>(band.size.x) - theme.em;
    const auto wantedWidth = [&](float em) {
        return textWidth(theme, em, display.unit) + textWidth(theme, em, low + high) + (kBarEm + 2) * em;
    };
    const float em = std::round(theme.em * std::clamp(room / wantedWidth(theme.em), kSmallest, 1.0f));
    const float pad = em * 0.5f, height = em * 0.8f;
    float x = static_cast<float>(band.corner.x) + pad;
    const float textY = static_cast<float>(band.corner.y) + (static_cast<float>(band.size.y) - em) / 2 - em * 0.1f,
                barY = static_cast<float>(band.corner.y) + (static_cast<float>(band.size.y) - height) / 2;
    const auto text = [&](const std::string& words) {
        if (words.empty()) return;
        list.AddText(theme.text, em, {x, textY}, kPlateText, words.c_str());
        x += textWidth(theme, em, words) + pad;
    };
    text(display.unit);
    text(low);
    const float width = std::max(2 * em, std::min(kBarEm * em, static_cast<float>(band.corner.x) + room - x - textWidth(theme, em, high)));
    const look::Palette& palette = picture.kind == StageKind::count ? look::diverging() : look::viridis();
    for (int i = 0; i < kBarSteps; ++i)
        list.AddRectFilled({x + static_cast<float>(i) * width / kBarSteps, barY},
                           {x + static_cast<float>(i + 1) * width / kBarSteps, barY + height},
                           shownColor(look::colorAt(palette, (i + 0.5) / kBarSteps)));
    if (picture.kind == StageKind::count && display.minimum < 0 && display.maximum > 0) {
        const auto share = static_cast<float>(-display.minimum / (display.maximum - display.minimum));
        const float zero = x + share * width; // its colour is light
        list.AddText(theme.text, em, {zero - textWidth(theme, em, "0") / 2, textY}, IM_COL32(16, 16, 18, 255), "0");
    }
    x += width + pad;
    text(high);
}

/// Words of a key, with the swatch they explain; a label's further lines have none.
struct KeyItem {
    std::string words;
    const KeyEntry* swatch = nullptr;
};

std::vector<KeyItem> itemsOf(const std::vector<KeyEntry>& key) {
    std::vector<KeyItem> items;
    for (const KeyEntry& entry : key) {
        std::istringstream lines(entry.label);
        const KeyEntry* swatch = &entry;
        for (std::string line; std::getline(lines, line); swatch = nullptr)
            items.push_back({line, swatch});
    }
    return items;
}

/// Swatches with their words, one after the other.
void drawKey(ImDrawList& list, const std::vector<KeyEntry>& key, const Area& band, const Theme& theme) {
    const float room = static_cast<float>(band.size.x) - theme.em;
    const std::vector<KeyItem> items = itemsOf(key);
    const auto itemWidth = [&](const KeyItem& item, float em) {
        return textWidth(theme, em, item.words) + (item.swatch ? 2.4f : 1.2f) * em;
    };
    float wanted = 0;
    for (const KeyItem& item : items)
        wanted += itemWidth(item, theme.em);
    const float em = std::round(theme.em * std::clamp(room / wanted, kSmallest, 1.0f));
    std::vector<std::vector<const KeyItem*>> lines(1);
    float used = 0;
    for (const KeyItem& item : items) {
        if (used > 0 && used + itemWidth(item, em) > room) {
            lines.emplace_back();
            used = 0;
        }
        lines.back().push_back(&item);
        used += itemWidth(item, em);
    }
    const float lineHeight = lines.size() == 1 ? static_cast<float>(band.size.y) : em * 1.25f;
    const float left = static_cast<float>(band.corner.x), bottom = static_cast<float>(band.corner.y + band.size.y);
    float y = bottom - lineHeight * static_cast<float>(lines.size());
    if (lines.size() > 1)
        list.AddRectFilled({left, y}, {left + static_cast<float>(band.size.x), bottom}, kPlateColor);
    for (const auto& line : lines) {
        float x = left + em * 0.5f;
        const float swatch = em * 0.85f, top = y + (lineHeight - swatch) / 2;
        for (const KeyItem* item : line) {
            if (item->swatch)
                list.AddRectFilled({x, top}, {x + swatch, top + swatch}, shownColor(item->swatch->colorLinear));
            const float textX = item->swatch ? x + swatch + em * 0.4f : x;
            list.AddText(theme.text, em, {textX, y + (lineHeight - em) / 2 - em * 0.1f}, kPlateText, item->words.c_str());
            x += itemWidth(*item, em);
        }
        y += lineHeight;
    }
}

} // namespace

void drawLegend(ImDrawList& list, const lab::PanePicture& picture, const Area& band, const Theme& theme) {
    if (picture.kind == StageKind::scalar || picture.kind == StageKind::count)
        drawBar(list, picture, band, theme);
    else if (!picture.display.key.empty())
        drawKey(list, picture.display.key, band, theme);
}

} // namespace shadowlab::window
