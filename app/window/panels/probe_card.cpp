// SPDX-License-Identifier: MIT
#include "app/window/panels/probe_card.h"

#include <algorithm>
#include <cmath>

#include "app/picture/pixel_verdict.h"

namespace shadowlab::window {

namespace {

constexpr float kWidestEm = 25, kFromRingEm = 1.4f;
constexpr float kMostOfPane = 0.33f; ///< of its height, that a card with sums may have
constexpr std::size_t kMostSums = 5; ///< what can be read at a glance; the panel has the rest

/// One line of the card.
struct CardLine {
    std::string text;
    ImFont* font;
    float size;
    ImU32 color;
};

std::vector<CardLine> cardLines(const Probe& probe, const Theme& theme) {
    const picture::PixelVerdict verdict = picture::pixelVerdict(probe);
    if (verdict.sentence.empty()) return {};
    std::vector<CardLine> lines{{verdict.sentence, theme.text, theme.em, verdict.isWrong ? kWarning : kAccent}};
    for (std::size_t i = 0; i < std::min(kMostSums, verdict.sums.size()); ++i)
        lines.push_back({verdict.sums[i], theme.text, theme.em * 0.88f, kPlateText});
    if (verdict.sums.size() > kMostSums) lines.push_back({"I: all that is known", theme.text, theme.em * 0.88f, IM_COL32(170, 170, 175, 255)});
    return lines;
}

} // namespace

void drawProbeCard(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const lab::PickedPixel& known = ui.bench.pickedPixel();
    if (shown.pane != document.active || !document.picked || !known.askedFor.view.picked ||
        known.askedFor.state.technique != ui.bench.activeState().technique)
        return;
    std::vector<CardLine> lines = cardLines(known.probe, theme);
    const float pad = theme.em * 0.5f;
    const float room = std::min(kWidestEm * theme.em, static_cast<float>(shown.area.size.x) - 2 * pad);
    if (lines.empty() || room < 6 * theme.em) return;
    ImVec2 size(0, pad);
    std::vector<float> heights;
    for (const CardLine& line : lines) {
        const ImVec2 extent = line.font->CalcTextSizeA(line.size, FLT_MAX, room - 2 * pad, line.text.c_str());
        size.x = std::max(size.x, extent.x + 2 * pad);
        size.y += extent.y + pad * 0.4f;
        heights.push_back(extent.y + pad * 0.4f);
    }
    size.y += pad * 0.6f;
    // In a small pane the sums go: the picture has to be seen, and the panel has them.
    const float mostHeight = kMostOfPane * static_cast<float>(shown.area.size.y);
    for (; lines.size() > 1 && size.y > mostHeight; lines.pop_back(), heights.pop_back())
        size.y -= heights.back();
    const ImVec2 ring = shown.at(*document.picked);
    const float away = kFromRingEm * theme.em, left = static_cast<float>(shown.area.corner.x),
                top = static_cast<float>(shown.area.corner.y), right = left + static_cast<float>(shown.area.size.x),
                bottom = top + static_cast<float>(shown.area.size.y);
    // To the right of the pixel or to its left; where neither has room, below or above it.
    ImVec2 at(ring.x + away, ring.y - size.y / 2);
    if (at.x + size.x > right) at.x = ring.x - away - size.x;
    if (at.x < left)
        at = {ring.x - size.x / 2, ring.y + away + size.y > bottom ? ring.y - away - size.y : ring.y + away};
    at.x = std::round(std::clamp(at.x, left, std::max(left, right - size.x)));
    at.y = std::round(std::clamp(at.y, top, std::max(top, bottom - size.y)));
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kPlateColor, pad * 0.5f);
    list.AddRect(at, {at.x + size.x, at.y + size.y}, lines.front().color, pad * 0.5f);
    float y = at.y + pad;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        list.AddText(lines[i].font, lines[i].size, {at.x + pad, y}, lines[i].color, lines[i].text.c_str(), nullptr,
                     room - 2 * pad);
        y += heights[i];
    }
}

} // namespace shadowlab::window
