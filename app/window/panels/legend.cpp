// SPDX-License-Identifier: MIT
#include "app/window/panels/legend.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/picture/labels.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

constexpr float kBarEm = 11, kShortestBarEm = 4; ///< length of a bar
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
        return textWidth(theme, em, display.unit) + textWidth(theme, em, low + high) + (kShortestBarEm + 2) * em;
    };
    const float em = std::round(theme.em * std::clamp(room / wantedWidth(theme.em), kSmallestType, 1.0f));
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
    const look::Palette& palette = picture::paletteOf(picture.kind);
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

float itemWidth(const KeyItem& item, float em, const Theme& theme) {
    return textWidth(theme, em, item.words) + (item.swatch ? 2.4f : 1.2f) * em;
}

/// The items, line by line.
using KeyLines = std::vector<std::vector<const KeyItem*>>;

KeyLines brokenLines(const std::vector<KeyItem>& items, float em, float room, const Theme& theme) {
    KeyLines lines(1);
    float used = 0;
    for (const KeyItem& item : items) {
        const float width = itemWidth(item, em, theme);
        if (used > 0 && used + width > room) {
            lines.emplace_back();
            used = 0;
        }
        lines.back().push_back(&item);
        used += width;
    }
    return lines;
}

/// Without what is said in brackets: "false lit (should be in shadow): 51 px" is "false lit: 51 px".
std::string withoutBrackets(std::string words) {
    const std::size_t begin = words.find(" ("), end = words.find(')', begin == std::string::npos ? 0 : begin);
    return begin == std::string::npos || end == std::string::npos ? words : words.erase(begin, end + 1 - begin);
}

/// With items that are wider than the room broken at blanks: what goes on in the next line has no swatch.
std::vector<KeyItem> wrappedItems(const std::vector<KeyItem>& items, float em, float room, const Theme& theme) {
    std::vector<KeyItem> wrapped;
    for (KeyItem item : items) {
        while (itemWidth(item, em, theme) > room) {
            std::size_t end = item.words.rfind(' ');
            const auto begins = [&] { return KeyItem{item.words.substr(0, end), item.swatch}; };
            while (end != std::string::npos && end > 0 && itemWidth(begins(), em, theme) > room)
                end = item.words.rfind(' ', end - 1);
            if (end == std::string::npos || end == 0) break; // one long word
            wrapped.push_back(begins());
            item = {item.words.substr(end + 1), nullptr};
        }
        wrapped.push_back(std::move(item));
    }
    return wrapped;
}

/// A key in as many lines as there may be, and the type it is set in.
struct KeyLayout {
    float em = 0;
    std::vector<KeyItem> items;
    KeyLines lines; ///< of these items
};

/// Two lines are enough for most keys in few words; in more of them the words in brackets go. Then the type becomes smaller.
KeyLayout layKey(std::vector<KeyItem> items, int width, int most, const Theme& theme) {
    constexpr std::size_t kManyLines = 2;
    const float room = static_cast<float>(width) - theme.em * 0.5f;
    KeyLayout key;
    if (brokenLines(wrappedItems(items, theme.em, room, theme), theme.em, room, theme).size() > kManyLines)
        for (KeyItem& item : items)
            item.words = withoutBrackets(item.words);
    for (float share = 1; share >= kSmallestType; share -= kTypeStep) {
        key.em = std::round(theme.em * share);
        key.items = wrappedItems(items, key.em, room, theme);
        key.lines = brokenLines(key.items, key.em, room, theme);
        if (static_cast<int>(key.lines.size()) <= most) break;
    }
    return key;
}

/// Swatches with their words, one after the other.
void drawKey(ImDrawList& list, const std::vector<KeyEntry>& entries, const Area& band, const Theme& theme) {
    const int most = std::max(1, static_cast<int>(static_cast<float>(band.size.y) / (kLegendLineEm * theme.em)));
    const auto [em, items, lines] = layKey(itemsOf(entries), band.size.x, most, theme);
    const auto height = static_cast<float>(band.size.y), left = static_cast<float>(band.corner.x);
    const float lineHeight = lines.size() == 1 ? height : std::min(em * kLegendLineEm, height / static_cast<float>(lines.size()));
    float y = static_cast<float>(band.corner.y) + (height - lineHeight * static_cast<float>(lines.size())) / 2;
    for (const auto& line : lines) {
        float x = left + em * 0.5f;
        const float swatch = em * 0.85f, top = y + (lineHeight - swatch) / 2;
        for (const KeyItem* item : line) {
            if (item->swatch)
                list.AddRectFilled({x, top}, {x + swatch, top + swatch}, shownColor(item->swatch->colorLinear));
            const float textX = item->swatch ? x + swatch + em * 0.4f : x;
            list.AddText(theme.text, em, {textX, y + (lineHeight - em) / 2 - em * 0.1f}, kPlateText, item->words.c_str());
            x += itemWidth(*item, em, theme);
        }
        y += lineHeight;
    }
}

} // namespace

int legendLines(const lab::PanePicture& picture, int width, int most, const Theme& theme) {
    if (picture::hasScale(picture.kind)) return 1;
    if (picture.display.key.empty()) return 0;
    return std::min(most, static_cast<int>(layKey(itemsOf(picture.display.key), width, most, theme).lines.size()));
}

void drawLegend(ImDrawList& list, const lab::PanePicture& picture, const Area& band, const Theme& theme) {
    if (band.size.y < 1) return;
    if (picture::hasScale(picture.kind))
        drawBar(list, picture, band, theme);
    else if (!picture.display.key.empty())
        drawKey(list, picture.display.key, band, theme);
}

} // namespace shadowlab::window
