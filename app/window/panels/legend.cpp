// SPDX-License-Identifier: MIT
#include "app/window/panels/legend.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "techniques/foundation/base/look.h"

namespace shadowlab::window {

namespace {

constexpr float kLargestShare = 0.5f; ///< of the area that a legend may cover
// In panes lower than this the type is a little smaller: less of the picture is covered, and it can still be read.
constexpr float kLowPaneEm = 26, kSmaller = 0.82f;
constexpr int kBarSteps = 64; ///< colours of a bar: finer than the eye can distinguish

std::string shortNumber(double value) {
    char text[32];
    const bool isWhole = std::abs(value) >= 100 && std::abs(value) < 1e6;
    const auto [end, error] = isWhole ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 0)
                                      : std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3);
    return error == std::errc{} ? std::string(text, end) : "?";
}

struct Plate {
    ImDrawList& list;
    ImVec2 corner; ///< upper left, in pixels of the window
    ImVec2 size;
    float pad;
    void draw() const { list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, kPlateColor); }
};

/// Nothing if it does not fit.
bool place(Plate& plate, ivec2 corner, ivec2 size) {
    const auto width = static_cast<float>(size.x), height = static_cast<float>(size.y);
    if (plate.size.x > width || plate.size.x * plate.size.y > kLargestShare * width * height) return false;
    plate.corner = {static_cast<float>(corner.x), static_cast<float>(corner.y) + height - plate.size.y};
    return true;
}

ImVec2 drawBar(Plate plate, const lab::PanePicture& picture, ivec2 corner, ivec2 size, const Theme& theme, float em) {
    const Display& display = picture.display;
    const std::string low = shortNumber(display.minimum), high = shortNumber(display.maximum);
    const float widest = std::max(4 * em, static_cast<float>(size.x) - 2 * plate.pad);
    const float width = std::min(14 * em, widest);
    const ImVec2 unit = theme.text->CalcTextSizeA(em, FLT_MAX, width, display.unit.c_str());
    const float barHeight = em * 0.7f, unitHeight = display.unit.empty() ? 0 : unit.y;
    plate.size = {std::max(width, unit.x) + 2 * plate.pad, unitHeight + barHeight + em + 3 * plate.pad};
    if (!place(plate, corner, size)) return {};
    plate.draw();
    ImDrawList& list = plate.list;
    const ImVec2 at(plate.corner.x + plate.pad, plate.corner.y + plate.pad);
    if (!display.unit.empty()) list.AddText(theme.text, em, at, kPlateText, display.unit.c_str(), nullptr, width);
    const float top = at.y + unitHeight + plate.pad / 2, step = width / kBarSteps;
    const look::Palette& palette = picture.kind == StageKind::count ? look::diverging() : look::viridis();
    for (int i = 0; i < kBarSteps; ++i)
        list.AddRectFilled({at.x + static_cast<float>(i) * step, top},
                           {at.x + static_cast<float>(i + 1) * step, top + barHeight},
                           shownColor(look::colorAt(palette, (i + 0.5) / kBarSteps)));
    const float below = top + barHeight + plate.pad / 4;
    const auto textWidth = [&](const std::string& text) {
        return theme.text->CalcTextSizeA(em, FLT_MAX, 0, text.c_str()).x;
    };
    list.AddText(theme.text, em, {at.x, below}, kPlateText, low.c_str());
    list.AddText(theme.text, em, {at.x + width - textWidth(high), below}, kPlateText, high.c_str());
    if (picture.kind == StageKind::count && display.minimum < 0 && display.maximum > 0) {
        const auto share = static_cast<float>(-display.minimum / (display.maximum - display.minimum));
        list.AddText(theme.text, em, {at.x + share * width - textWidth("0") / 2, below}, kPlateText, "0");
    }
    return plate.size;
}

ImVec2 drawKey(Plate plate, const std::vector<KeyEntry>& key, ivec2 corner, ivec2 size, const Theme& theme, float em) {
    const float swatch = em * 0.9f, between = em * 0.35f;
    const float widest = std::max(6 * em, static_cast<float>(size.x) - swatch - 3 * plate.pad);
    plate.size = {0, plate.pad};
    std::vector<ImVec2> sizes;
    for (const KeyEntry& entry : key) {
        sizes.push_back(theme.text->CalcTextSizeA(em, FLT_MAX, widest, entry.label.c_str()));
        plate.size.x = std::max(plate.size.x, sizes.back().x + swatch + 3 * plate.pad);
        plate.size.y += sizes.back().y + between;
    }
    plate.size.y += plate.pad - between;
    if (!place(plate, corner, size)) return {};
    plate.draw();
    float y = plate.corner.y + plate.pad;
    for (std::size_t i = 0; i < key.size(); ++i) {
        const ImVec2 at(plate.corner.x + plate.pad, y + (em - swatch) / 2);
        plate.list.AddRectFilled(at, {at.x + swatch, at.y + swatch}, shownColor(key[i].colorLinear));
        plate.list.AddText(theme.text, em, {at.x + swatch + plate.pad, y}, kPlateText, key[i].label.c_str(), nullptr,
                           widest);
        y += sizes[i].y + between;
    }
    return plate.size;
}

} // namespace

ImVec2 drawLegend(ImDrawList& list, const lab::PanePicture& picture, bool always, ivec2 corner, ivec2 size,
                  const Theme& theme) {
    if (!picture.texture && !always) return {};
    const float em = static_cast<float>(size.y) < kLowPaneEm * theme.em ? std::round(kSmaller * theme.em) : theme.em;
    const Plate plate{list, {}, {}, em * 0.5f};
    if (picture.kind == StageKind::scalar || picture.kind == StageKind::count)
        return drawBar(plate, picture, corner, size, theme, em);
    if (!picture.display.key.empty()) return drawKey(plate, picture.display.key, corner, size, theme, em);
    return {};
}

} // namespace shadowlab::window
