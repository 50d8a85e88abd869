// SPDX-License-Identifier: MIT
#include "app/window/panels/probe_card.h"

#include <algorithm>
#include <cmath>

#include "app/picture/pixel_verdict.h"
#include "techniques/probed/seen_point.h"

namespace shadowlab::window {

namespace {

constexpr float kWidestEm = 25;
constexpr float kMostOfWidth = 0.62f, kMostOfHeight = 0.33f; ///< of its pane: the picture has to be seen
constexpr float kLargePaneEm = 26;   ///< height of a pane that has room for more than one sum
constexpr std::size_t kMostSums = 5; ///< what can be read at a glance; the panel has the rest
constexpr float kRingEm = 1;         ///< around the pixel, with its strokes
constexpr float kMarginEm = 0.4f;    ///< to the pane's edges

/// One line of the card.
struct CardLine {
    std::string text;
    float size;
    ImU32 color;
};

/// "IN SHADOW of light left: ...": which light, where there are several.
std::string withLight(std::string sentence, const Probe& probe, const scene::Scene& scene) {
    const auto* const seen = probe.find<SeenPoint>();
    const std::size_t colon = sentence.find(':');
    if (!seen || seen->light < 0 || scene.lights.size() < 2 || colon == std::string::npos) return sentence;
    const std::string head = sentence.substr(0, colon);
    const char* const word = head.ends_with("LIT") ? " by light " : head.ends_with("AWAY") ? " from light " : " of light ";
    return sentence.insert(colon, word + scene.lights[static_cast<std::size_t>(seen->light)].name);
}

std::vector<CardLine> cardLines(const Probe& probe, const scene::Scene& scene, std::size_t mostSums, const Theme& theme) {
    const picture::PixelVerdict verdict = picture::pixelVerdict(probe);
    if (verdict.sentence.empty()) return {};
    const float small = theme.em * 0.88f;
    std::vector<CardLine> lines{{withLight(verdict.sentence, probe, scene), theme.em, verdict.isWrong ? kWarning : kAccent}};
    for (std::size_t i = 0; i < std::min(mostSums, verdict.sums.size()); ++i)
        lines.push_back({verdict.sums[i], small, kPlateText});
    if (mostSums > 1 && verdict.sums.size() > mostSums)
        lines.push_back({"I: all that is known", small, IM_COL32(170, 170, 175, 255)});
    return lines;
}

/// The lines under each other, wrapped at a width.
struct CardSize {
    ImVec2 size;
    std::vector<float> heights; ///< of the lines with the gap below them
};

CardSize cardSize(const std::vector<CardLine>& lines, float wrapWidth, const Theme& theme) {
    const float pad = theme.em * 0.5f;
    CardSize card{{0, pad * 1.6f}, {}};
    for (const CardLine& line : lines) {
        const ImVec2 extent = theme.text->CalcTextSizeA(line.size, FLT_MAX, wrapWidth, line.text.c_str());
        card.size.x = std::max(card.size.x, extent.x + 2 * pad);
        card.heights.push_back(extent.y + pad * 0.4f);
        card.size.y += card.heights.back();
    }
    return card;
}

ImVec2 nearestPoint(const PlaceBox& box, ImVec2 to) {
    return {std::clamp(to.x, box.low.x, box.high.x), std::clamp(to.y, box.low.y, box.high.y)};
}

float distanceTo(const PlaceBox& box, ImVec2 from) {
    const ImVec2 near = nearestPoint(box, from);
    return std::hypot(near.x - from.x, near.y - from.y);
}

/// Of the pane's corners the one in which it covers least and is farthest from the pixel.
PlaceBox cornerFor(ImVec2 size, ImVec2 ring, const ShownPane& shown, const FreePlaces& places, const Theme& theme) {
    const float margin = kMarginEm * theme.em;
    const ImVec2 low(static_cast<float>(shown.area.corner.x) + margin, static_cast<float>(shown.area.corner.y) + margin);
    const ImVec2 high(low.x + static_cast<float>(shown.area.size.x) - 2 * margin,
                      low.y + static_cast<float>(shown.area.size.y) - 2 * margin);
    const float diagonal = std::hypot(high.x - low.x, high.y - low.y);
    PlaceBox best;
    float least = FLT_MAX;
    for (const ImVec2 at : {ImVec2(low.x, high.y - size.y), ImVec2(high.x - size.x, high.y - size.y), low, ImVec2(high.x - size.x, low.y)}) {
        const PlaceBox box = places.within(at, size);
        const float away = distanceTo(box, ring);
        const float onRing = away < kRingEm * theme.em ? FreePlaces::kSign : 0;
        const float cost = places.cost(box) / (size.x * size.y) + onRing - away / diagonal; // all of them shares
        if (cost < least) {
            best = box;
            least = cost;
        }
    }
    return best;
}

} // namespace

void drawProbeCard(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const FreePlaces& places, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const lab::PickedPixel& known = ui.bench.pickedPixel();
    if (shown.pane != document.active || !document.picked || !known.askedFor.view.picked ||
        known.askedFor.state.technique != ui.bench.activeState().technique)
        return;
    const auto width = static_cast<float>(shown.area.size.x), height = static_cast<float>(shown.area.size.y);
    const float pad = theme.em * 0.5f;
    const float wrap = std::min(kWidestEm * theme.em, kMostOfWidth * width) - 2 * pad;
    const std::size_t mostSums = height < kLargePaneEm * theme.em ? 1 : kMostSums;
    std::vector<CardLine> lines = cardLines(known.probe, *ui.bench.shownScene(), mostSums, theme);
    if (lines.empty() || wrap < 5 * theme.em) return;
    CardSize card = cardSize(lines, wrap, theme);
    while (lines.size() > 1 && card.size.y > kMostOfHeight * height) { // the panel has them
        lines.pop_back();
        card = cardSize(lines, wrap, theme);
    }
    const ImVec2 ring = shown.at(*document.picked);
    const PlaceBox box = cornerFor(card.size, ring, shown, places, theme);
    const ImU32 color = lines.front().color;
    const float away = distanceTo(box, ring), reach = kRingEm * theme.em;
    if (away > reach && ui.bench.pane(shown.pane).showsTheEyesView()) {
        const ImVec2 from = nearestPoint(box, ring);
        const ImVec2 to(ring.x + (from.x - ring.x) * reach / away, ring.y + (from.y - ring.y) * reach / away);
        list.AddLine(from, to, IM_COL32(16, 16, 18, 255), 4);
        list.AddLine(from, to, color, 2);
    }
    list.AddRectFilled(box.low, box.high, kPlateColor, pad * 0.5f);
    list.AddRect(box.low, box.high, color, pad * 0.5f);
    float y = box.low.y + pad;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        list.AddText(theme.text, lines[i].size, {box.low.x + pad, y}, lines[i].color, lines[i].text.c_str(), nullptr, wrap);
        y += card.heights[i];
    }
}

} // namespace shadowlab::window
