// SPDX-License-Identifier: MIT
#include "app/window/panels/probe_card.h"

#include <algorithm>
#include <array>

#include "app/picture/pixel_verdict.h"
#include "app/window/line_breaks.h"
#include "app/window/panels/card_place.h"
#include "app/window/picture_view.h"
#include "techniques/probed/seen_point.h"

namespace shadowlab::window {

namespace {

constexpr std::array kWidthsEm = {25.0f, 18.0f, 13.0f, 9.0f, 7.0f};
constexpr float kMostOfWidth = 0.62f, kMostOfHeight = 0.33f; ///< of its pane: the picture has to be seen
constexpr float kVerdictOfHeight = 0.6f;                      ///< of a low pane, for the verdict alone
constexpr float kLargePaneEm = 26;   ///< height of a pane that has room for more than one sum
constexpr std::size_t kMostSums = 5; ///< what can be read at a glance; the panel has the rest
constexpr float kRingEm = 1;         ///< around the pixel, with its strokes
constexpr float kKeepFreeEm = 1.6f;  ///< around the pixel, for the ring and what it is about
constexpr float kGapEm = 0.2f;       ///< below each sentence
constexpr float kLeastWidthEm = 5;   ///< of its text

/// "IN SHADOW of light left: ...": which light, where there are several.
std::string withLight(std::string sentence, const Probe& probe, const scene::Scene& scene) {
    const auto* const seen = probe.find<SeenPoint>();
    const std::size_t colon = sentence.find(':');
    if (!seen || seen->light < 0 || scene.lights.size() < 2 || colon == std::string::npos) return sentence;
    const std::string head = sentence.substr(0, colon);
    const char* const word = head.ends_with("LIT") ? " by light " : head.ends_with("AWAY") ? " from light " : " of light ";
    return sentence.insert(colon, word + scene.lights[static_cast<std::size_t>(seen->light)].name);
}

/// The sentences of the card, the verdict first, unbroken.
std::vector<CardLine> sentencesOf(const Probe& probe, const scene::Scene& scene, std::size_t mostSums, const Theme& theme) {
    const picture::PixelVerdict verdict = picture::pixelVerdict(probe);
    if (verdict.sentence.empty()) return {};
    const float small = theme.em * 0.88f;
    std::vector<CardLine> all{{withLight(verdict.sentence, probe, scene), theme.em, verdict.isWrong ? kWarning : kAccent}};
    for (std::size_t i = 0; i < std::min(mostSums, verdict.sums.size()); ++i)
        all.push_back({verdict.sums[i], small, kPlateText});
    if (mostSums > 1 && verdict.sums.size() > mostSums)
        all.push_back({"I: all that is known", small, IM_COL32(170, 170, 175, 255)});
    return all;
}

/// The first sentences, broken for a width.
struct BrokenCard {
    std::vector<CardLine> lines;
    CardShape shape;
};

float padOf(const Theme& theme) { return theme.em * 0.5f; }
/// From the top of a line to that of the next.
float advance(const CardLine& line, const Theme& theme) { return line.size + (line.endsSentence ? kGapEm * theme.em : 0); }

BrokenCard brokenCard(const std::vector<CardLine>& sentences, std::size_t count, float wrapWidth, const Theme& theme) {
    const float pad = padOf(theme);
    BrokenCard card{{}, {{0, pad * 1.6f}, count}};
    for (std::size_t i = 0; i < count; ++i) {
        const CardLine& sentence = sentences[i];
        const auto pixelsOf = [&](const std::string& text) {
            return theme.text->CalcTextSizeA(sentence.size, FLT_MAX, 0, text.c_str()).x;
        };
        std::vector<std::string> broken = brokenText(sentence.text, wrapWidth, pixelsOf);
        for (std::size_t line = 0; line < broken.size(); ++line) {
            card.shape.size.x = std::max(card.shape.size.x, pixelsOf(broken[line]) + 2 * pad);
            card.lines.push_back({std::move(broken[line]), sentence.size, sentence.color, line + 1 == broken.size()});
            card.shape.size.y += advance(card.lines.back(), theme);
        }
    }
    return card;
}

/// All ways to break it that are not too large for the pane: those with more sentences first, of these the wide ones.
std::vector<BrokenCard> brokenCards(const std::vector<CardLine>& sentences, ImVec2 pane, const Theme& theme) {
    std::vector<BrokenCard> cards;
    for (std::size_t count = sentences.size(); count > 0; --count)
        for (const float em : kWidthsEm) {
            const float width = std::min(em * theme.em, kMostOfWidth * pane.x) - 2 * padOf(theme);
            if (width < kLeastWidthEm * theme.em) break;
            BrokenCard card = brokenCard(sentences, count, width, theme);
            const float most = (count > 1 ? kMostOfHeight : kVerdictOfHeight) * pane.y;
            if (card.shape.size.y <= most || (count == 1 && cards.empty())) cards.push_back(std::move(card)); // a verdict there always is
        }
    return cards;
}

} // namespace

std::optional<ProbeCard> probeCard(const WindowState& ui, const ShownPane& shown, const FreePlaces& places, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const lab::PickedPixel& known = ui.bench.pickedPixel();
    const lab::Pane& pane = ui.bench.pane(shown.pane);
    if (shown.pane != document.active || !document.picked || !known.askedFor.view.picked || pane.showsAnother() ||
        !pane.failure().empty() || known.askedFor.state.technique != ui.bench.activeState().technique)
        return {};
    const std::optional<ImVec2> ring = pickedPlace(ui, shown);
    if (!ring) return {};
    const auto width = static_cast<float>(shown.area.size.x), height = static_cast<float>(shown.area.size.y);
    const std::size_t mostSums = height < kLargePaneEm * theme.em ? 1 : kMostSums;
    std::vector<BrokenCard> cards =
        brokenCards(sentencesOf(known.probe, *ui.bench.shownScene(), mostSums, theme), {width, height}, theme);
    std::vector<CardShape> shapes;
    for (const BrokenCard& card : cards)
        shapes.push_back(card.shape);
    const std::optional<CardPlace> place = freestPlace(shapes, *ring, kKeepFreeEm * theme.em, places, theme);
    if (!place) return {};
    return ProbeCard{std::move(cards[place->shape].lines), place->box, *ring};
}

void drawProbeCard(ImDrawList& list, const ProbeCard& card, const Theme& theme) {
    const float pad = padOf(theme), away = card.box.distance(card.ring), reach = kRingEm * theme.em;
    const ImU32 color = card.lines.front().color;
    if (away > reach) {
        const ImVec2 from = card.box.nearest(card.ring);
        const ImVec2 to(card.ring.x + (from.x - card.ring.x) * reach / away, card.ring.y + (from.y - card.ring.y) * reach / away);
        list.AddLine(from, to, IM_COL32(16, 16, 18, 255), 4);
        list.AddLine(from, to, color, 2);
    }
    list.AddRectFilled(card.box.low, card.box.high, kPlateColor, pad * 0.5f);
    list.AddRect(card.box.low, card.box.high, color, pad * 0.5f);
    float y = card.box.low.y + pad;
    for (const CardLine& line : card.lines) {
        list.AddText(theme.text, line.size, {card.box.low.x + pad, y}, line.color, line.text.c_str());
        y += advance(line, theme);
    }
}

} // namespace shadowlab::window
